// SPDX-License-Identifier: Apache-2.0
// |U|, |V| and |det| of a triangle, shifted together so that |det| has its top one at bit HitDivW - 1:
// exact to the left, truncated to the right. They are what the divider divides.
//   s1  leading zeros of |det|
//   s2  num0 = U', num1 = V', den = det', HitDivW bits each
// The inputs stay until s2 has taken them; en_i[k]: stage k + 1 takes its item.
// Model: cpp_model/isect/hit_norm.hpp, equal bit for bit.
module hit_norm
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,

  input  logic [1:0]         en_i,
  input  area_t              u_i,
  input  area_t              v_i,
  input  det_t               det_i,
  output logic [HitDivW-1:0] num0_o,
  output logic [HitDivW-1:0] num1_o,
  output logic [HitDivW-1:0] den_o
);
  localparam int unsigned DetW = $bits(det_t);  // at most 63
  logic [5:0] zeros_q;

  function automatic logic [5:0] leading_zeros(det_t x);
    logic [63:0] rest;
    rest = {x, {(64 - DetW){1'b1}}};
    for (int unsigned k = 0; k < 6; k++) begin
      leading_zeros[5-k] = (rest >> (64 - (32 >> k))) == '0;
      if (leading_zeros[5-k]) rest = rest << (32 >> k);
    end
  endfunction
  function automatic logic [HitDivW-1:0] top_bits(det_t x, logic [5:0] zeros);
    det_t shifted;
    shifted = x << zeros;
    return shifted[DetW-1-:HitDivW];
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
