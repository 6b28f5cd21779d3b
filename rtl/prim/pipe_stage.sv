// SPDX-License-Identifier: Apache-2.0
// One register of a stream. An empty stage takes an item even while its output is blocked, so
// bubbles close up. ready is combinational from output to input; payload moves only with valid.
module pipe_stage #(
  parameter type data_t = logic [31:0]
) (
  input  logic  clk_i,
  input  logic  rst_ni,

  input  logic  valid_i,
  output logic  ready_o,
  input  data_t data_i,

  output logic  valid_o,
  input  logic  ready_i,
  output data_t data_o
);
  logic  valid_q;
  data_t data_q;

  assign ready_o = !valid_q || ready_i;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (ready_o) valid_q <= valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (ready_o && valid_i) data_q <= data_i;
  end

`ifndef SYNTHESIS
  stream_check #(.data_t(data_t)) u_check_out (
    .clk_i, .rst_ni, .valid_i(valid_o), .ready_i(ready_i), .data_i(data_o)
  );
`endif
endmodule
