// SPDX-License-Identifier: Apache-2.0
// One ray against one primitive, exactly: which line meets which triangle or sphere, and what is
// left to divide. The ray is P = org + z (Sx, Sy, 1) on permuted axes.
//           triangle A, B, C                          sphere, centre in a, radius R in b.x
//   s1-s3   corners from the origin; sx z, sy z       the centre likewise; |S|^2 R on B's multiplier
//   s4      sheared corners          (shear)          X, Y; N = |S|^2 R
//   s5-s7   six products             (edge_fns)       the same six multipliers, and Y Sy
//   s8      U, V, W and their signs                   Z
//   s9      accepted?                (accept)         Z^2 in s8-s10   (sphere_disc)
//   s10     |U|, |V|, |det|
//   s11     wait for the spheres                      disc, accepted if not negative
//   s12     out
// One test a cycle, 12 cycles from in_valid_i to out_valid_o or retire_o (never both), never
// stalls. An empty slot (NoPrim), and a sphere of radius 0 or of 2^25 and more, is never accepted.
// 28 DSPs. What only an accepted test needs again waits in small memories, not in every stage.
// Model: cpp_model/isect/ray_prim.hpp, equal bit for bit.
module ray_prim
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       in_valid_i,
  input  ctx_t       in_ctx_i,
  input  test_ray_t  in_ray_i,
  input  prim_slot_t in_prim_i,

  output logic       out_valid_o,
  output cand_t      out_o,
  output logic       retire_o
);
  localparam int unsigned Stages = 12;

  // ---- Control: bit k of each vector belongs to the item that enters stage k + 1 ----
  // test: any test. live: one that can be accepted. sphere, neg, cull: of a live one.
  logic [Stages-1:0] test;
  logic [7:0]        live, sphere, neg, cull;
  logic [Stages-1:1] test_q;
  logic [7:1]        live_q, sphere_q, neg_q, cull_q;
  coord_t            radius;
  logic              is_sphere;

  assign radius    = in_prim_i.b.x;
  assign is_sphere = in_prim_i.kind == KindSphere;
  assign test      = {test_q, in_valid_i};
  assign live      = {live_q, in_valid_i && in_prim_i.number != NoPrim
                              && !(is_sphere && (radius == '0 || radius[CoordW-1]))};
  assign sphere    = {sphere_q, is_sphere};
  assign neg       = {neg_q, in_ray_i.neg};
  assign cull      = {cull_q, in_ray_i.cull};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      test_q <= '0;
      live_q <= '0;
    end else begin
      test_q <= test[Stages-2:0];
      live_q <= live[6:0];
    end
    sphere_q <= sphere[6:0];
    neg_q    <= neg[6:0];
    cull_q   <= cull[6:0];
  end

  // ---- s1 to s4: sheared corners ----
  delta_t             ax, ay, az, bx, by, bz, cx, cy, cz;
  sheared_t           sheared_ax, sheared_ay, sheared_bx, sheared_by, sheared_cx, sheared_cy;
  logic signed [53:0] p_reach, unused_pa, unused_pc;
  shear_t             sx, sy;
  assign sx = in_ray_i.sx;
  assign sy = in_ray_i.sy;

  corner_delta u_delta_a (.point_i(in_prim_i.a), .org_i(in_ray_i.org), .axis_i(in_ray_i.axis),
                          .x_o(ax), .y_o(ay), .z_o(az));
  corner_delta u_delta_b (.point_i(in_prim_i.b), .org_i(in_ray_i.org), .axis_i(in_ray_i.axis),
                          .x_o(bx), .y_o(by), .z_o(bz));
  corner_delta u_delta_c (.point_i(in_prim_i.c), .org_i(in_ray_i.org), .axis_i(in_ray_i.axis),
                          .x_o(cx), .y_o(cy), .z_o(cz));

  shear u_shear_a (.clk_i, .en_i(live[3:0]), .x_i(ax), .y_i(ay), .z_i(az), .sx_i(sx), .sy_i(sy),
                   .x_o(sheared_ax), .y_o(sheared_ay), .px_o(unused_pa));
  shear u_shear_b (.clk_i, .en_i(live[3:0]), .x_i(bx), .y_i(by),
                   .z_i(is_sphere ? delta_t'({1'b0, radius}) : bz),
                   .sx_i(is_sphere ? shear_t'({1'b0, in_ray_i.norm2}) : sx), .sy_i(sy),
                   .x_o(sheared_bx), .y_o(sheared_by), .px_o(p_reach));
  shear u_shear_c (.clk_i, .en_i(live[3:0]), .x_i(cx), .y_i(cy), .z_i(cz), .sx_i(sx), .sy_i(sy),
                   .x_o(sheared_cx), .y_o(sheared_cy), .px_o(unused_pc));

  // ---- What is needed again: written as a test enters, at the place of that cycle ----
  localparam int unsigned PlaceW = $clog2(Stages);
  localparam int unsigned Places = 1 << PlaceW;
  typedef logic [PlaceW-1:0] place_t;
  typedef struct packed {
    ctx_t   ctx;
    prim_t  number;
    delta_t cz;
  } kept_t;
  typedef struct packed {
    shear_t sx, sy;
  } kept_shear_t;

  place_t       place_q;
  kept_t        kept_q [Places];
  logic [53:0]  kept_z_q [Places];       // a triangle's Az, Bz
  kept_shear_t  kept_shear_q [Places];   // of a sphere
  coord_t       kept_radius_q [Places];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= '0;
    else place_q <= place_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (live[0]) begin
      kept_q[place_q]   <= '{ctx: in_ctx_i, number: in_prim_i.number, cz: is_sphere ? az : cz};
      kept_z_q[place_q] <= {az, bz};
    end
    if (live[0] && sphere[0]) begin
      kept_shear_q[place_q]  <= '{sx: sx, sy: sy};
      kept_radius_q[place_q] <= radius;
    end
  end

  // A sphere's operands of s4.
  shear_t      sx4_q, sy4_q;
  delta_t      radius4_q, reach4_q;
  kept_shear_t kept_shear;
  assign kept_shear = kept_shear_q[place_q - place_t'(3)];
  always_ff @(posedge clk_i) begin
    if (live[3] && sphere[3]) begin
      sx4_q     <= kept_shear.sx;
      sy4_q     <= kept_shear.sy;
      radius4_q <= delta_t'({1'b0, kept_radius_q[place_q - place_t'(3)]});
      reach4_q  <= delta_t'((p_reach + (54'sd1 <<< NormFrac)) >>> (NormFrac + 1));
    end
  end

  // ---- s5 to s8: edge functions ----
  logic signed [53:0] p0, p1, p2, p3, p4, p5;
  logic signed [54:0] u8, v8, w8;
  logic               u_neg8, v_neg8, w_neg8, point8;
  logic               triangle8_q, neg8_q, cull8_q;

  edge_fns u_edge_fns (
    .clk_i, .en_i(live[6:4]), .fns_en_i(live[7] && !sphere[7]),
    .ax_i(sheared_ax), .ay_i(sheared_ay), .bx_i(sheared_bx), .by_i(sheared_by),
    .cx_i(sheared_cx), .cy_i(sheared_cy),
    .sphere_i(sphere[4]), .sx_i(sx4_q), .sy_i(sy4_q), .reach_i(reach4_q), .radius_i(radius4_q),
    .p0_o(p0), .p1_o(p1), .p2_o(p2), .p3_o(p3), .p4_o(p4), .p5_o(p5),
    .u_o(u8), .v_o(v8), .w_o(w8),
    .u_neg_o(u_neg8), .v_neg_o(v_neg8), .w_neg_o(w_neg8), .point_o(point8)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) triangle8_q <= 1'b0;
    else triangle8_q <= live[7] && !sphere[7];
    neg8_q  <= neg[7];
    cull8_q <= cull[7];
  end

  // ---- s9 to s11 ----
  logic               triangle10, triangle11_q, sphere11;
  logic        [54:0] u10, v10, u11_q, v11_q;
  logic        [55:0] det10, det11_q, disc11;
  logic signed [31:0] towards11;

  accept u_accept (
    .clk_i, .rst_ni, .valid_i(triangle8_q), .neg_i(neg8_q), .cull_i(cull8_q),
    .u_i(u8), .v_i(v8), .w_i(w8),
    .u_neg_i(u_neg8), .v_neg_i(v_neg8), .w_neg_i(w_neg8), .point_i(point8),
    .valid_o(triangle10), .u_o(u10), .v_o(v10), .det_o(det10)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) triangle11_q <= 1'b0;
    else triangle11_q <= triangle10;
  end
  always_ff @(posedge clk_i) begin
    if (triangle10) begin
      u11_q   <= u10;
      v11_q   <= v10;
      det11_q <= det10;
    end
  end

  sphere_disc u_sphere_disc (
    .clk_i, .rst_ni, .en_i(live[7:4] & sphere[7:4]), .y_i(sheared_ay), .sy_i(sy4_q),
    .p_xx_i(p0), .p_yy_i(p4), .p_xsx_i(p2), .p_ysx_i(p3), .p_xsy_i(p5), .p_nr_i(p1),
    .valid_o(sphere11), .disc_o(disc11), .towards_o(towards11)
  );

  // ---- s12 ----
  logic        accepted11;
  kept_t       kept11;
  logic [53:0] kept_z11;
  assign accepted11 = triangle11_q || sphere11;
  assign kept11     = kept_q[place_q - place_t'(Stages - 1)];
  assign kept_z11   = kept_z_q[place_q - place_t'(Stages - 1)];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      out_valid_o <= 1'b0;
      retire_o    <= 1'b0;
    end else begin
      out_valid_o <= accepted11;
      retire_o    <= test[Stages-1] && !accepted11;
    end
  end
  always_ff @(posedge clk_i) begin
    if (accepted11) begin
      out_o.ctx    <= kept11.ctx;
      out_o.number <= kept11.number;
      out_o.kind   <= sphere11 ? KindSphere : KindTriangle;
      out_o.u      <= sphere11 ? '0 : u11_q;
      out_o.v      <= sphere11 ? '0 : v11_q;
      out_o.det    <= sphere11 ? disc11 : det11_q;
      out_o.az     <= sphere11 ? towards11 : 32'($signed(kept_z11[53:27]));
      out_o.bz     <= sphere11 ? '0 : $signed(kept_z11[26:0]);
      out_o.cz     <= kept11.cz;
    end
  end
endmodule
