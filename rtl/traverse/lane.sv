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
  localparam int unsigned IdxW = (Contexts > 1) ? $clog2(Contexts) : 1;

  // ---- Contexts ----
  ctx_t free_ctx, out_ctx;
  logic ray_taken, tests_ready, out_valid;

  assign ray_ready_o = fill_i && !full_o && tests_ready;
  assign ray_taken   = ray_valid_i && ray_ready_o;
  assign hit_valid_o = emit_i && out_valid;

  contexts #(.Contexts(Contexts)) u_contexts (
    .clk_i, .rst_ni, .hierarchy_i(1'b0),
    .free_ctx_o(free_ctx), .take_i(ray_taken), .done_valid_i(1'b0), .done_ctx_i('0),
    .out_valid_o(out_valid), .out_ctx_o(out_ctx), .out_taken_i(hit_valid_o && hit_ready_i),
    .used_o, .full_o, .empty_o
  );

  // ---- The rays, and what each unit reads of them ----
  test_ray_t       test_ray;
  logic            look_valid;
  prim_t           look_ignore;
  hit_ray_t        hit_ray;
  logic [IdxW-1:0] hit_ctx;

  ray_store #(.Contexts(Contexts)) u_rays (
    .clk_i,
    .write_i(ray_taken), .write_ctx_i(IdxW'(free_ctx)), .ray_i,
    .test_ctx_i(IdxW'(test_ctx_i)), .test_ray_o(test_ray),
    .look_ctx_i(IdxW'(test_ctx_i)), .look_valid_o(look_valid), .look_ignore_o(look_ignore),
    .node_ctx_i('0), .node_ray_o(), .step_ctx_i('0), .step_any_hit_o(),
    .hit_ctx_i(hit_ctx), .hit_ray_o(hit_ray),
    .out_ctx_i(IdxW'(out_ctx)), .out_tag_o(hit_o.tag), .out_sx_o(hit_o.sx), .out_sy_o(hit_o.sy),
    .out_axis_o(hit_o.axis), .out_neg_o(hit_o.neg)
  );

  // ---- Tests ----
  result_t best;
  assign test_o = test_valid_i && test_step_i && {1'b0, test_ctx_i} < used_o && look_valid
                  && test_prim_i.number != look_ignore;

  prim_tests #(.Contexts(Contexts)) u_tests (
    .clk_i, .rst_ni,
    .start_i(ray_taken), .start_ready_o(tests_ready), .start_ctx_i(IdxW'(free_ctx)), .tmax_i(ray_i.tmax),
    .test_valid_i(test_o), .test_ready_o, .test_ctx_i, .test_ray_i(test_ray), .test_prim_i,
    .hit_ctx_o(hit_ctx), .hit_ray_i(hit_ray),
    .over_o(), .over_ctx_o(), .idle_o(quiet_o), .cand_o,
    .node_ctx_i('0), .node_t_o(), .step_ctx_i('0), .step_reach_o(), .step_found_o(),
    .out_ctx_i(IdxW'(out_ctx)), .out_found_o(hit_o.found), .out_o(best), .out_tests_o()
  );
  assign hit_o.kind   = best.kind;
  assign hit_o.number = best.number;
  assign hit_o.t      = best.t;
  assign hit_o.u      = best.u;
  assign hit_o.v      = best.v;
endmodule
