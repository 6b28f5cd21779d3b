// SPDX-License-Identifier: Apache-2.0
// Fills in what the tests of boxes need of a ray: rx and ry, one over |sx| and |sy|, rounded down.
//   s0      k = |S|, and its leading zeros, ShearFrac bits: exp
//   s1      k' = k << exp
//   s2-s7   mant = min(floor(2^(ShearFrac+RecipW-1) / k'), 2^RecipW - 1)      reciprocal, one each
//   out     of S = 0: mant 2^(RecipW-1), exp 31
// so that mant 2^(exp-16) <= 1/|S| <= (mant + 1) 2^(exp-16): the quotient exceeds RecipW bits for a power
// of two only, and then mant + 1 is exact. In the place of zero stands 2^-31, which leaves the node test
// exact: see docs/number-formats.md.
// One ray a cycle, in order; eight stages. The rest of the ray passes through. Four multipliers of 27x18.
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

  function automatic mag_t magnitude(shear_t s);
    return s[ShearFrac] ? -mag_t'(s) : mag_t'(s);
  endfunction

  function automatic exp_t leading_zeros(mag_t k);
    leading_zeros = '0;
    for (int unsigned i = 0; i < ShearFrac; i++) if (k[i]) leading_zeros = exp_t'(ShearFrac - 1 - i);
  endfunction

  function automatic recip_t recip(shear_t s, exp_t exp, logic [RecipW-1:0] mant);
    recip.zero  = s == '0;
    recip.minus = s[ShearFrac];
    recip.exp   = recip.zero ? '1 : exp;
    recip.mant  = recip.zero ? RecipW'(1) << (RecipW - 1) : mant;
  endfunction

  typedef struct packed {
    ray_t ray;
    exp_t exp_x;
    exp_t exp_y;
  } side_t;   // what travels beside the reciprocals

  localparam int unsigned Stages = 8;
  logic [Stages-1:0] load;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i),
    .load_o(load)
  );

  mag_t              kx_q, ky_q, den_x_q, den_y_q;
  side_t             side_q [Stages];
  logic [RecipW-1:0] mant_x, mant_y;

  reciprocal #(.DenW(ShearFrac)) u_x (.clk_i, .en_i(load[7:2]), .den_i(den_x_q), .q_o(mant_x));
  reciprocal #(.DenW(ShearFrac)) u_y (.clk_i, .en_i(load[7:2]), .den_i(den_y_q), .q_o(mant_y));

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      kx_q      <= magnitude(in_i.sx);
      ky_q      <= magnitude(in_i.sy);
      side_q[0] <= '{ray: in_i, exp_x: leading_zeros(magnitude(in_i.sx)), exp_y: leading_zeros(magnitude(in_i.sy))};
    end
    if (load[1]) begin
      den_x_q <= kx_q << side_q[0].exp_x;
      den_y_q <= ky_q << side_q[0].exp_y;
    end
    for (int unsigned i = 1; i < Stages; i++) if (load[i]) side_q[i] <= side_q[i-1];
  end

  always_comb begin
    out_o    = side_q[Stages-1].ray;
    out_o.rx = recip(side_q[Stages-1].ray.sx, side_q[Stages-1].exp_x, mant_x);
    out_o.ry = recip(side_q[Stages-1].ray.sy, side_q[Stages-1].exp_y, mant_y);
  end
endmodule
