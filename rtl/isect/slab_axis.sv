// SPDX-License-Identifier: Apache-2.0
// Where a ray crosses a node's planes across an axis that is not dominant. With D, Dz the node's
// origin from the ray's and e, ez the exponents of the planes' spacing, the plane q is crossed at
//   D / S + q 2^e / S - Dz     steps behind the first plane across the dominant axis.
// A tick of this axis is 2^-SubPlane of the wider of two spacings: 2^e / |S|, and 2^ez.
//   s1  over = e + exp - ez; the shift from the product to ticks
//   s2  D mant, -+ Dz 2^16 / 2^exp                   two DSPs: a shift by exp's lower bits is a product
//       slack: what D mant may lack; mant's upper 10 bits for the planes, and one more
//   s3  base = product, their sum, in ticks, cut to SubPlane + 11 bits; low, high
//   s4  left: a tick of this axis is 2^left ticks of the dominant one, 15: or more
// The ray crosses plane q between low + q mant and high + q (mant + 1), S negative: between
// low - q (mant + 1) and high - q mant; mant with 9 - SubPlane fraction bits.
// e and ez are at most MaxPlaneExp.
// One node a cycle, never stalls; en_i[k]: stage k + 1 takes an item.
// Model: cpp_model/isect/slab_axis.hpp, equal bit for bit.
module slab_axis
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic       clk_i,

  input  logic [3:0] en_i,
  input  recip_t     recip_i,
  input  delta_t     d_i,
  input  plane_exp_t e_i,
  input  delta_t     dz_i,
  input  plane_exp_t ez_i,

  output logic [9:0]  mant_o,   // of s2
  output logic [10:0] more_o,   // mant + 1
  output logic       minus_o,   // of s3
  output slab_t      low_o,
  output slab_t      high_o,
  output logic [3:0] left_o     // of s4
);
  localparam int unsigned Drop  = RecipW - 1 - SubPlane;
  localparam int unsigned BaseW = SubPlane + 11;
  localparam int unsigned ProdW = CoordW + RecipW + 2;
  localparam int unsigned TickW = BaseW + MaxPlaneExp;   // the product in ticks, before it is shifted right
  typedef logic signed [6:0]       over_t;
  typedef logic signed [ProdW-1:0] product_t;
  typedef logic [BaseW-1:0]        slack_t;
  typedef logic signed [RecipW:0]  scale_t;

  // 2^16 / 2^exp, but for exp's top bit, which is 2^16.
  function automatic scale_t scale(logic [4:0] exp);
    return scale_t'(1) << (5'd16 - {1'b0, exp[3:0]});
  endfunction

  function automatic product_t whole(delta_t d, recip_t r);
    logic signed [RecipW:0] mant;
    mant = {1'b0, r.mant};
    return d * mant;
  endfunction
  function automatic product_t along(delta_t dz, scale_t by, recip_t r);
    product_t shifted;
    shifted = dz * by;
    if (r.exp[4]) shifted = shifted >>> 16;
    return r.minus ? shifted : ~shifted;
  endfunction

  // |d| in ticks, rounded up.
  function automatic slack_t slack(delta_t d, plane_exp_t right);
    logic [CoordW-1:0] ticks;
    ticks = (d[CoordW] ? ~d[CoordW-1:0] : d[CoordW-1:0]) >> Drop;
    for (int k = 4; k >= 0; k--) if (right[k]) ticks = ticks >> (1 << k);
    return slack_t'(ticks) + 1'b1;
  endfunction

  // The product in ticks, cut to its format.
  function automatic logic [BaseW-1:0] base(product_t p, plane_exp_t right);
    logic [TickW-1:0] ticks, beyond;
    logic             minus, fits;
    ticks  = TickW'(p >>> Drop);
    minus  = p[ProdW-1];
    beyond = ({TickW{1'b1}} << (BaseW - 1)) << right;
    fits   = ((ticks ^ {TickW{minus}}) & beyond) == '0;
    for (int k = 4; k >= 0; k--) if (right[k]) ticks = ticks >> (1 << k);
    return fits ? {minus, ticks[BaseW-2:0]} : {minus, {BaseW-1{!minus}}};
  endfunction

  function automatic logic [9:0] plane_mant(logic [RecipW-1:0] mant, over_t over);
    return over[6] ? (mant[RecipW-1 -: 10] >> 1) >> 6'(~over) : mant[RecipW-1 -: 10];
  endfunction

  function automatic logic [3:0] to_left(over_t over);
    return over[6] ? 4'd0 : (over > 7'sd15) ? 4'd15 : over[3:0];
  endfunction

  // ---- s1 ----
  over_t      over, over1_q;
  recip_t     recip1_q;
  scale_t     scale1_q;
  delta_t     d1_q, dz1_q;
  plane_exp_t right1_q;
  assign over = over_t'({2'b0, e_i}) + over_t'({2'b0, recip_i.exp}) - over_t'({2'b0, ez_i});
  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      recip1_q <= recip_i;
      scale1_q <= scale(recip_i.exp);
      d1_q     <= d_i;
      dz1_q    <= dz_i;
      over1_q  <= over;
      right1_q <= over[6] ? ez_i - recip_i.exp : e_i;
    end
  end

  // ---- s2 ----
  product_t   whole2_q, along2_q;
  slack_t     slack2_q;
  logic       minus2_q, before2_q;   // before: the true crossing lies before base, else behind it
  plane_exp_t right2_q;
  logic [3:0] left2_q, left3_q;
  always_ff @(posedge clk_i) begin
    if (en_i[1]) begin
      whole2_q   <= whole(d1_q, recip1_q);
      along2_q   <= along(dz1_q, scale1_q, recip1_q);
      slack2_q   <= slack(d1_q, right1_q);
      minus2_q   <= recip1_q.minus;
      before2_q  <= d1_q[CoordW] != recip1_q.minus;
      right2_q   <= right1_q;
      left2_q    <= to_left(over1_q);
      mant_o     <= plane_mant(recip1_q.mant, over1_q);
      more_o     <= 11'(plane_mant(recip1_q.mant, over1_q)) + 1'b1;
    end
  end

  // ---- s3 ----
  // One addition, with a carry into it.
  function automatic slab_t sum(slab_t a, slab_t b, logic carry);
    logic signed [$bits(slab_t):0] both;
    both = {a, carry} + {b, carry};
    return both[$bits(slab_t):1];
  endfunction
  function automatic slab_t from();
    return slab_t'(signed'({BaseW{minus2_q}} ^ base(whole2_q + along2_q, right2_q)));
  endfunction
  always_ff @(posedge clk_i) begin
    if (en_i[2]) begin
      low_o   <= sum(from(), before2_q ? ~slab_t'({1'b0, slack2_q}) : '0, before2_q);
      high_o  <= sum(from(), before2_q ? '0 : slab_t'({1'b0, slack2_q}), 1'b1);
      minus_o <= minus2_q;
      left3_q <= left2_q;
    end
    if (en_i[3]) left_o <= left3_q;
  end

  logic unused_zero;   // zero has an exponent of its own
  assign unused_zero = recip1_q.zero;
endmodule
