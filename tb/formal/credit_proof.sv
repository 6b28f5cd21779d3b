// SPDX-License-Identifier: Apache-2.0
// prim/credit: its user takes only while available_o says so and gives back what is inside; then never more
// than Limit are, and both outputs say what is true.
// Prove: k=1 Limit=1 Gives=1
// Prove: k=1 Limit=6 Gives=3
// Prove: k=1 Limit=16 Gives=1
// Cover: 20
module credit_proof #(
  parameter int unsigned Limit = 6,
  parameter int unsigned Gives = 3
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             take_i,
  input logic [Gives-1:0] give_i
);
  localparam int unsigned CntW = $clog2(Limit + Gives + 2) + 1;
  logic available_o, idle_o;
  credit #(.Limit(Limit), .Gives(Gives)) u_dut (.*);
  reset_first u_reset (.*);

  logic [CntW-1:0] inside_q, leave;
  always_comb begin
    leave = '0;
    for (int unsigned i = 0; i < Gives; i++) leave = leave + CntW'(give_i[i]);
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) inside_q <= '0;
    else inside_q <= inside_q + CntW'(take_i) - leave;
  end
  always_comb begin
    if (rst_ni) begin
      takes_what_is_available: assume (!take_i || available_o);
      gives_what_is_inside: assume (leave <= inside_q + CntW'(take_i));
      never_more_than_promised: assert (inside_q <= CntW'(Limit));
      available_while_fewer: assert (available_o == (inside_q < CntW'(Limit)));
      idle_when_none: assert (idle_o == (inside_q == '0));
      inv_used: assert (CntW'(u_dut.used_q) == inside_q);
      c_full: cover (inside_q == CntW'(Limit) && give_i == '1);
    end
  end
endmodule
