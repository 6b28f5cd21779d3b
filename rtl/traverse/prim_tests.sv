// SPDX-License-Identifier: Apache-2.0
// From tests to nearest hits: what the exact test accepts waits in a queue for the hit unit that the
// lanes share (cand_o), and its results go to the nearest-hit memory. Nothing stalls once a test has
// entered: it enters only when the queue has a place for it.
//
//   test -> ray_prim --accepted--> queue -> (hit unit) --beyond tmin--> nearest
//                \--> over_o[0]                   \--> over_o[1]
//
// One test a cycle. over_o: a test of over_ctx_o is over: its result can be read from the next cycle on, u and
// v of it from the one behind that.
// Model: cpp_model/traverse/prim_tests.hpp, equal bit for bit.
module prim_tests
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  localparam int unsigned IdxW    = (Contexts > 1) ? $clog2(Contexts) : 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  input  logic            start_i,         // a new ray; only while start_ready_o
  output logic            start_ready_o,
  input  logic [IdxW-1:0] start_ctx_i,
  input  t_t              tmax_i,

  input  logic            test_valid_i,    // only while test_ready_o
  output logic            test_ready_o,
  input  ctx_t            test_ctx_i,
  input  test_ray_t       test_ray_i,
  input  prim_slot_t      test_prim_i,

  output logic            cand_valid_o,    // to the hit unit
  input  logic            cand_ready_i,
  output cand_t           cand_o,
  input  logic            hit_over_i,      // a candidate is over
  input  logic            result_valid_i,  // and this is its result
  input  result_t         result_i,        // its context either way

  output logic [1:0]      over_o,
  output ctx_t            over_ctx_o [2],
  output logic            idle_o,          // no test or division is under way
  output logic            accept_o,        // an accepted test: counter event

  input  logic [IdxW-1:0] node_ctx_i,      // for the node pipe: the nearest t
  output t_t              node_t_o,
  input  logic [IdxW-1:0] step_ctx_i [2],  // for the next steps
  output dist_t           step_reach_o [2],
  output logic [1:0]      step_found_o,
  input  logic [IdxW-1:0] out_ctx_i,       // for the lane's output
  output logic            out_found_o,
  output result_t         out_o,
  output tests_t          out_tests_o
);
  // Covers the primitive pipe, so that one test a cycle can enter while nothing is accepted.
  localparam int unsigned QueueDepth = 32;

  // ---- The exact test ----
  logic  miss, cand_valid;
  cand_t cand;

  ray_prim u_ray_prim (
    .clk_i, .rst_ni,
    .in_valid_i(test_valid_i), .in_ctx_i(test_ctx_i), .in_ray_i(test_ray_i), .in_prim_i(test_prim_i),
    .out_valid_o(cand_valid), .out_o(cand), .retire_o(miss)
  );
  assign accept_o = cand_valid;

  // ---- What it accepted waits for the hit unit ----
  logic queue_pop, tests_idle, hits_idle;

  stream_fifo #(.data_t(cand_t), .Depth(QueueDepth)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(cand_valid), .ready_o(), .data_i(cand),
    .valid_o(cand_valid_o), .ready_i(cand_ready_i), .data_o(cand_o), .used_o()
  );
  assign queue_pop = cand_valid_o && cand_ready_i;

  credit #(.Limit(QueueDepth), .Gives(2)) u_tests (
    .clk_i, .rst_ni,
    .take_i(test_valid_i), .give_i({queue_pop, miss}),
    .available_o(test_ready_o), .idle_o(tests_idle)
  );
  credit #(.Limit((1 << HitPlaceW) - 1)) u_hits (   // in the hit unit: no more than its places
    .clk_i, .rst_ni, .take_i(queue_pop), .give_i(hit_over_i), .available_o(), .idle_o(hits_idle)
  );

  // ---- The nearest hit ----
  assign idle_o     = tests_idle && hits_idle;
  assign over_o     = {hit_over_i, miss};
  assign over_ctx_o = '{cand.ctx, result_i.ctx};

  nearest #(.Contexts(Contexts)) u_nearest (
    .clk_i,
    .start_i, .start_ctx_i, .tmax_i,
    .result_valid_i, .result_i,
    .node_ctx_i, .node_t_o, .step_ctx_i, .step_reach_o, .step_found_o,
    .out_ctx_i, .out_found_o, .out_o
  );

  // ---- Tests of each ray ----
  tests_t              tests_q [Contexts];
  logic [Contexts-1:0] none_q;      // not tested yet
  logic [IdxW-1:0]     test_ctx;
  assign test_ctx      = IdxW'(test_ctx_i);
  assign start_ready_o = !result_valid_i;
  assign out_tests_o   = none_q[out_ctx_i] ? '0 : tests_q[out_ctx_i];
  always_ff @(posedge clk_i) begin
    if (start_i) none_q[start_ctx_i] <= 1'b1;
    if (test_valid_i) begin
      none_q[test_ctx]  <= 1'b0;
      tests_q[test_ctx] <= (none_q[test_ctx] ? '0 : tests_q[test_ctx]) + 1'b1;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (test_ready_o || cand_valid_o) else $error("ray_prim alone holds as many tests as the queue");
  end
`endif
endmodule
