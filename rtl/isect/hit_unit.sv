// SPDX-License-Identifier: Apache-2.0
// The distance of an accepted primitive, and where on it: two divisions, then
//   triangle   u = U / det, v = V / det, t = Cz + u (Az - Cz) + v (Bz - Cz)
//   sphere     t = Cz + (b -+ root) / |S|^2                       (units and roundings: the parts)
// on permuted axes, then turned into the ray's direction.
//   s1         the candidate
//   s2, s3     a triangle's shift (hit_norm); a sphere's root comes first (hit_sphere)
//   div_pair   operands of HitDivW bits, BaryFrac fraction bits, nearest
//   tail       hit_distance
// One candidate a cycle, but none (in_ready_o) where it would meet a sphere whose root is taken. Nothing
// stalls behind that: a result is always taken. retire_o: the candidate of out_o.ctx in lane out_lane_o is
// finished, whether emitted or not; out_valid_o comes with retire_o. Triangles come out in order, and so do
// spheres. What the divisions do not need waits in the tail's memories. 14 DSPs.
// Model: cpp_model/isect/hit_unit.hpp, equal bit for bit.
module hit_unit
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     in_valid_i,
  output logic     in_ready_o,
  input  cand_t    in_i,
  input  hit_ray_t in_ray_i,
  input  lane_no_t in_lane_i,

  output logic     out_valid_o,
  output result_t  out_o,
  output lane_no_t out_lane_o,
  output logic     retire_o
);
  localparam int unsigned DivCycles  = 12;   // div_pair's, as many as its en_i has bits
  localparam int unsigned RootCycles = (CoordW + 2) / 2;
  // A candidate's place in the tail's memories is the cycle in which it enters: there are more places than
  // cycles that any is inside, a sphere's root, three cycles to the divisions, and seven behind it.
  localparam int unsigned PlaceW = HitPlaceW;
  if (RootCycles + 3 + DivCycles + 7 >= 1 << PlaceW) begin : g_check
    $error("hit_unit: a candidate is inside for more cycles than there are places");
  end
  typedef logic [PlaceW-1:0] place_t;

  width_check u_widths ();

  place_t place_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= '0;
    else place_q <= place_q + 1'b1;
  end

  // ---- s1 ----
  logic     take, soon, valid1_q, valid2_q;
  cand_t    cand_q;
  hit_ray_t ray_q;
  place_t   place1_q, place2_q;
  logic     triangle1, sphere1;

  assign in_ready_o = !soon;
  assign take       = in_valid_i && in_ready_o;
  assign triangle1  = valid1_q && cand_q.kind == KindTriangle;
  assign sphere1    = valid1_q && cand_q.kind == KindSphere;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid2_q <= 1'b0;
    end else begin
      valid1_q <= take;
      valid2_q <= triangle1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      cand_q   <= in_i;
      ray_q    <= in_ray_i;
      place1_q <= place_q;
    end
  end

  // ---- s2, s3: the two divisions, of a triangle or of a sphere ----
  logic [HitDivW-1:0] tri_num0, tri_num1, tri_den, sphere_num0, sphere_num1, sphere_den;
  delta_t             sphere_scale0, sphere_scale1, scale0_2q, scale1_2q;
  logic               sphere3;
  place_t             sphere_place;

  // The difference b - a of two corners' coordinates that come turned back. Both lie on the grid: it fits.
  function automatic delta_t minus(towards_t a, delta_t b);
    return b - delta_t'(a);
  endfunction

  hit_norm u_norm (
    .clk_i, .en_i(triangle1), .u_i(cand_q.u), .v_i(cand_q.v), .det_i(cand_q.det),
    .num0_o(tri_num0), .num1_o(tri_num1), .den_o(tri_den)
  );
  always_ff @(posedge clk_i) begin
    if (triangle1) begin
      scale0_2q <= minus(cand_q.az, cand_q.cz);
      scale1_2q <= minus(towards_t'(cand_q.bz), cand_q.cz);
      place2_q  <= place1_q;
    end
  end

  hit_sphere #(.tag_t(place_t)) u_sphere (
    .clk_i, .rst_ni,
    .valid_i(sphere1), .disc_i(cand_q.det[2*CoordW-2:0]), .towards_i(cand_q.az),
    .neg_i(ray_q.neg), .norm2_i(ray_q.norm2), .tag_i(place1_q),
    .soon_o(soon), .valid_o(sphere3),
    .num0_o(sphere_num0), .num1_o(sphere_num1), .den_o(sphere_den),
    .scale0_o(sphere_scale0), .scale1_o(sphere_scale1), .tag_o(sphere_place)
  );

  typedef struct packed {
    delta_t scale0;
    delta_t scale1;
  } scales_t;
  logic               valid3_q;
  place_t             place3_q;
  scales_t            scales3_q;
  logic [HitDivW-1:0] num0_q, num1_q, den_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid3_q <= 1'b0;
    else valid3_q <= valid2_q || sphere3;
  end
  always_ff @(posedge clk_i) begin
    if (valid2_q || sphere3) begin
      num0_q    <= sphere3 ? sphere_num0 : tri_num0;
      num1_q    <= sphere3 ? sphere_num1 : tri_num1;
      den_q     <= sphere3 ? sphere_den : tri_den;
      scales3_q <= sphere3 ? '{scale0: sphere_scale0, scale1: sphere_scale1}
                           : '{scale0: scale0_2q, scale1: scale1_2q};
      place3_q  <= sphere3 ? sphere_place : place2_q;
    end
  end

  // ---- The divisions; the scales and the place wait beside them, at the place of the cycle ----
  localparam int unsigned DivPlaceW = $clog2(DivCycles + 1);
  typedef logic [DivPlaceW-1:0] div_place_t;
  typedef struct packed {
    place_t  place;
    scales_t scales;
  } waiting_t;
  logic [DivCycles-1:0] dividing_q;   // bit k: stage k + 1 holds a candidate
  bary_t [1:0]          q;
  div_place_t           div_place;
  waiting_t             waiting_q [1 << DivPlaceW];
  waiting_t             waiting;
  assign div_place = div_place_t'(place_q);
  assign waiting   = waiting_q[div_place - div_place_t'(DivCycles)];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) dividing_q <= '0;
    else dividing_q <= {dividing_q[DivCycles-2:0], valid3_q};
  end
  always_ff @(posedge clk_i) begin
    if (valid3_q) waiting_q[div_place] <= '{place: place3_q, scales: scales3_q};
  end

  div_pair #(.DenW(HitDivW), .QFrac(BaryFrac)) u_divide (
    .clk_i, .en_i({dividing_q[DivCycles-2:0], valid3_q}), .num_i({num1_q, num0_q}), .den_i(den_q), .q_o(q)
  );

  // ---- The tail ----
  hit_distance #(.PlaceW(PlaceW)) u_distance (
    .clk_i, .rst_ni,
    .put_i(take), .put_place_i(place_q), .put_ctx_i(in_i.ctx), .put_number_i(in_i.number), .put_kind_i(in_i.kind),
    .put_cz_i(-in_i.cz), .put_lane_i(in_lane_i), .put_ray_i(in_ray_i),
    .q_valid_i(dividing_q[DivCycles-1]), .q_place_i(waiting.place), .q0_i(q[0]), .q1_i(q[1]),
    .scale0_i(waiting.scales.scale0), .scale1_i(waiting.scales.scale1),
    .done_o(retire_o), .out_valid_o, .out_o, .out_lane_o
  );

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && valid3_q) assert (num0_q <= den_q && num1_q <= den_q) else $error("a quotient above one");
  end
`endif
endmodule
