// SPDX-License-Identifier: Apache-2.0
// |U|, |V| and |det| of a triangle, shifted together so that |det| has its top one at bit 25:
// exact to the left, truncated to the right. They are what the divider divides.
//   s1  leading zeros of |det|
//   s2  num0 = U', num1 = V', den = det', 26 bits each
// The inputs stay until s2 has taken them; en_i[k]: stage k + 1 takes its item.
// Model: cpp_model/isect/hit_norm.hpp, equal bit for bit.
module hit_norm
  import castray_cfg_pkg::*;
(
  input  logic               clk_i,

  input  logic [1:0]         en_i,
  input  logic [54:0]        u_i,
  input  logic [54:0]        v_i,
  input  logic [55:0]        det_i,
  output logic [HitDivW-1:0] num0_o,
  output logic [HitDivW-1:0] num1_o,
  output logic [HitDivW-1:0] den_o
);
  logic [5:0] zeros_q;

  function automatic logic [5:0] leading_zeros(logic [55:0] x);
    logic [63:0] rest;
    rest = {x, 8'hff};
    for (int unsigned k = 0; k < 6; k++) begin
      leading_zeros[5-k] = (rest >> (64 - (32 >> k))) == '0;
      if (leading_zeros[5-k]) rest = rest << (32 >> k);
    end
  endfunction
  function automatic logic [HitDivW-1:0] top_bits(logic [55:0] x, logic [5:0] zeros);
    logic [55:0] shifted;
    shifted = x << zeros;
    return shifted[55-:HitDivW];
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) zeros_q <= leading_zeros(det_i);
    if (en_i[1]) begin
      num0_o <= top_bits({1'b0, u_i}, zeros_q);
      num1_o <= top_bits({1'b0, v_i}, zeros_q);
      den_o  <= top_bits(det_i, zeros_q);
    end
  end
endmodule
