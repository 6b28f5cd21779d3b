// SPDX-License-Identifier: Apache-2.0
// prim/pipe_stage: what it takes is offered the cycle after and until it is taken.
// Prove: k=1
// Cover: 5
module pipe_stage_proof #(
  parameter int unsigned Width = 8,
  localparam type        data_t = logic [Width-1:0]
) (
  input logic  clk_i,
  input logic  rst_ni,
  input logic  choose_i,
  input logic  valid_i,
  input data_t data_i,
  input logic  ready_i
);
  logic  ready_o, valid_o;
  data_t data_o;
  pipe_stage #(.data_t(data_t)) u_dut (.*);
  reset_first u_reset (.*);
  stream_held #(.data_t(data_t)) u_out (.clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i(data_o));

  logic [1:0] inner;
  stream_follow #(.data_t(data_t), .Most(1)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(valid_i && ready_o), .in_i(data_i),
    .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(data_o),
    .inside_o(inner), .follows_o(), .ahead_o(), .item_o()
  );
  always_comb begin
    if (rst_ni) begin
      nothing_lost: assert (valid_o || inner == '0);
      takes_when_empty: assert (ready_o == (inner == '0 || ready_i));
      c_full: cover (inner != '0 && !ready_i && valid_i);
      c_passes: cover (inner != '0 && ready_i && valid_i);
    end
  end
endmodule
