// SPDX-License-Identifier: Apache-2.0
// The two divisions of a sphere, (b - root) / |S|^2 and (b + root) / |S|^2 in quarter steps, with
// root = sqrt(32 disc), rounded down, and b = towards, turned into the ray's direction.
//   root_pipe  root; the rest waits in a small memory
//   s1  b - root, b + root                             exact
//   s2  magnitudes and signs
//   s3  num = magnitude >> k: at most HitDivW - 1 bits   truncated
//       scale = +-2^(k + half + HitDivW - 2 - BaryFrac), so that the quotient times scale is
//       the distance
//       den = norm2 << half, its top one at bit HitDivW - 1; half: norm2 below two. Truncated if
//       HitDivW is less than norm2's width
//       combinational, for the parent's register
// One sphere a cycle, never stalls; soon_o: there will be one at s3 in two cycles. disc has at most
// 2 CoordW - 1 bits.
// Model: cpp_model/isect/hit_sphere.hpp, equal bit for bit.
module hit_sphere
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter type tag_t = logic [5:0]
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               valid_i,
  input  logic [2*CoordW-2:0] disc_i,
  input  towards_t           towards_i,
  input  logic               neg_i,
  input  norm2_t             norm2_i,
  input  tag_t               tag_i,

  output logic               soon_o,
  output logic               valid_o,
  output logic [HitDivW-1:0] num0_o,
  output logic [HitDivW-1:0] num1_o,
  output logic [HitDivW-1:0] den_o,
  output delta_t             scale0_o,
  output delta_t             scale1_o,
  output tag_t               tag_o
);
  localparam int unsigned NumW   = HitDivW - 1;
  localparam int unsigned MagW   = $bits(towards_t) - 1;
  localparam int unsigned Lost   = (MagW > NumW) ? MagW - NumW : 0;  // bits that a magnitude may lose
  localparam int unsigned ShiftW = $clog2(Lost + 2);
  localparam int unsigned NormW  = $bits(norm2_t);
  localparam int unsigned RootW  = CoordW + 2 + CoordW % 2;   // root_pipe makes an even number
  localparam int unsigned Gain   = HitDivW - 2 - BaryFrac;

  // ---- The root, and what waits for it: written as a sphere enters, at the place of that cycle ----
  typedef struct packed {
    towards_t towards;
    logic     neg;
    norm2_t   norm2;
    tag_t     tag;
  } kept_t;
  localparam int unsigned RootCycles = RootW / 2;
  localparam int unsigned PlaceW     = $clog2(RootCycles + 1);
  typedef logic [PlaceW-1:0] place_t;

  place_t             place_q;
  kept_t              kept_q [1 << PlaceW];
  kept_t              kept;
  logic               root_valid;
  logic [RootW-1:0]   root;

  root_pipe #(.RadW(2 * RootW)) u_root (
    .clk_i, .rst_ni, .in_valid_i(valid_i), .in_rad_i((2*RootW)'({disc_i, 5'b0})), .out_valid_o(root_valid), .out_root_o(root)
  );
  assign kept   = kept_q[place_q - place_t'(RootCycles)];
  assign soon_o = root_valid;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= '0;
    else place_q <= place_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (valid_i) kept_q[place_q] <= '{towards: towards_i, neg: neg_i, norm2: norm2_i, tag: tag_i};
  end

  // ---- s1 to s3 ----
  function automatic towards_t turned(towards_t x, logic negative);
    return negative ? -x : x;
  endfunction
  function automatic logic [ShiftW-1:0] excess(logic [MagW-1:0] mag);
    excess = '0;
    for (int unsigned k = NumW; k < MagW; k++) if (mag[k]) excess = ShiftW'(k - NumW + 1);
  endfunction
  // +-2^k: bit k, or bit k and all above it.
  function automatic delta_t scale(logic [ShiftW-1:0] shift, logic half, logic negative);
    logic [4:0] k;
    k = 5'(shift) + 5'(half) + 5'(Gain);
    for (int unsigned i = 0; i <= CoordW; i++) scale[i] = (5'(i) == k) || (negative && 5'(i) > k);
  endfunction

  function automatic logic [HitDivW-1:0] aligned(norm2_t x);
    logic [HitDivW+NormW-1:0] wide;
    wide = {x, {HitDivW{1'b0}}};
    return wide[NormW +: HitDivW];
  endfunction

  logic            valid1_q, valid2_q, neg0_q, neg1_q, half;
  towards_t        near_q, far_q;
  logic [MagW-1:0] mag0_q, mag1_q;
  norm2_t          norm1_q, norm2_q;
  tag_t            tag1_q, tag2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid2_q <= 1'b0;
    end else begin
      valid1_q <= root_valid;
      valid2_q <= valid1_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (root_valid) begin
      near_q  <= turned(kept.towards, kept.neg) - towards_t'({1'b0, root});
      far_q   <= turned(kept.towards, kept.neg) + towards_t'({1'b0, root});
      norm1_q <= kept.norm2;
      tag1_q  <= kept.tag;
    end
    if (valid1_q) begin
      mag0_q  <= MagW'(turned(near_q, near_q[MagW]));
      mag1_q  <= MagW'(turned(far_q, far_q[MagW]));
      neg0_q  <= near_q[MagW];
      neg1_q  <= far_q[MagW];
      norm2_q <= norm1_q;
      tag2_q  <= tag1_q;
    end
  end

  assign half     = !norm2_q[NormFrac+1];
  assign valid_o  = valid2_q;
  assign num0_o   = HitDivW'(mag0_q >> excess(mag0_q));
  assign num1_o   = HitDivW'(mag1_q >> excess(mag1_q));
  assign den_o    = aligned(half ? norm2_q << 1 : norm2_q);
  assign scale0_o = scale(excess(mag0_q), half, neg0_q);
  assign scale1_o = scale(excess(mag1_q), half, neg1_q);
  assign tag_o    = tag2_q;
endmodule
