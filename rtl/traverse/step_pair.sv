// SPDX-License-Identifier: Apache-2.0
// Two decisions a cycle: a step for the even contexts and one for the odd. Nodes, leaves and new
// rays come one of each a cycle; a node visited brings a decision, and so does a leaf, a new ray, a
// frame that is dropped: one step alone would be busier than the node pipe. New rays go last; each
// step has a place where one waits, so that a ray enters its context early.
// Ports as of step; outputs are one for each step.
// Model: cpp_model/traverse/step.hpp, equal bit for bit.
module step_pair
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts   = DefaultContexts,
  parameter int unsigned StackDepth = StackFrames
) (
  input  logic       clk_i,
  input  logic       rst_ni,
  input  steps_t     limit_i,

  input  logic       start_valid_i,
  output logic       start_ready_o,
  input  ctx_t       start_ctx_i,
  input  start_t     start_i,

  input  logic       node_valid_i,
  input  ctx_t       node_ctx_i,
  input  visits_t    node_i,

  input  logic       leaf_valid_i,
  input  ctx_t       leaf_ctx_i,

  output ctx_t       ask_ctx_o [2],
  input  dist_t      reach_i [2],
  input  logic [1:0] stop_i,

  output ctx_t       out_ctx_o [2],
  output logic [1:0] node_valid_o,
  output logic [1:0] leaf_valid_o,
  output ref_t       out_ref_o [2],
  output logic [1:0] done_valid_o,
  output error_t     fault_o,

  input  ctx_t       count_ctx_i,
  output steps_t     count_o
);
  typedef struct packed {
    ctx_t   ctx;
    start_t start;
  } fresh_t;
  logic [1:0] start_ready;
  error_t     fault [2];
  steps_t     count [2];

  for (genvar i = 0; i < 2; i++) begin : g_step
    ctx_t   ask, out;
    logic   fresh_valid, fresh_ready;
    fresh_t fresh;
    pipe_stage #(.data_t(fresh_t)) u_fresh (
      .clk_i, .rst_ni,
      .valid_i(start_valid_i && start_ctx_i[0] == i[0]), .ready_o(start_ready[i]),
      .data_i('{ctx: start_ctx_i >> 1, start: start_i}),
      .valid_o(fresh_valid), .ready_i(fresh_ready), .data_o(fresh)
    );
    step #(.Contexts((Contexts + 1) / 2), .StackDepth(StackDepth)) u_step (
      .clk_i, .rst_ni, .limit_i,
      .start_valid_i(fresh_valid), .start_ready_o(fresh_ready),
      .start_ctx_i(fresh.ctx), .start_i(fresh.start),
      .node_valid_i(node_valid_i && node_ctx_i[0] == i[0]), .node_ctx_i(node_ctx_i >> 1), .node_i,
      .leaf_valid_i(leaf_valid_i && leaf_ctx_i[0] == i[0]), .leaf_ctx_i(leaf_ctx_i >> 1),
      .ask_ctx_o(ask), .reach_i(reach_i[i]), .stop_i(stop_i[i]),
      .out_ctx_o(out), .node_valid_o(node_valid_o[i]), .leaf_valid_o(leaf_valid_o[i]), .out_ref_o(out_ref_o[i]),
      .done_valid_o(done_valid_o[i]), .fault_o(fault[i]),
      .count_ctx_i(count_ctx_i >> 1), .count_o(count[i])
    );
    assign ask_ctx_o[i] = {ask[CtxW-2:0], i[0]};
    assign out_ctx_o[i] = {out[CtxW-2:0], i[0]};
  end

  assign start_ready_o = start_ready[start_ctx_i[0]];
  assign count_o       = count[count_ctx_i[0]];
  assign fault_o       = (fault[0] != ErrNone) ? fault[0] : fault[1];
endmodule
