// SPDX-License-Identifier: Apache-2.0
// A ray against the boxes of a node's four children: which it visits, near ones first.
//   s1      the node from the ray's origin, on permuted axes; is it legal?   (corner_delta)
//   s1-s4   its planes across the two axes that are not dominant             (slab_axis)
//   s1-s6   each child's box                                                 (slab_child)
//           and what tmin and the nearest t leave of the ray                 (slab_limits)
//   s6-s8   order; s8 is combinational                                       (node_order)
// A child is dropped only if the line misses its box, or passes it where no hit that is reported for
// its inside could lie between tmin and t: docs/number-formats.md, "The test of a node". Of a node
// that no scene image may hold no child is visited, and error_o is set with out_valid_o.
// One node a cycle, 7 cycles, never stalls. 20 DSPs.
// Model: cpp_model/isect/node_pipe.hpp, equal bit for bit in what is read: of an entry without a target, only its kind.
module node_pipe
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic      clk_i,
  input  logic      rst_ni,

  input  logic      in_valid_i,
  input  ctx_t      in_ctx_i,
  input  slab_ray_t in_ray_i,
  input  node_t     in_node_i,
  input  t_t        in_t_i,

  output logic      out_valid_o,
  output ctx_t      out_ctx_o,
  output visits_t   out_o,
  output logic      error_o
);
  width_check u_widths ();
  localparam int unsigned Stages = 7;   // registers

  // Bit k belongs to the item that enters stage k + 1.
  logic [Stages:0] en;
  logic [Stages:1] valid_q;
  assign en = {valid_q, in_valid_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= en[Stages-1:0];
  end

  // ---- The node's words ----
  function automatic logic is_ref(ref_word_t word);
    return word[31:LineW+2] == '0 && (word[LineW +: 2] == RefNode || word[LineW +: 2] == RefLeaf);
  endfunction

  child_box_t [3:0] box;
  ref_word_t [3:0]  words;
  ref_t [3:0]       target;
  logic [3:0]       exists;
  logic             legal;
  assign box   = {in_node_i.box3, in_node_i.box2, in_node_i.box1, in_node_i.box0};
  assign words = {in_node_i.ref3, in_node_i.ref2, in_node_i.ref1, in_node_i.ref0};
  for (genvar i = 0; i < 4; i++) begin : g_target
    assign target[i] = ref_t'(words[i]);
  end
  always_comb begin
    logic [3:0] is_none;
    is_none = '0;
    exists  = '0;
    legal   = 1'b0;
    if (in_valid_i) begin
      legal = in_node_i.exp_x <= plane_exp_t'(MaxPlaneExp) && in_node_i.exp_y <= plane_exp_t'(MaxPlaneExp)
              && in_node_i.exp_z <= plane_exp_t'(MaxPlaneExp);
      for (int unsigned i = 0; i < 4; i++) begin
        exists[i]  = is_ref(words[i]);
        is_none[i] = words[i] == '0;
        if (!exists[i] && !is_none[i]) legal = 1'b0;
        if (i > 0 && exists[i] && is_none[i-1]) legal = 1'b0;
      end
    end
  end

  // ---- On the ray's axes ----
  point_t     origin;
  delta_t     dx, dy, dz;
  plane_exp_t ex, ey, ez;
  assign origin = '{x: in_node_i.x, y: in_node_i.y, z: in_node_i.z};
  corner_delta u_delta (.point_i(origin), .org_i(in_ray_i.org), .axis_i(in_ray_i.axis), .x_o(dx), .y_o(dy), .z_o(dz));
  always_comb begin
    unique case (in_ray_i.axis)
      2'd0:    {ex, ey, ez} = {in_node_i.exp_y, in_node_i.exp_z, in_node_i.exp_x};
      2'd1:    {ex, ey, ez} = {in_node_i.exp_z, in_node_i.exp_x, in_node_i.exp_y};
      default: {ex, ey, ez} = {in_node_i.exp_x, in_node_i.exp_y, in_node_i.exp_z};
    endcase
  end

  // ---- What is needed again: the children's references are written into block RAM as a node enters, at the
  // place of that cycle, and read two cycles before they are needed; the rest comes along ----
  localparam int unsigned PlaceW = $clog2(Stages);
  typedef logic [PlaceW-1:0] place_t;
  typedef struct packed {
    logic       neg;
    delta_t     dz;
    plane_exp_t ez;
  } plane_of_t;   // for s6
  typedef struct packed {
    ctx_t       ctx;
    logic       error;
    ref_t [3:0] target;
  } kept_node_t;    // for s8

  place_t     place_q;
  plane_of_t  plane_q [5];
  logic [3:0] exists_q [6];   // for s7
  (* ram_style = "block" *) kept_node_t kept_node_q [1 << PlaceW];
  kept_node_t node7_q, node8_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= '0;
    else place_q <= place_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (in_valid_i) begin
      plane_q[0]           <= '{neg: in_ray_i.neg, dz: dz, ez: ez};
      exists_q[0]          <= legal ? exists : '0;
      kept_node_q[place_q] <= '{ctx: in_ctx_i, error: !legal, target: target};
    end
    for (int unsigned i = 1; i < 5; i++) if (en[i]) plane_q[i] <= plane_q[i-1];
    for (int unsigned i = 1; i < 6; i++) if (en[i]) exists_q[i] <= exists_q[i-1];
    if (en[5]) node7_q <= kept_node_q[place_q - place_t'(5)];
    if (en[6]) node8_q <= node7_q;
  end

  // ---- s1 to s6 ----
  logic [1:0] [9:0]  mant;
  logic [1:0] [10:0] more;
  logic [1:0]       minus;
  slab_t [1:0]      slab_low, slab_high;
  logic [1:0] [3:0] left;
  slab_axis u_axis_x (
    .clk_i, .en_i(en[3:0]), .recip_i(in_ray_i.rx), .d_i(dx), .e_i(ex), .dz_i(dz), .ez_i(ez),
    .mant_o(mant[0]), .more_o(more[0]), .minus_o(minus[0]), .low_o(slab_low[0]), .high_o(slab_high[0]), .left_o(left[0])
  );
  slab_axis u_axis_y (
    .clk_i, .en_i(en[3:0]), .recip_i(in_ray_i.ry), .d_i(dy), .e_i(ey), .dz_i(dz), .ez_i(ez),
    .mant_o(mant[1]), .more_o(more[1]), .minus_o(minus[1]), .low_o(slab_low[1]), .high_o(slab_high[1]), .left_o(left[1])
  );

  logic  limits_none;
  tick_t first, last;
  slab_limits u_limits (
    .clk_i, .en_i(en[5:0]), .tmin_i(in_ray_i.tmin), .t_i(in_t_i), .neg_i(in_ray_i.neg), .dz_i(dz), .ez_i(ez),
    .none_o(limits_none), .first_o(first), .last_o(last)
  );

  logic [3:0]  none;
  tick_t [3:0] low, high;
  for (genvar i = 0; i < 4; i++) begin : g_child
    slab_child u_child (
      .clk_i, .en_i(en[5:0]), .box_i(box[i]), .axis_i(in_ray_i.axis),
      .mant_i(mant), .more_i(more), .minus_i(minus), .low_i(slab_low), .high_i(slab_high), .left_i(left),
      .none_o(none[i]), .low_o(low[i]), .high_o(high[i])
    );
  end

  // ---- s6 to s8 ----
  node_order u_order (
    .clk_i, .en_i(en[6:5]), .neg_i(plane_q[4].neg), .dz_i(plane_q[4].dz), .ez_i(plane_q[4].ez),
    .exists_i(exists_q[5]), .none_i(none), .low_i(low), .high_i(high),
    .limits_none_i(limits_none), .first_i(first), .last_i(last), .target_i(node8_q.target),
    .out_o
  );

  assign out_valid_o = en[7];
  assign out_ctx_o   = node8_q.ctx;
  assign error_o     = node8_q.error;
endmodule
