// SPDX-License-Identifier: Apache-2.0
// One ray against one primitive, exactly: which line meets which triangle or sphere, and what is
// left to divide. The ray is P = org + z (Sx, Sy, 1) on permuted axes.
//           triangle A, B, C                          sphere, centre in a, radius R in b.x
//   s1-s3   sheared corners          (shear)          X, Y; N = |S|^2 R on B's multiplier
//   s4-s6   six products             (edge_fns)       the same six multipliers, and N R
//   s7      U, V, W and their signs                   Z, and two sums of products
//   s8      accepted?                (accept)         Z^2 in s7-s9   (sphere_disc)
//   s9      |U|, |V|, |det|
//   s10     wait for the spheres                      disc, accepted if not negative
//   s11     out
// One test a cycle, 11 cycles from in_valid_i to out_valid_o or retire_o (never both), never
// stalls; out_o.ctx is the test's either way. An empty slot (NoPrim), and a sphere of radius 0 or
// of 2^(CoordW-1) and more, is never accepted. 28 DSPs. What only an accepted test needs again waits
// in block RAM, not in every stage.
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
  width_check u_widths ();
  localparam int unsigned Stages = 11;

  // ---- Control: bit k of each vector belongs to the item that enters stage k + 1 ----
  // test: any test. live: one that can be accepted. sphere, neg, cull: of a live one.
  logic [Stages-1:0] test;
  logic [6:0]        live, sphere, neg, cull;
  logic [Stages-1:1] test_q;
  logic [6:1]        live_q, sphere_q, neg_q, cull_q;
  coord_t            radius;
  logic              is_sphere;

  assign radius    = in_prim_i.b.x;
  assign is_sphere = in_prim_i.kind == KindSphere;
  assign test      = {test_q, in_valid_i};
  assign live      = {live_q, in_valid_i && in_prim_i.number != NoPrim
                              && !(is_sphere && (radius == '0 || (radius >> (CoordW - 1)) != '0))};
  assign sphere    = {sphere_q, is_sphere};
  assign neg       = {neg_q, in_ray_i.neg};
  assign cull      = {cull_q, in_ray_i.cull};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      test_q <= '0;
      live_q <= '0;
    end else begin
      test_q <= test[Stages-2:0];
      live_q <= live[5:0];
    end
    sphere_q <= sphere[5:0];
    neg_q    <= neg[5:0];
    cull_q   <= cull[5:0];
  end

  // ---- s1 to s3: sheared corners; x and y complemented, z turned back ----
  delta_t             ax, ay, az, bx, by, bz, cx, cy, cz;
  sheared_t           sheared_ax, sheared_ay, sheared_bx, sheared_by, sheared_cx, sheared_cy;
  shear_t             sx, sy;
  assign sx = in_ray_i.sx;
  assign sy = in_ray_i.sy;

  corner_delta #(.Points(3), .Back(1'b1)) u_delta (
    .point_i({in_prim_i.c, in_prim_i.b, in_prim_i.a}), .org_i(in_ray_i.org), .axis_i(in_ray_i.axis),
    .x_o({cx, bx, ax}), .y_o({cy, by, ay}), .z_o({cz, bz, az})
  );

  // A sphere's N = |S|^2 R, in units of two steps, is what B's shear makes of x = 2 R, -z = R and
  // sx = |S|^2 - 2, which lies in [-1, 1): norm2 without its top bit, the next one then its sign.
  delta_t radius_delta;
  assign radius_delta = delta_t'({1'b0, radius});

  shear u_shear_a (.clk_i, .en_i(live[2:0]), .not_x_i(ax), .not_y_i(ay), .back_z_i(az), .sx_i(sx), .sy_i(sy),
                   .x_o(sheared_ax), .y_o(sheared_ay));
  shear u_shear_b (.clk_i, .en_i(live[2:0]), .not_x_i(is_sphere ? ~(radius_delta <<< 1) : bx), .not_y_i(by),
                   .back_z_i(is_sphere ? radius_delta : bz),
                   .sx_i(is_sphere ? {in_ray_i.norm2[NormFrac:0], 2'b00} : sx), .sy_i(sy),
                   .x_o(sheared_bx), .y_o(sheared_by));
  shear u_shear_c (.clk_i, .en_i(live[2:0]), .not_x_i(cx), .not_y_i(cy), .back_z_i(cz), .sx_i(sx), .sy_i(sy),
                   .x_o(sheared_cx), .y_o(sheared_cy));

  // ---- What is needed again: written into block RAM as a test enters, at the place of that cycle, and read
  // a cycle before it is needed ----
  localparam int unsigned PlaceW = $clog2(Stages);
  localparam int unsigned Places = 1 << PlaceW;
  typedef logic [PlaceW-1:0] place_t;
  typedef struct packed {
    ctx_t   ctx;
    prim_t  number;
    delta_t az, bz, cz;   // turned back: of a triangle's corners; of a sphere cz is its centre's
  } kept_t;

  place_t place_q;
  (* ram_style = "block" *) kept_t kept_q [Places];
  kept_t  kept10_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= '0;
    else place_q <= place_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (test[0]) kept_q[place_q] <= '{ctx: in_ctx_i, number: in_prim_i.number, az: az, bz: bz, cz: is_sphere ? az : cz};
    if (test[Stages-2]) kept10_q <= kept_q[place_q - place_t'(Stages - 2)];
  end

  // A sphere's operands of s4 come along.
  typedef struct packed {
    shear_t sx, sy;
    coord_t radius;
  } operands_t;
  operands_t operands1_q, operands2_q, operands3_q;
  always_ff @(posedge clk_i) begin
    if (live[0] && sphere[0]) operands1_q <= '{sx: sx, sy: sy, radius: radius};
    if (live[1] && sphere[1]) operands2_q <= operands1_q;
    if (live[2] && sphere[2]) operands3_q <= operands2_q;
  end

  // ---- s4 to s7: edge functions ----
  mul_sum_t             v6, u7, v7, w7;
  logic               u_up7, v_up7, w_up7, point7;
  logic               triangle7_q, neg7_q, cull7_q;

  edge_fns u_edge_fns (
    .clk_i, .en_i(live[6:3]),
    .ax_i(sheared_ax), .ay_i(sheared_ay), .bx_i(sheared_bx), .by_i(sheared_by),
    .cx_i(sheared_cx), .cy_i(sheared_cy),
    .sphere_i(sphere[3]), .sx_i(operands3_q.sx), .sy_i(operands3_q.sy), .sums_i(sphere[6]),
    .v_d_o(v6), .u_o(u7), .v_o(v7), .w_o(w7), .u_up_o(u_up7), .v_up_o(v_up7), .w_up_o(w_up7), .point_o(point7)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) triangle7_q <= 1'b0;
    else triangle7_q <= live[6] && !sphere[6];
    neg7_q  <= neg[6];
    cull7_q <= cull[6];
  end

  // ---- s8 to s10 ----
  logic     triangle9, triangle10_q, sphere10;
  area_t    u9, v9, u10_q, v10_q;
  det_t     det9, det10_q, disc10;
  towards_t towards10;

  accept u_accept (
    .clk_i, .rst_ni, .valid_i(triangle7_q), .neg_i(neg7_q), .cull_i(cull7_q),
    .u_i(edge_fn_t'(u7)), .v_i(edge_fn_t'(v7)), .w_i(edge_fn_t'(w7)),
    .u_up_i(u_up7), .v_up_i(v_up7), .w_up_i(w_up7), .point_i(point7),
    .valid_o(triangle9), .u_o(u9), .v_o(v9), .det_o(det9)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) triangle10_q <= 1'b0;
    else triangle10_q <= triangle9;
  end
  always_ff @(posedge clk_i) begin
    if (triangle9) begin
      u10_q   <= u9;
      v10_q   <= v9;
      det10_q <= det9;
    end
  end

  sphere_disc u_sphere_disc (
    .clk_i, .rst_ni, .en_i(live[6:3] & sphere[6:3]), .reach_i(sheared_bx), .radius_i(delta_t'({1'b0, operands3_q.radius})),
    .cross_i(v6), .along_i(u7), .square_i(w7),
    .valid_o(sphere10), .disc_o(disc10), .towards_o(towards10)
  );

  // ---- s11 ----
  logic accepted10;
  assign accepted10 = triangle10_q || sphere10;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      out_valid_o <= 1'b0;
      retire_o    <= 1'b0;
    end else begin
      out_valid_o <= accepted10;
      retire_o    <= test[Stages-1] && !accepted10;
    end
  end
  always_ff @(posedge clk_i) begin
    if (test[Stages-1]) out_o.ctx <= kept10_q.ctx;
    if (accepted10) begin
      out_o.number <= kept10_q.number;
      out_o.kind   <= sphere10 ? KindSphere : KindTriangle;
      out_o.u      <= sphere10 ? '0 : u10_q;
      out_o.v      <= sphere10 ? '0 : v10_q;
      out_o.det    <= sphere10 ? disc10 : det10_q;
      out_o.az     <= sphere10 ? towards10 : towards_t'(kept10_q.az);
      out_o.bz     <= sphere10 ? '0 : kept10_q.bz;
      out_o.cz     <= kept10_q.cz;
    end
  end
endmodule
