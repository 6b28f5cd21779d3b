// SPDX-License-Identifier: Apache-2.0
// Between a child's two planes across one axis: the ticks of the dominant axis between which the ray
// is inside, outwards.
//   s1  the planes
//   s2  least = q0 mant, most = q1 (mant + 1)      two DSPs
//   s3  low, high in the axis' ticks; least is rounded down, most up: a unit more
//   s4  low, high in the dominant one's: times 2^left, cut to 0 and the largest
// none_o: the ray leaves before the node's first plane across the dominant axis.
// One child a cycle, never stalls; en_i[k]: stage k + 1 takes an item. mant_i and more_i belong to s2, minus_i,
// low_i and high_i to s3, left_i to s4.
// Model: cpp_model/isect/slab_planes.hpp, equal bit for bit.
module slab_planes
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic        clk_i,

  input  logic [3:0]  en_i,
  input  plane_t      q0_i,
  input  plane_t      q1_i,
  input  logic [9:0]  mant_i,
  input  logic [10:0] more_i,   // mant + 1
  input  logic        minus_i,
  input  slab_t       low_i,
  input  slab_t       high_i,
  input  logic [3:0]  left_i,

  output logic        none_o,
  output tick_t       low_o,
  output tick_t       high_o
);
  localparam int unsigned ProdW = 18;           // a product of 8 and 10 bits
  localparam int unsigned Drop  = 9 - SubPlane;
  localparam int unsigned TermW = ProdW - Drop;
  localparam int unsigned SlabW = $bits(slab_t);
  typedef logic [ProdW-1:0] product_t;
  typedef logic [TermW-1:0] term_t;

  // Times 2^left, cut to a tick_t.
  function automatic tick_t to_ticks(slab_t x, logic [3:0] left);
    logic [SlabW-2:0] beyond;
    logic             fits;
    beyond = ~({SlabW-1{1'b1}} >> (SlabW - 1 - $bits(tick_t)) >> left);
    fits   = (x[SlabW-2:0] & beyond) == '0;
    return x[SlabW-1] ? '0 : fits ? tick_t'(x) << left : '1;
  endfunction

  plane_t         q0_q, q1_q;
  product_t       least_q, most_q;
  term_t          least, most;
  logic [SlabW:0] low, high;   // with the carry into it
  slab_t          low_q, high_q;
  assign least = least_q[ProdW-1 -: TermW];
  assign most  = most_q[ProdW-1 -: TermW];
  assign low   = {low_i, 1'b0} + {minus_i ? ~slab_t'(most) : slab_t'(least), 1'b0};
  assign high  = {high_i, 1'b1} + {minus_i ? ~slab_t'(least) : slab_t'(most), 1'b1};

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      q0_q <= q0_i;
      q1_q <= q1_i;
    end
    if (en_i[1]) begin
      least_q <= product_t'(q0_q) * product_t'(mant_i);
      most_q  <= product_t'(q1_q) * product_t'(more_i);
    end
    if (en_i[2]) begin
      low_q  <= low[SlabW:1];
      high_q <= high[SlabW:1];
    end
    if (en_i[3]) begin
      none_o <= high_q[SlabW-1];
      low_o  <= to_ticks(low_q, left_i);
      high_o <= to_ticks(high_q, left_i);
    end
  end
endmodule
