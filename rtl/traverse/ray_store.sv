// SPDX-License-Identifier: Apache-2.0
// The rays of a lane's contexts, in distributed memory addressed by context number: one write and a
// read for each unit that needs them a cycle. Reads are combinational.
// Model: cpp_model/traverse/ray_store.hpp.
module ray_store
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  localparam int unsigned IdxW = (Contexts > 1) ? $clog2(Contexts) : 1
) (
  input  logic            clk_i,

  input  logic            write_i,
  input  logic [IdxW-1:0] write_ctx_i,
  input  ray_t            ray_i,

  // For the primitive pipe.
  input  logic [IdxW-1:0] test_ctx_i,
  output test_ray_t       test_ray_o,

  // For who decides whether there is a test.
  input  logic [IdxW-1:0] look_ctx_i,
  output logic            look_valid_o,   // the ray can hit something
  output prim_t           look_ignore_o,

  // For the node pipe.
  input  logic [IdxW-1:0] node_ctx_i,
  output slab_ray_t       node_ray_o,

  // For the next steps.
  input  logic [IdxW-1:0] step_ctx_i [2],
  output logic [1:0]      step_any_hit_o,

  // For the hit unit.
  input  logic [IdxW-1:0] hit_ctx_i,
  output hit_ray_t        hit_ray_o,

  // For the lane's output.
  input  logic [IdxW-1:0] out_ctx_i,
  output pixel_tag_t      out_tag_o,
  output shear_t          out_sx_o,
  output shear_t          out_sy_o,
  output axis_t           out_axis_o,
  output logic            out_neg_o,
  output logic            out_any_hit_o
);
  // One array a field: what no unit reads together is not stored together.
  coord_t     org_x_q [Contexts];
  coord_t     org_y_q [Contexts];
  coord_t     org_z_q [Contexts];
  shear_t     sx_q    [Contexts];
  shear_t     sy_q    [Contexts];
  norm2_t     norm2_q [Contexts];
  axis_t      axis_q  [Contexts];
  recip_t     rx_q    [Contexts];
  recip_t     ry_q    [Contexts];
  logic [3:0] flags_q [Contexts];   // any_hit, valid, cull, neg
  t_t         tmin_q  [Contexts];
  prim_t      ignore_q[Contexts];
  pixel_tag_t tag_q   [Contexts];

  always_ff @(posedge clk_i) begin
    if (write_i) begin
      org_x_q[write_ctx_i]  <= ray_i.org.x;
      org_y_q[write_ctx_i]  <= ray_i.org.y;
      org_z_q[write_ctx_i]  <= ray_i.org.z;
      sx_q[write_ctx_i]     <= ray_i.sx;
      sy_q[write_ctx_i]     <= ray_i.sy;
      norm2_q[write_ctx_i]  <= ray_i.norm2;
      axis_q[write_ctx_i]   <= ray_i.axis;
      flags_q[write_ctx_i]  <= {ray_i.any_hit, ray_i.valid, ray_i.cull, ray_i.neg};
      rx_q[write_ctx_i]     <= ray_i.rx;
      ry_q[write_ctx_i]     <= ray_i.ry;
      tmin_q[write_ctx_i]   <= ray_i.tmin;
      ignore_q[write_ctx_i] <= ray_i.ignore;
      tag_q[write_ctx_i]    <= ray_i.tag;
    end
  end

  assign test_ray_o = '{
    org: '{x: org_x_q[test_ctx_i], y: org_y_q[test_ctx_i], z: org_z_q[test_ctx_i]},
    sx: sx_q[test_ctx_i], sy: sy_q[test_ctx_i], norm2: norm2_q[test_ctx_i],
    axis: axis_q[test_ctx_i], neg: flags_q[test_ctx_i][0], cull: flags_q[test_ctx_i][1]
  };
  assign look_valid_o  = flags_q[look_ctx_i][2];
  assign look_ignore_o = ignore_q[look_ctx_i];

  assign node_ray_o = '{
    org: '{x: org_x_q[node_ctx_i], y: org_y_q[node_ctx_i], z: org_z_q[node_ctx_i]},
    axis: axis_q[node_ctx_i], neg: flags_q[node_ctx_i][0],
    rx: rx_q[node_ctx_i], ry: ry_q[node_ctx_i], tmin: tmin_q[node_ctx_i]
  };

  assign step_any_hit_o = {flags_q[step_ctx_i[1]][3], flags_q[step_ctx_i[0]][3]};

  assign hit_ray_o = '{
    norm2: norm2_q[hit_ctx_i], neg: flags_q[hit_ctx_i][0], cull: flags_q[hit_ctx_i][1],
    tmin: tmin_q[hit_ctx_i]
  };

  assign out_tag_o  = tag_q[out_ctx_i];
  assign out_sx_o   = sx_q[out_ctx_i];
  assign out_sy_o   = sy_q[out_ctx_i];
  assign out_axis_o = axis_q[out_ctx_i];
  assign out_neg_o  = flags_q[out_ctx_i][0];
  assign out_any_hit_o = flags_q[out_ctx_i][3];
endmodule
