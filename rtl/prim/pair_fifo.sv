// SPDX-License-Identifier: Apache-2.0
// A queue with two ends to put items in: a stream_fifo of Depth places for each, taken from in turn.
// The order within one of the two is kept. ready_o of either does not depend on the other.
module pair_fifo #(
  parameter type         data_t = logic [31:0],
  parameter int unsigned Depth  = 8
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic [1:0] valid_i,
  output logic [1:0] ready_o,
  input  data_t      data_i [2],

  output logic       valid_o,
  input  logic       ready_i,
  output data_t      data_o
);
  logic [1:0] head_valid, head_ready;
  data_t      head [2];

  for (genvar i = 0; i < 2; i++) begin : g_fifo
    stream_fifo #(.data_t(data_t), .Depth(Depth)) u_fifo (
      .clk_i, .rst_ni, .used_o(),
      .valid_i(valid_i[i]), .ready_o(ready_o[i]), .data_i(data_i[i]),
      .valid_o(head_valid[i]), .ready_i(head_ready[i]), .data_o(head[i])
    );
  end

  stream_arb #(.data_t(data_t), .N(2)) u_arb (
    .clk_i, .rst_ni, .valid_i(head_valid), .ready_o(head_ready), .data_i(head),
    .valid_o, .ready_i, .data_o, .index_o()
  );
endmodule
