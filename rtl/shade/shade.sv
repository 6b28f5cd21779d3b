// SPDX-License-Identifier: Apache-2.0
// The colour of a hit: the ray's direction, (Sx, Sy, 1) unpermuted, and the normal, interpolated
// or from the sphere's centre, go through ONE normaliser, one after the other; then paint.
//
//   in -+-> rays (FIFO) ---+-> direction, +-> normalise -+-> direction waits -+
//       +-> interpolate ---+   normal ----+              +-> normal ----------+-> paint -> out
//       +-> sphere_normal -+-> paints (FIFO) -----------------------------------+
//
// The head of `rays` says which unit has the next normal, so hits stay in order. The direction
// goes first, so that a normal leaves its unit in one cycle.
// Only found hits enter. One hit every two cycles, in order; latency 51 cycles for a triangle, 50
// for a sphere. 25 DSPs: 9 and 2 for the normals, 6 to normalise, 8 to paint.
// eye_i and paint_i stand still during a frame.
// Model: cpp_model/shade/shade.hpp, equal bit for bit.
module shade
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  point_t     eye_i,
  input  paint_t     paint_i,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  shade_req_t in_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output shaded_t    out_o,
  output logic       busy_o     // the normaliser takes a vector: counter event
);
  width_check u_widths ();
  localparam int unsigned RaysDepth   = 8;    // enough for a hit every two cycles through interpolate or sphere_normal
  localparam int unsigned PaintsDepth = 32;   // at least what normalise holds

  typedef struct packed {
    pixel_tag_t tag;
    logic       kind;
    logic [7:0] material;
    shear_t     sx;
    shear_t     sy;
    axis_t      axis;
  } ray_part_t;
  typedef struct packed {
    pixel_tag_t tag;
    logic       kind;
    logic [7:0] material;
    tex_t       s;
    tex_t       t;
  } paint_part_t;
  typedef struct packed {
    logic   normal;   // the second vector of a hit
    span3_t v;
  } vector_t;

  // ---- In: to the unit that makes the normal, the rest to `rays` ----
  logic sphere_in, rays_ready, rays_valid, rays_taken, tri_ready, sphere_ready;
  assign sphere_in  = in_i.hit.kind == KindSphere;
  assign in_ready_o = rays_ready && (sphere_in ? sphere_ready : tri_ready);

  ray_part_t ray;
  stream_fifo #(.data_t(ray_part_t), .Depth(RaysDepth)) u_rays (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i && in_ready_o), .ready_o(rays_ready),
    .data_i('{tag: in_i.hit.tag, kind: in_i.hit.kind, material: in_i.attr.material,
              sx: in_i.hit.sx, sy: in_i.hit.sy, axis: in_i.hit.axis}),
    .valid_o(rays_valid), .ready_i(rays_taken), .data_o(ray), .used_o()
  );

  logic    tri_valid, tri_taken, sphere_valid, sphere_taken;
  smooth_t smooth;
  span3_t  from_centre;
  interpolate u_interpolate (
    .clk_i, .rst_ni,
    .in_valid_i(in_valid_i && rays_ready && !sphere_in), .in_ready_o(tri_ready), .in_i,
    .out_valid_o(tri_valid), .out_ready_i(tri_taken), .out_o(smooth)
  );
  sphere_normal u_sphere (
    .clk_i, .rst_ni, .eye_i,
    .in_valid_i(in_valid_i && rays_ready && sphere_in), .in_ready_o(sphere_ready), .in_i,
    .out_valid_o(sphere_valid), .out_ready_i(sphere_taken), .out_o(from_centre)
  );

  // ---- Two vectors a hit ----
  function automatic span_t widen_shear(shear_t x);
    return span_t'(x);
  endfunction

  logic    second_q, normal_valid, paints_ready, vector_valid, vector_ready, vector_taken;
  span3_t  permuted, direction;
  vector_t vector, to_normalise;
  unpermute u_turn (.axis_i(ray.axis), .in_i(permuted), .out_o(direction));
  always_comb begin
    permuted = '{x: widen_shear(ray.sx), y: widen_shear(ray.sy), z: span_t'(1 << ShearFrac)};
    vector.normal = second_q;
    if (!second_q) vector.v = direction;
    else if (ray.kind == KindSphere) vector.v = from_centre;
    else vector.v = smooth.normal;
  end
  assign normal_valid = rays_valid && (ray.kind == KindSphere ? sphere_valid : tri_valid);
  assign vector_valid = second_q ? normal_valid && paints_ready : rays_valid;
  assign vector_taken = vector_valid && vector_ready;
  assign busy_o       = vector_taken;
  assign rays_taken   = vector_taken && second_q;
  assign tri_taken    = rays_taken && ray.kind != KindSphere;
  assign sphere_taken   = rays_taken && ray.kind == KindSphere;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (vector_taken) second_q <= !second_q;
  end

  logic to_valid, to_ready;
  pipe_cut #(.data_t(vector_t)) u_cut (
    .clk_i, .rst_ni,
    .valid_i(vector_valid), .ready_o(vector_ready), .data_i(vector),
    .valid_o(to_valid), .ready_i(to_ready), .data_o(to_normalise)
  );
  logic   unit_valid, unit_ready, unit_normal;
  unit3_t unit, view_q;
  normalise #(.tag_t(logic)) u_normalise (
    .clk_i, .rst_ni,
    .in_valid_i(to_valid), .in_ready_o(to_ready),
    .in_x_i(to_normalise.v.x), .in_y_i(to_normalise.v.y), .in_z_i(to_normalise.v.z),
    .in_tag_i(to_normalise.normal),
    .out_valid_o(unit_valid), .out_ready_i(unit_ready), .out_o(unit), .out_tag_o(unit_normal)
  );

  // ---- The rest of what paint takes waits here ----
  paint_part_t part;
  logic        part_valid, paint_ready, paint_valid;
  stream_fifo #(.data_t(paint_part_t), .Depth(PaintsDepth)) u_paints (
    .clk_i, .rst_ni,
    .valid_i(rays_taken), .ready_o(paints_ready),
    .data_i('{tag: ray.tag, kind: ray.kind, material: ray.material, s: smooth.s, t: smooth.t}),
    .valid_o(part_valid), .ready_i(paint_valid && paint_ready), .data_o(part), .used_o()
  );
  assign paint_valid = unit_valid && unit_normal && part_valid;
  assign unit_ready  = !unit_normal || (paint_ready && part_valid);
  always_ff @(posedge clk_i) begin
    if (unit_valid && !unit_normal) view_q <= unit;
  end

  paint u_paint (
    .clk_i, .rst_ni, .paint_i,
    .in_valid_i(paint_valid), .in_ready_o(paint_ready),
    .in_i('{tag: part.tag, kind: part.kind, material: part.material, s: part.s, t: part.t,
            normal: unit, view: view_q}),
    .out_valid_o, .out_ready_i, .out_o
  );

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (paints_ready || !vector_ready) else $error("normalise holds more hits than PaintsDepth");
  end
`endif
endmodule
