// SPDX-License-Identifier: Apache-2.0
// One over a number whose top bit is set: q = min(floor(2^(DenW+RecipW-1) / den), 2^RecipW - 1).
//   s1-s4   z, q or q + 1         recip_guess
//   s5      z den                 reaches 2^(DenW+RecipW-1) if z is too large
//   s6      q = z, or z - 1
// One a cycle, six cycles, never stalls. en_i[k] says that stage k + 1 takes an item in this cycle. Two multipliers
// of 27x18 and a memory of 2^9 words. Method: a table's guess and its remainder's sign (Markstein, 1990).
// Model: div_floor of cpp_model/math/div_pipe.hpp, equal bit for bit.
module reciprocal
  import castray_cfg_pkg::*;
#(
  parameter int unsigned DenW = 26
) (
  input  logic              clk_i,

  input  logic [5:0]        en_i,
  input  logic [DenW-1:0]   den_i,
  output logic [RecipW-1:0] q_o
);
  if (DenW > DspAW - 1) begin : g_width
    $error("reciprocal: DenW must be at most %0d", DspAW - 1);
  end
  logic [DenW-1:0]        den_q [4];
  logic [RecipW-1:0]      guess, z_q;
  logic [DenW+RecipW-1:0] back;
  logic                   over_q, unused;

  recip_guess #(.DenW(DenW)) u_guess (.clk_i, .en_i(en_i[3:0]), .den_i, .guess_o(guess));

  assign back   = guess * den_q[3];
  assign unused = ^back[DenW+RecipW-2:0];

  always_ff @(posedge clk_i) begin
    if (en_i[0]) den_q[0] <= den_i;
    for (int unsigned i = 1; i < 4; i++) if (en_i[i]) den_q[i] <= den_q[i-1];
    if (en_i[4]) begin
      z_q    <= guess;
      over_q <= back[DenW+RecipW-1];
    end
    if (en_i[5]) q_o <= z_q - RecipW'(over_q);
  end
endmodule
