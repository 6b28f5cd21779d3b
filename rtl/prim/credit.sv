// SPDX-License-Identifier: Apache-2.0
// Counts items under way: what cannot refuse its results takes one only while available_o, fewer
// than Limit, says so; what bounds its items itself gives that bound as Limit and asks for idle_o.
module credit #(
  parameter int unsigned Limit = 16,
  parameter int unsigned Gives = 1    // how many ways there are to leave
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             take_i,
  input  logic [Gives-1:0] give_i,
  output logic             available_o,
  output logic             idle_o
);
  localparam int unsigned CntW = $clog2(Limit + Gives + 1);
  logic [CntW-1:0] used_q;

  assign available_o = used_q < CntW'(Limit);
  assign idle_o      = used_q == '0;

  function automatic logic [CntW-1:0] counted(logic [CntW-1:0] used, logic take, logic [Gives-1:0] give);
    counted = used + CntW'(take);
    for (int unsigned i = 0; i < Gives; i++) counted = counted - CntW'(give[i]);
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) used_q <= '0;
    else if (take_i || give_i != '0) used_q <= counted(used_q, take_i, give_i);
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (used_q <= CntW'(Limit)) else $error("credit: more than %0d items inside, or fewer than none", Limit);
    end
  end
`endif
endmodule
