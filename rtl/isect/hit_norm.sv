// SPDX-License-Identifier: Apache-2.0
// |U|, |V| and |det| of a triangle, shifted together so that |det| has its top one at bit HitDivW - 1:
// exact to the left, truncated to the right. They are what div_pair divides.
//   s1  leading zeros of |det|
//   s2  num0 = U', num1 = V', den = det', HitDivW bits each       combinational, for the parent's register
// One triangle a cycle, never stalls; en_i: s1 takes one.
// Model: cpp_model/isect/hit_norm.hpp, equal bit for bit.
module hit_norm
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,

  input  logic               en_i,
  input  area_t              u_i,
  input  area_t              v_i,
  input  det_t               det_i,
  output logic [HitDivW-1:0] num0_o,
  output logic [HitDivW-1:0] num1_o,
  output logic [HitDivW-1:0] den_o
);
  localparam int unsigned DetW = $bits(det_t);  // at most 63
  logic [5:0] zeros_q;
  area_t      u_q, v_q;
  det_t       det_q;

  // Zeros above the first one of four bits.
  function automatic logic [1:0] zeros_of(logic [3:0] x);
    return x[3] ? 2'd0 : x[2] ? 2'd1 : x[1] ? 2'd2 : 2'd3;
  endfunction
  // Of each four bits, then of each four such groups: whether there is a one, and the zeros above it.
  function automatic logic [5:0] leading_zeros(det_t x);
    logic [63:0]      rest;
    logic [15:0]      some4;
    logic [15:0][1:0] zeros4;
    logic [3:0]       some16;
    logic [3:0][3:0]  zeros16;
    logic [1:0]       first, top;
    rest = {x, {(64 - DetW){1'b1}}};
    for (int unsigned i = 0; i < 16; i++) begin
      some4[i]  = rest[4*i +: 4] != '0;
      zeros4[i] = zeros_of(rest[4*i +: 4]);
    end
    for (int unsigned i = 0; i < 4; i++) begin
      some16[i]  = some4[4*i +: 4] != '0;
      first      = zeros_of(some4[4*i +: 4]);
      zeros16[i] = {first, zeros4[{2'(i), ~first}]};
    end
    top   = zeros_of(some16);
    first = ~top;
    return {top, zeros16[first]};
  endfunction

  // One of four: a shift by two bits of its distance at once.
  function automatic logic [63:0] shifted(logic [63:0] x, logic [1:0] by, int unsigned unit);
    return by[1] ? (by[0] ? x << (3 * unit) : x << (2 * unit)) : (by[0] ? x << unit : x);
  endfunction
  // From coarse to fine: what can no longer come to the top falls away.
  function automatic logic [HitDivW-1:0] top_bits(det_t x, logic [5:0] zeros);
    logic [63:0] wide;
    wide = {x, {(64 - DetW){1'b0}}};
    wide = shifted(wide, zeros[5:4], 16);
    wide = shifted(wide, zeros[3:2], 4);
    wide = shifted(wide, zeros[1:0], 1);
    return wide[63 -: HitDivW];
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      zeros_q <= leading_zeros(det_i);
      u_q     <= u_i;
      v_q     <= v_i;
      det_q   <= det_i;
    end
  end

  assign num0_o = top_bits({1'b0, u_q}, zeros_q);
  assign num1_o = top_bits({1'b0, v_q}, zeros_q);
  assign den_o  = top_bits(det_q, zeros_q);
endmodule
