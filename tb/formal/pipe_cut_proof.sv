// SPDX-License-Identifier: Apache-2.0
// prim/pipe_cut: two places, and ready says only whether the spare one is free.
// Prove: k=1
// Cover: 8
// Fast
module pipe_cut_proof #(
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
  pipe_cut #(.data_t(data_t)) u_dut (.*);
  reset_first u_reset (.*);
  stream_held #(.data_t(data_t)) u_out (.clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i(data_o));

  logic [1:0] inner, ahead;
  logic       follows;
  data_t      item;
  stream_follow #(.data_t(data_t), .Most(2)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(valid_i && ready_o), .in_i(data_i),
    .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(data_o),
    .inside_o(inner), .follows_o(follows), .ahead_o(ahead), .item_o(item)
  );
  always_comb begin
    if (rst_ni) begin
      nothing_lost: assert (valid_o == (inner != '0));
      takes_while_room: assert (ready_o == (inner != 2'd2));
      if (follows && ahead == 2'd1) inv_spare: assert (u_dut.spare_q == item);
      c_full: cover (inner == 2'd2 && valid_i);
      c_second_leaves: cover (follows && ahead == '0 && inner == 2'd2 && ready_i);
    end
  end
endmodule
