// SPDX-License-Identifier: Apache-2.0
// Gives each item of a stream to every one of N streams; the item is taken when all have it.
// Combinational payload; each output's valid falls once that output took the item.
module stream_fork #(
  parameter int unsigned N = 2
) (
  input  logic         clk_i,
  input  logic         rst_ni,

  input  logic         valid_i,
  output logic         ready_o,

  output logic [N-1:0] valid_o,
  input  logic [N-1:0] ready_i
);
  logic [N-1:0] has_q;  // outputs that took the item now offered

  assign valid_o = {N{valid_i}} & ~has_q;
  assign ready_o = &(has_q | ready_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) has_q <= '0;
    else if (valid_i) has_q <= ready_o ? '0 : (has_q | ready_i);
  end
endmodule
