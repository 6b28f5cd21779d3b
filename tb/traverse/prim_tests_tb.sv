// SPDX-License-Identifier: Apache-2.0
// prim_tests with a hit unit of its own, which takes nothing while it is closed.
module prim_tests_tb
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  localparam int unsigned IdxW    = (Contexts > 1) ? $clog2(Contexts) : 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  input  logic            start_i,
  output logic            start_ready_o,
  input  logic [IdxW-1:0] start_ctx_i,
  input  t_t              tmax_i,

  input  logic            test_valid_i,
  output logic            test_ready_o,
  input  ctx_t            test_ctx_i,
  input  test_ray_t       test_ray_i,
  input  prim_slot_t      test_prim_i,

  input  logic            open_i,
  output logic [IdxW-1:0] hit_ctx_o,       // the ray that the hit unit needs
  input  hit_ray_t        hit_ray_i,

  output logic [1:0]      over_o,
  output ctx_t            over_ctx_o [2],
  output logic            idle_o,
  output logic            accept_o,

  input  logic [IdxW-1:0] node_ctx_i,
  output t_t              node_t_o,
  input  logic [IdxW-1:0] step_ctx_i [2],
  output dist_t           step_reach_o [2],
  output logic [1:0]      step_found_o,
  input  logic [IdxW-1:0] out_ctx_i,
  output logic            out_found_o,
  output result_t         out_o,
  output tests_t          out_tests_o
);
  logic     cand_valid, cand_ready, hit_over, result_valid;
  cand_t    cand [1];
  hit_ray_t cand_ray [1];
  result_t  result;
  assign hit_ctx_o   = IdxW'(cand[0].ctx);
  assign cand_ray[0] = hit_ray_i;
  shared_hits #(.Lanes(1)) u_hits (
    .clk_i, .rst_ni,
    .cand_valid_i(cand_valid && open_i), .cand_ready_o(cand_ready), .cand_i(cand), .ray_i(cand_ray),
    .over_o(hit_over), .result_valid_o(result_valid), .result_o(result), .busy_o()
  );

  prim_tests #(.Contexts(Contexts)) u_prim_tests (
    .cand_valid_o(cand_valid), .cand_ready_i(cand_ready && open_i), .cand_o(cand[0]), .hit_over_i(hit_over),
    .result_valid_i(result_valid), .result_i(result),
    .clk_i, .rst_ni, .start_i, .start_ready_o, .start_ctx_i, .tmax_i, .test_valid_i, .test_ready_o, .test_ctx_i,
    .test_ray_i, .test_prim_i, .over_o, .over_ctx_o, .idle_o, .accept_o, .node_ctx_i, .node_t_o, .step_ctx_i,
    .step_reach_o, .step_found_o, .out_ctx_i, .out_found_o, .out_o, .out_tests_o
  );
endmodule
