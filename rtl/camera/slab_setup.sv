// SPDX-License-Identifier: Apache-2.0
// Fills in what the tests of boxes need of a ray: rx and ry, one over |sx| and |sy|, rounded down.
//   s0              k = |S|, and its leading zeros, ShearFrac bits: exp
//   s1              k' = k << exp
//   div_pipe (two)  q = floor(2^(ShearFrac+RecipW-1) / k'), one bit a stage
//   out             mant = min(q, 2^RecipW - 1); of S = 0: 2^(RecipW-1), and exp 31
// so that mant 2^(exp-16) <= 1/|S| <= (mant + 1) 2^(exp-16): q exceeds RecipW bits for a power of two
// only, and then mant + 1 is exact. In the place of zero stands 2^-31, which leaves the node test
// exact: see docs/number-formats.md.
// One ray a cycle, in order; 2 + (RecipW + 2) stages. The rest of the ray passes through.
// Model: cpp_model/camera/slab_setup.hpp, equal bit for bit.
module slab_setup
  import castray_cfg_pkg::*;
  import castray_pkg::*;
(
  input  logic clk_i,
  input  logic rst_ni,

  input  logic in_valid_i,
  output logic in_ready_o,
  input  ray_t in_i,

  output logic out_valid_o,
  input  logic out_ready_i,
  output ray_t out_o
);
  width_check u_widths ();
  localparam int unsigned ExpW = 5;
  typedef logic [ShearFrac-1:0] mag_t;
  typedef logic [ExpW-1:0]      exp_t;
  typedef logic [RecipW:0]      quotient_t;

  function automatic mag_t magnitude(shear_t s);
    return s[ShearFrac] ? -mag_t'(s) : mag_t'(s);
  endfunction

  function automatic exp_t leading_zeros(mag_t k);
    leading_zeros = '0;
    for (int unsigned i = 0; i < ShearFrac; i++) if (k[i]) leading_zeros = exp_t'(ShearFrac - 1 - i);
  endfunction

  function automatic recip_t recip(shear_t s, exp_t exp, quotient_t q);
    recip.zero  = s == '0;
    recip.minus = s[ShearFrac];
    recip.exp   = recip.zero ? '1 : exp;
    recip.mant  = recip.zero ? RecipW'(1) << (RecipW - 1) : q[RecipW] ? '1 : q[RecipW-1:0];
  endfunction

  typedef struct packed {
    ray_t ray;
    exp_t exp_x;
    exp_t exp_y;
  } side_t;   // what travels beside the divisions

  // ---- Normalised ----
  logic       norm_valid, norm_ready;
  logic [1:0] load;
  mag_t       kx_q, ky_q, den_x_q, den_y_q;
  side_t      side_q, norm_side_q;

  pipe_chain #(.Stages(2)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(norm_valid), .ready_i(norm_ready),
    .load_o(load)
  );
  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      kx_q   <= magnitude(in_i.sx);
      ky_q   <= magnitude(in_i.sy);
      side_q <= '{ray: in_i, exp_x: leading_zeros(magnitude(in_i.sx)), exp_y: leading_zeros(magnitude(in_i.sy))};
    end
    if (load[1]) begin
      den_x_q     <= kx_q << side_q.exp_x;
      den_y_q     <= ky_q << side_q.exp_y;
      norm_side_q <= side_q;
    end
  end

  // ---- Two divisions in step ----
  localparam mag_t Num = mag_t'(1) << (ShearFrac - 1);
  logic      twin_ready, twin_valid, twin_tag;
  quotient_t qx, qy;
  side_t     out_side;
  div_pipe #(.NumW(ShearFrac), .QFrac(RecipW), .BitsPerStage(1), .Nearest(1'b0), .tag_t(side_t)) u_div_x (
    .clk_i, .rst_ni,
    .in_valid_i(norm_valid), .in_ready_o(norm_ready), .in_num_i(Num), .in_den_i(den_x_q), .in_tag_i(norm_side_q),
    .out_valid_o, .out_ready_i, .out_q_o(qx), .out_tag_o(out_side)
  );
  div_pipe #(.NumW(ShearFrac), .QFrac(RecipW), .BitsPerStage(1), .Nearest(1'b0), .tag_t(logic)) u_div_y (
    .clk_i, .rst_ni,
    .in_valid_i(norm_valid), .in_ready_o(twin_ready), .in_num_i(Num), .in_den_i(den_y_q), .in_tag_i(1'b0),
    .out_valid_o(twin_valid), .out_ready_i, .out_q_o(qy), .out_tag_o(twin_tag)
  );

  always_comb begin
    out_o    = out_side.ray;
    out_o.rx = recip(out_side.ray.sx, out_side.exp_x, qx);
    out_o.ry = recip(out_side.ray.sy, out_side.exp_y, qy);
  end

  logic unused_twin;   // the divisions move in step
  assign unused_twin = twin_ready ^ twin_valid ^ twin_tag;
endmodule
