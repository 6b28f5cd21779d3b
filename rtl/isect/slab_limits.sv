// SPDX-License-Identifier: Apache-2.0
// The ticks in which a hit may still be of use: between tmin and t, moved apart by a box's margin.
// z is t, or -t where the dominant component is negative.
//   s1  z of tmin - BoxMargin and of t + BoxMargin: first and last      whole steps
//   s2  from the node's first plane
//   s3  in ticks, rounded down, cut to 0 and the largest
// none_o: all of them lie before the node. They stay from s4 to s6, until the children are there.
// One node a cycle, never stalls; en_i[k]: stage k + 1 takes an item.
// Model: cpp_model/isect/slab_limits.hpp, equal bit for bit.
module slab_limits
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic       clk_i,

  input  logic [5:0] en_i,
  input  t_t         tmin_i,
  input  t_t         t_i,
  input  logic       neg_i,
  input  delta_t     dz_i,
  input  plane_exp_t ez_i,

  output logic       none_o,
  output tick_t      first_o,
  output tick_t      last_o
);
  localparam int unsigned StepW = CoordW + 3;   // the sum of a distance, a difference and the margin
  localparam int unsigned WideW = StepW + SubPlane;
  typedef logic signed [StepW-1:0] step_t;

  typedef struct packed {
    logic  none;
    tick_t first;
    tick_t last;
  } limits_t;

  // z of t in whole steps, moved: -t is ~t + 1.
  function automatic step_t z_of(t_t t, logic neg, step_t by);
    step_t steps;
    steps = step_t'(t >>> TFrac);
    return (neg ? by + 1'b1 : by) + (neg ? ~steps : steps);
  endfunction

  // In ticks, cut to a tick_t.
  function automatic tick_t cut(step_t z, plane_exp_t ez);
    logic [WideW-1:0] ticks, beyond;
    logic             fits;
    ticks  = {z, {SubPlane{1'b0}}};
    beyond = ({WideW{1'b1}} << $bits(tick_t)) << ez;
    fits   = (ticks & beyond) == '0;
    for (int k = 4; k >= 0; k--) if (ez[k]) ticks = ticks >> (1 << k);
    return z[StepW-1] ? '0 : fits ? tick_t'(ticks) : '1;
  endfunction

  step_t      first1_q, last1_q, first2_q, last2_q;
  delta_t     dz1_q;
  plane_exp_t ez1_q, ez2_q;
  limits_t    limits_q [4];

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      first1_q <= z_of(neg_i ? t_i : tmin_i, neg_i, -step_t'(BoxMargin));
      last1_q  <= z_of(neg_i ? tmin_i : t_i, neg_i, step_t'(BoxMargin));
      dz1_q    <= dz_i;
      ez1_q    <= ez_i;
    end
    if (en_i[1]) begin
      first2_q <= first1_q - step_t'(dz1_q);
      last2_q  <= last1_q - step_t'(dz1_q);
      ez2_q    <= ez1_q;
    end
    if (en_i[2]) limits_q[0] <= '{none: last2_q[StepW-1], first: cut(first2_q, ez2_q), last: cut(last2_q, ez2_q)};
    for (int unsigned i = 1; i < 4; i++) if (en_i[i+2]) limits_q[i] <= limits_q[i-1];
  end

  assign none_o  = limits_q[3].none;
  assign first_o = limits_q[3].first;
  assign last_o  = limits_q[3].last;
endmodule
