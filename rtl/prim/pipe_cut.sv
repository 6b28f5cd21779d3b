// SPDX-License-Identifier: Apache-2.0
// A stream register that cuts both paths: neither valid nor ready is combinational across it.
// Two places, one item a cycle, latency one.
module pipe_cut #(
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
  logic  main_valid_q, spare_valid_q;
  data_t main_q, spare_q;

  assign ready_o = !spare_valid_q;
  assign valid_o = main_valid_q;
  assign data_o  = main_q;

  logic take, move;  // an item enters; the main place is free after this cycle
  assign take = valid_i && ready_o;
  assign move = !main_valid_q || ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      main_valid_q  <= 1'b0;
      spare_valid_q <= 1'b0;
    end else if (move) begin
      main_valid_q  <= spare_valid_q || take;
      spare_valid_q <= 1'b0;
    end else if (take) begin
      spare_valid_q <= 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (move && spare_valid_q) main_q <= spare_q;
    else if (move && take) main_q <= data_i;
    if (!move && take) spare_q <= data_i;
  end

`ifndef SYNTHESIS
  stream_check #(.data_t(data_t)) u_check_out (
    .clk_i, .rst_ni, .valid_i(valid_o), .ready_i(ready_i), .data_i(data_o)
  );
`endif
endmodule
