// SPDX-License-Identifier: Apache-2.0
// Does the ray pass through the triangle? If so, the magnitudes that the hit unit divides.
//   s1  the three signs are equal, and det = U + V + W is not zero    |U|, |V|
//   s2  |det| = |U| + |V| + |W|
// Edge functions come as edge_fns gives them, each less one unless its up: |U| is u_i + !u_up_i, or
// ~u_i + u_up_i where that is negative.
// Zeros take their sign from a strict order of the corners around the triangle, so all three can
// be zero with equal signs only where the corners coincide: det is zero with equal signs exactly
// if point_i. Seen from the ray's origin a front (counter-clockwise) has det > 0 for a ray along
// +z, det < 0 for one along -z; others are dropped if cull_i.
// One triangle a cycle, two cycles, never stalls; only an accepted one moves further.
// Model: cpp_model/isect/accept.hpp, equal bit for bit.
module accept
  import castray_pkg::*;
(
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               valid_i,
  input  logic               neg_i,
  input  logic               cull_i,
  input  edge_fn_t           u_i,
  input  edge_fn_t           v_i,
  input  edge_fn_t           w_i,
  input  logic               u_up_i,
  input  logic               v_up_i,
  input  logic               w_up_i,
  input  logic               point_i,

  output logic               valid_o,
  output area_t              u_o,
  output area_t              v_o,
  output det_t               det_o
);
  logic  valid1_q;
  area_t u1_q, v1_q;
  area_t w1_q;           // W as it came
  logic  minus1_q, more1_q;
  logic  u_neg, v_neg, w_neg, accepted;

  assign u_neg    = u_i < 0;
  assign v_neg    = v_i < 0;
  assign w_neg    = w_i < 0;
  assign accepted = valid_i && (u_neg == v_neg) && (v_neg == w_neg) && !point_i && !(cull_i && (u_neg != neg_i));

  function automatic area_t turned(area_t x, logic negative);
    return x ^ {$bits(x){negative}};
  endfunction
  function automatic area_t magnitude(edge_fn_t x, logic negative, logic up);
    return turned(x, negative) + area_t'(negative == up);
  endfunction
  // a + b + more
  function automatic det_t sum(area_t a, area_t b, logic more);
    logic [$bits(det_t):0] both;
    both = {det_t'(a), more} + {det_t'(b), more};
    return both[$bits(det_t):1];
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid_o  <= 1'b0;
    end else begin
      valid1_q <= accepted;
      valid_o  <= valid1_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (accepted) begin
      u1_q     <= magnitude(u_i, u_neg, u_up_i);
      v1_q     <= magnitude(v_i, u_neg, v_up_i);
      w1_q     <= w_i;
      minus1_q <= u_neg;
      more1_q  <= u_neg == w_up_i;
    end
    if (valid1_q) begin
      u_o   <= u1_q;
      v_o   <= v1_q;
      det_o <= sum(u1_q, v1_q, more1_q) + det_t'(turned(w1_q, minus1_q));
    end
  end
endmodule
