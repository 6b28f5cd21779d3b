// SPDX-License-Identifier: Apache-2.0
// A lane: a stream of rays in, a stream of hits out. Its rays in flight are contexts, numbered
// places in small memories; tests name a context and meet its ray at the head of the primitive
// pipe. What the exact test accepts waits in a queue for the one hit unit, and the results for the
// nearest-hit memory. The pipe never stalls: a test enters only when the queue has a place for it.
//
//   ray -> ray_store --test(ctx, primitive)--> ray_prim -> queue -> hit_unit -> nearest -> hit
//
// One test a cycle; an accepted one takes the divider two. Contexts are given out in order and
// freed when their hits leave.
// Model: cpp_model/traverse/lane.hpp, equal bit for bit.
module lane
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts
) (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  logic        fill_i,         // rays may enter
  input  logic        ray_valid_i,
  output logic        ray_ready_o,
  input  ray_t        ray_i,

  input  logic        test_valid_i,
  output logic        test_ready_o,
  input  logic        test_step_i,    // the test is taken by all lanes
  input  ctx_t        test_ctx_i,
  input  prim_slot_t  test_prim_i,

  input  logic        emit_i,         // hits may leave
  output logic        hit_valid_o,
  input  logic        hit_ready_i,
  output hit_t        hit_o,

  output logic [CtxW:0] used_o,
  output logic        full_o,
  output logic        empty_o,
  output logic        quiet_o,
  output logic        test_o,         // counter events
  output logic        cand_o
);
  if (Contexts < 1 || Contexts > 2 ** CtxW) begin : g_check
    $error("lane: Contexts must be 1 to %0d", 2 ** CtxW);
  end

  localparam int unsigned IdxW = (Contexts > 1) ? $clog2(Contexts) : 1;
  // Covers the primitive pipe, so that one test a cycle can enter while nothing is accepted.
  localparam int unsigned QueueDepth = 32;

  // ---- Contexts: used_q rays are held in contexts 0 and up; out_q hits have left ----
  logic [CtxW:0] used_q, out_q;
  logic          ray_taken, hit_taken, last_out;

  assign used_o      = used_q;
  assign full_o      = used_q == (CtxW+1)'(Contexts);
  assign empty_o     = used_q == '0;
  assign ray_ready_o = fill_i && !full_o && !result_valid;
  assign ray_taken   = ray_valid_i && ray_ready_o;
  assign hit_valid_o = emit_i && !empty_o;
  assign hit_taken   = hit_valid_o && hit_ready_i;
  assign last_out    = out_q + 1'b1 == used_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      used_q <= '0;
      out_q  <= '0;
    end else if (ray_taken) begin
      used_q <= used_q + 1'b1;
    end else if (hit_taken) begin
      out_q <= last_out ? '0 : out_q + 1'b1;
      if (last_out) used_q <= '0;
    end
  end

  // ---- The rays, and what each unit reads of them ----
  test_ray_t test_ray;
  logic      test_ray_valid;
  prim_t     test_ignore;
  hit_ray_t  hit_ray;
  cand_t     queue_head;

  ray_store #(.Contexts(Contexts)) u_rays (
    .clk_i,
    .write_i(ray_taken), .write_ctx_i(IdxW'(used_q)), .ray_i,
    .test_ctx_i(IdxW'(test_ctx_i)), .test_ray_o(test_ray), .test_valid_o(test_ray_valid),
    .test_ignore_o(test_ignore),
    .hit_ctx_i(IdxW'(queue_head.ctx)), .hit_ray_o(hit_ray),
    .out_ctx_i(IdxW'(out_q)), .out_tag_o(hit_o.tag), .out_sx_o(hit_o.sx), .out_sy_o(hit_o.sy),
    .out_axis_o(hit_o.axis), .out_neg_o(hit_o.neg)
  );

  // ---- Tests ----
  logic  test_enter, test_retire, cand_valid;
  cand_t cand;

  assign test_enter = test_valid_i && test_step_i && {1'b0, test_ctx_i} < used_q && test_ray_valid
                      && test_prim_i.number != test_ignore;
  assign test_o     = test_enter;
  assign cand_o     = cand_valid;

  ray_prim u_ray_prim (
    .clk_i, .rst_ni,
    .in_valid_i(test_enter), .in_ctx_i(test_ctx_i), .in_ray_i(test_ray), .in_prim_i(test_prim_i),
    .out_valid_o(cand_valid), .out_o(cand), .retire_o(test_retire)
  );

  // ---- Candidates wait for the hit unit ----
  logic queue_valid, queue_take, queue_pop, tests_idle;

  stream_fifo #(.data_t(cand_t), .Depth(QueueDepth)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(cand_valid), .ready_o(), .data_i(cand),
    .valid_o(queue_valid), .ready_i(queue_take), .data_o(queue_head), .used_o()
  );
  assign queue_pop = queue_valid && queue_take;

  credit #(.Limit(QueueDepth), .Gives(2)) u_tests (
    .clk_i, .rst_ni,
    .take_i(test_enter), .give_i({queue_pop, test_retire}),
    .available_o(test_ready_o), .idle_o(tests_idle)
  );

  // ---- Division and the nearest hit ----
  logic    result_valid, hit_retire, hits_idle;
  result_t result, best;

  hit_unit u_hit_unit (
    .clk_i, .rst_ni,
    .in_valid_i(queue_valid), .in_ready_o(queue_take), .in_i(queue_head), .in_ray_i(hit_ray),
    .out_valid_o(result_valid), .out_o(result), .retire_o(hit_retire)
  );

  credit #(.Limit(255)) u_hits (
    .clk_i, .rst_ni,
    .take_i(queue_pop), .give_i(hit_retire), .available_o(), .idle_o(hits_idle)
  );
  assign quiet_o = tests_idle && hits_idle;

  nearest #(.Contexts(Contexts)) u_nearest (
    .clk_i,
    .start_i(ray_taken), .start_ctx_i(IdxW'(used_q)), .tmax_i(ray_i.tmax),
    .result_valid_i(result_valid), .result_i(result),
    .out_ctx_i(IdxW'(out_q)), .out_found_o(hit_o.found), .out_o(best)
  );
  assign hit_o.kind   = best.kind;
  assign hit_o.number = best.number;
  assign hit_o.t      = best.t;
  assign hit_o.u      = best.u;
  assign hit_o.v      = best.v;
endmodule
