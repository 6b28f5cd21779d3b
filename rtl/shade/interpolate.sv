// SPDX-License-Identifier: Apache-2.0
// A triangle's normal and texture coordinates at a hit, from those of its corners:
//   x = wu xa + wv xb + ww xc       wu, wv = u, v to 16 bits; ww = 1 - wu - wv
// for the three components of the normal in one cycle (Q3.26: where corner normals nearly cancel,
// what is left of them needs these bits), for s and t in the next (Q11.16), both to the nearest and
// saturated. Corner normals that cancel give the face's normal, which may be zero in turn.
//   s0     wu, wv (round half up), the operands of this half
//   s1     ww = 1 - wu - wv (exact; negative by at most two units where u + v rounds above one)
//   s2..6  three sums of three products (dot3), exact
//   s7     round, saturate
//   out    the first half waits in a register for the second
// 9 DSPs. One hit every two cycles, in order, latency 9 cycles from a hit's first.
// Model: cpp_model/shade/interpolate.hpp, equal bit for bit.
module interpolate
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  shade_req_t in_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output smooth_t    out_o
);
  localparam int unsigned TexW   = $bits(tex_t);
  localparam int unsigned Keep   = 10;   // fraction bits of a normal beyond UnitFrac
  localparam int unsigned Stages = 8;
  localparam int unsigned SumW   = TexW + UnitFrac + 4;   // as wide as dot3's
  // Bits by which a weight is shorter or longer than u and v.
  localparam int unsigned Drop = (BaryFrac > UnitFrac) ? BaryFrac - UnitFrac : 0;
  localparam int unsigned Gain = (UnitFrac > BaryFrac) ? UnitFrac - BaryFrac : 0;
  localparam int unsigned Half = (1 << Drop) >> 1;

  typedef logic signed [UnitFrac+1:0] weight_t;  // Q2.16
  typedef logic signed [TexW-1:0]     value_t;   // a normal's component, sign extended, or s or t
  typedef logic signed [SumW-1:0]     sum_t;

  // The only places where precision is dropped: Drop bits of a weight, 16 of a texture coordinate's
  // sum, 6 of a normal's.
  function automatic weight_t round_weight(bary_t x);
    bary_t kept;
    kept = (x + bary_t'(Half)) >> Drop;
    return weight_t'(kept) <<< Gain;
  endfunction
  function automatic value_t widen(unit_t n);
    return value_t'(n);
  endfunction
  function automatic span_t round_sum(sum_t sum, logic normal);
    logic signed [SumW-1:0] x, top;
    if (normal) x = (sum + sum_t'(1 << (UnitFrac - Keep - 1))) >>> (UnitFrac - Keep);
    else x = (sum + sum_t'(1 << (UnitFrac - 1))) >>> UnitFrac;
    top = normal ? sum_t'((1 << (SpanW - 1)) - 1) : sum_t'((1 << (TexW - 1)) - 1);
    if (x > top) x = top;
    else if (x < ~top) x = ~top;
    return span_t'(x);
  endfunction
  function automatic span_t widen_face(unit_t n);
    return span_t'(n) <<< Keep;
  endfunction

  // ---- Two halves a hit ----
  logic [Stages-1:0] load;
  logic half_q;                        // 0: normals, 1: texture coordinates
  logic chain_ready, chain_valid, chain_taken;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(chain_ready),
    .valid_o(chain_valid), .ready_i(chain_taken), .load_o(load)
  );
  assign in_ready_o = chain_ready && half_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) half_q <= 1'b0;
    else if (load[0]) half_q <= !half_q;
  end

  // ---- Weights and operands ----
  attr_t   attr;
  weight_t wu0_q, wv0_q, wu1_q, wv1_q, ww1_q;
  value_t  a0_q [3], b0_q [3], c0_q [3], a1_q [3], b1_q [3], c1_q [3];
  assign attr = in_i.attr;

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      wu0_q   <= round_weight(in_i.hit.u);
      wv0_q   <= round_weight(in_i.hit.v);
      a0_q[0] <= half_q ? attr.sa : widen(attr.na.x);
      b0_q[0] <= half_q ? attr.sb : widen(attr.nb.x);
      c0_q[0] <= half_q ? attr.sc : widen(attr.nc.x);
      a0_q[1] <= half_q ? attr.ta : widen(attr.na.y);
      b0_q[1] <= half_q ? attr.tb : widen(attr.nb.y);
      c0_q[1] <= half_q ? attr.tc : widen(attr.nc.y);
      a0_q[2] <= widen(attr.na.z);  // of no use in the second half
      b0_q[2] <= widen(attr.nb.z);
      c0_q[2] <= widen(attr.nc.z);
    end
    if (load[1]) begin
      wu1_q <= wu0_q;
      wv1_q <= wv0_q;
      ww1_q <= weight_t'(1 << UnitFrac) - wu0_q - wv0_q;
      for (int unsigned i = 0; i < 3; i++) begin
        a1_q[i] <= a0_q[i];
        b1_q[i] <= b0_q[i];
        c1_q[i] <= c0_q[i];
      end
    end
  end

  // ---- What goes along ----
  typedef struct packed {
    logic   half;
    unit3_t face;
  } side_t;
  side_t side_q [Stages];
  always_ff @(posedge clk_i) begin
    if (load[0]) side_q[0] <= '{half: half_q, face: attr.face};
    for (int unsigned i = 1; i < Stages; i++) if (load[i]) side_q[i] <= side_q[i-1];
  end

  // ---- Sums ----
  span_t mixed_q [3];
  for (genvar i = 0; i < 3; i++) begin : g_sum
    sum_t sum;
    dot3 #(.AW(TexW), .BW(UnitFrac + 2)) u_dot (
      .clk_i, .load_i(load[6:2]),
      .a0_i(a1_q[i]), .b0_i(wu1_q), .a1_i(b1_q[i]), .b1_i(wv1_q), .a2_i(c1_q[i]), .b2_i(ww1_q),
      .p_o(sum)
    );
    always_ff @(posedge clk_i) begin
      if (load[7]) mixed_q[i] <= round_sum(sum, !side_q[6].half);
    end
  end

  // ---- The halves meet ----
  span3_t mixed, face, normal_q;
  logic   second;
  assign mixed = '{x: mixed_q[0], y: mixed_q[1], z: mixed_q[2]};
  assign face  = '{x: widen_face(side_q[Stages-1].face.x), y: widen_face(side_q[Stages-1].face.y),
                   z: widen_face(side_q[Stages-1].face.z)};
  assign second      = side_q[Stages-1].half;
  assign chain_taken = !second || out_ready_i;
  assign out_valid_o = chain_valid && second;
  assign out_o       = '{normal: normal_q, s: tex_t'(mixed_q[0]), t: tex_t'(mixed_q[1])};
  always_ff @(posedge clk_i) begin
    if (chain_valid && !second) normal_q <= (mixed == '0) ? face : mixed;
  end
endmodule
