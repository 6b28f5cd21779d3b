// SPDX-License-Identifier: Apache-2.0
// The one hit unit of all lanes: their accepted tests take turns, results go back to where the test came from.
// A lane's candidates are one in several cycles, so one unit that takes one a cycle is enough for some six of
// them. over_o[i]: a candidate of lane i is over; result_valid_o[i]: and its result is result_o.
module shared_hits
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Lanes = DefaultLanes
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic [Lanes-1:0] cand_valid_i,
  output logic [Lanes-1:0] cand_ready_o,
  input  cand_t            cand_i [Lanes],
  input  hit_ray_t         ray_i [Lanes],

  output logic [Lanes-1:0] over_o,
  output logic [Lanes-1:0] result_valid_o,
  output result_t          result_o,
  output logic             busy_o      // a candidate is at the hit unit: counter event
);
  localparam int unsigned IdxW = (Lanes > 1) ? $clog2(Lanes) : 1;
  typedef struct packed {
    hit_ray_t ray;
    cand_t    cand;
  } offer_t;
  offer_t          offer [Lanes];
  offer_t          head;
  logic            head_valid, head_ready, over, result_valid;
  logic [IdxW-1:0] lane;
  lane_no_t        out_lane;

  assign busy_o = head_valid;
  for (genvar i = 0; i < Lanes; i++) begin : g_lane
    assign offer[i]          = '{ray: ray_i[i], cand: cand_i[i]};
    assign over_o[i]         = over && out_lane == lane_no_t'(i);
    assign result_valid_o[i] = result_valid && out_lane == lane_no_t'(i);
  end

  stream_arb #(.data_t(offer_t), .N(Lanes)) u_turn (
    .clk_i, .rst_ni,
    .valid_i(cand_valid_i), .ready_o(cand_ready_o), .data_i(offer),
    .valid_o(head_valid), .ready_i(head_ready), .data_o(head), .index_o(lane)
  );
  hit_unit u_hit_unit (
    .clk_i, .rst_ni,
    .in_valid_i(head_valid), .in_ready_o(head_ready), .in_i(head.cand), .in_ray_i(head.ray),
    .in_lane_i(lane_no_t'(lane)),
    .out_valid_o(result_valid), .out_o(result_o), .out_lane_o(out_lane), .retire_o(over)
  );
endmodule
