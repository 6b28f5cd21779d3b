// SPDX-License-Identifier: Apache-2.0
// Between a child's two planes across one axis: the ticks of the dominant axis between which the ray
// is inside, outwards.
//   s1  least = q0 mant, most = q1 (mant + 1), in one DSP: (q0 + 2^18 q1) mant + 2^18 q1
//       (its operands; mant is taken in s2)
//   s2  the products
//   s3  low, high in the axis' ticks; least is rounded down, most up
//   s4  low, high in the dominant one's: times 2^left, cut to 0 and the largest
// none_o: the ray leaves before the node's first plane across the dominant axis.
// One child a cycle, never stalls; en_i[k]: stage k + 1 takes an item. mant_i belongs to s2, minus_i,
// low_i and high_i to s3, left_i to s4.
// Model: cpp_model/isect/slab_planes.hpp, equal bit for bit.
module slab_planes
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic       clk_i,

  input  logic [3:0] en_i,
  input  plane_t     q0_i,
  input  plane_t     q1_i,
  input  logic [9:0] mant_i,
  input  logic       minus_i,
  input  slab_t      low_i,
  input  slab_t      high_i,
  input  logic [3:0] left_i,

  output logic       none_o,
  output tick_t      low_o,
  output tick_t      high_o
);
  localparam int unsigned LaneW = 18;           // a product of 8 and 10 bits
  localparam int unsigned Drop  = 9 - SubPlane;
  localparam int unsigned TermW = LaneW - Drop;
  localparam int unsigned SlabW = $bits(slab_t);
  typedef logic [TermW-1:0] term_t;

  // The second lane: q1 (mant + 1), and one more unit, for rounding up.
  function automatic logic [2*LaneW-1:0] products(plane_t q0, plane_t q1, logic [9:0] mant);
    logic [LaneW-1:0] more;
    more = LaneW'(q1) + (LaneW'(1) << Drop);
    return (2*LaneW)'({q1, 10'b0, q0}) * (2*LaneW)'(mant) + {more, LaneW'(0)};
  endfunction

  // a + b, or a - b.
  function automatic slab_t add(slab_t a, term_t b, logic minus);
    return a + (minus ? ~slab_t'(b) : slab_t'(b)) + slab_t'({1'b0, minus});
  endfunction

  // Times 2^left, cut to a tick_t.
  function automatic tick_t to_ticks(slab_t x, logic [3:0] left);
    logic [SlabW-2:0] beyond;
    logic             fits;
    beyond = ~({SlabW-1{1'b1}} >> (SlabW - 1 - $bits(tick_t)) >> left);
    fits   = (x[SlabW-2:0] & beyond) == '0;
    return x[SlabW-1] ? '0 : fits ? tick_t'(x) << left : '1;
  endfunction

  plane_t             q0_q, q1_q;
  logic [2*LaneW-1:0] products_q;
  term_t              least, most;
  slab_t              low_q, high_q;
  assign least = products_q[LaneW-1 -: TermW];
  assign most  = products_q[2*LaneW-1 -: TermW];

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      q0_q <= q0_i;
      q1_q <= q1_i;
    end
    if (en_i[1]) products_q <= products(q0_q, q1_q, mant_i);
    if (en_i[2]) begin
      low_q  <= add(low_i, minus_i ? most : least, minus_i);
      high_q <= add(high_i, minus_i ? least : most, minus_i);
    end
    if (en_i[3]) begin
      none_o <= high_q[SlabW-1];
      low_o  <= to_ticks(low_q, left_i);
      high_o <= to_ticks(high_q, left_i);
    end
  end
endmodule
