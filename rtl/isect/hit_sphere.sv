// SPDX-License-Identifier: Apache-2.0
// The two divisions of a sphere, (b - root) / |S|^2 and (b + root) / |S|^2 in quarter steps, with
// root = sqrt(32 disc), rounded down, and b = towards, turned into the ray's direction.
//   s1  b - root, b + root                             exact
//   s2  magnitudes and signs
//   s3  num = magnitude >> k: at most HitDivW - 1 bits   truncated
//       scale = +-2^(k + half + HitDivW - 2 - BaryFrac), so that the quotient times scale is
//       the distance
//       den = norm2 << half, its top one at bit HitDivW - 1; half: norm2 below two. Truncated if
//       HitDivW is less than norm2's width
// One sphere at a time: start_i takes it in a cycle with ready_o and its inputs stay until done_o;
// done_o and the outputs stay until take_i. disc has at most
// 2 CoordW - 1 bits.
// Model: cpp_model/isect/hit_sphere.hpp, equal bit for bit.
module hit_sphere
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               start_i,
  output logic               ready_o,
  input  logic [2*CoordW-2:0] disc_i,
  input  towards_t           towards_i,
  input  logic               neg_i,
  input  norm2_t             norm2_i,

  output logic               done_o,
  input  logic               take_i,
  output logic [HitDivW-1:0] num0_o,
  output logic [HitDivW-1:0] num1_o,
  output logic [HitDivW-1:0] den_o,
  output delta_t             scale0_o,
  output delta_t             scale1_o
);
  localparam int unsigned NumW   = HitDivW - 1;
  localparam int unsigned MagW   = $bits(towards_t) - 1;
  localparam int unsigned Lost   = (MagW > NumW) ? MagW - NumW : 0;  // bits that a magnitude may lose
  localparam int unsigned ShiftW = $clog2(Lost + 2);
  localparam int unsigned NormW  = $bits(norm2_t);
  localparam int unsigned RootW  = CoordW + 2;
  localparam int unsigned Gain   = HitDivW - 2 - BaryFrac;

  logic               root_valid, valid1_q, valid2_q, neg0_q, neg1_q;
  logic [RootW-1:0]   root;
  towards_t           near_q, far_q;
  logic [MagW-1:0]    mag0_q, mag1_q;

  root_seq #(.RadW(2 * RootW)) u_root (
    .clk_i, .rst_ni,
    .in_valid_i(start_i), .in_ready_o(ready_o), .in_rad_i({disc_i, 5'b0}),
    .out_valid_o(root_valid), .out_ready_i(1'b1), .out_root_o(root)
  );

  function automatic towards_t turned(towards_t x, logic negative);
    return negative ? -x : x;
  endfunction
  function automatic logic [ShiftW-1:0] excess(logic [MagW-1:0] mag);
    excess = '0;
    for (int unsigned k = NumW; k < MagW; k++) if (mag[k]) excess = ShiftW'(k - NumW + 1);
  endfunction
  function automatic delta_t scale(logic [ShiftW-1:0] shift, logic half, logic negative);
    delta_t power;
    power = delta_t'(1) <<< (5'(shift) + 5'(half) + 5'(Gain));
    return negative ? -power : power;
  endfunction

  function automatic logic [HitDivW-1:0] aligned(norm2_t x);
    logic [HitDivW+NormW-1:0] wide;
    wide = {x, {HitDivW{1'b0}}};
    return wide[NormW +: HitDivW];
  endfunction

  logic half;
  assign half = !norm2_i[NormFrac+1];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid2_q <= 1'b0;
      done_o   <= 1'b0;
    end else begin
      valid1_q <= root_valid;
      valid2_q <= valid1_q;
      if (valid2_q) done_o <= 1'b1;
      else if (take_i) done_o <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (root_valid) begin
      near_q <= turned(towards_i, neg_i) - towards_t'({1'b0, root});
      far_q  <= turned(towards_i, neg_i) + towards_t'({1'b0, root});
    end
    if (valid1_q) begin
      mag0_q <= MagW'(turned(near_q, near_q[MagW]));
      mag1_q <= MagW'(turned(far_q, far_q[MagW]));
      neg0_q <= near_q[MagW];
      neg1_q <= far_q[MagW];
    end
    if (valid2_q) begin
      num0_o   <= HitDivW'(mag0_q >> excess(mag0_q));
      num1_o   <= HitDivW'(mag1_q >> excess(mag1_q));
      den_o    <= aligned(half ? norm2_i << 1 : norm2_i);
      scale0_o <= scale(excess(mag0_q), half, neg0_q);
      scale1_o <= scale(excess(mag1_q), half, neg1_q);
    end
  end
endmodule
