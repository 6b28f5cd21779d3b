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
  // One array for each reader, whose fields fill its memories without gaps.
  typedef struct packed {
    logic  valid;
    prim_t ignore;
  } look_t;
  typedef struct packed {
    pixel_tag_t tag;
    shear_t     sx;
    shear_t     sy;
    axis_t      axis;
    logic       neg;
    logic       any_hit;
  } out_t;
  test_ray_t test_q    [Contexts];
  look_t     look_q    [Contexts];
  slab_ray_t node_q    [Contexts];
  logic      any_hit_q [Contexts];   // for the steps
  hit_ray_t  hit_q     [Contexts];
  out_t      out_q     [Contexts];

  always_ff @(posedge clk_i) begin
    if (write_i) begin
      test_q[write_ctx_i]    <= '{org: ray_i.org, sx: ray_i.sx, sy: ray_i.sy, norm2: ray_i.norm2, axis: ray_i.axis,
                                  neg: ray_i.neg, cull: ray_i.cull};
      look_q[write_ctx_i]    <= '{valid: ray_i.valid, ignore: ray_i.ignore};
      node_q[write_ctx_i]    <= '{org: ray_i.org, axis: ray_i.axis, neg: ray_i.neg, rx: ray_i.rx, ry: ray_i.ry,
                                  tmin: ray_i.tmin};
      any_hit_q[write_ctx_i] <= ray_i.any_hit;
      hit_q[write_ctx_i]     <= '{norm2: ray_i.norm2, neg: ray_i.neg, cull: ray_i.cull, tmin: ray_i.tmin};
      out_q[write_ctx_i]     <= '{tag: ray_i.tag, sx: ray_i.sx, sy: ray_i.sy, axis: ray_i.axis, neg: ray_i.neg,
                                  any_hit: ray_i.any_hit};
    end
  end

  look_t look;
  out_t  out;
  assign look = look_q[look_ctx_i];
  assign out  = out_q[out_ctx_i];

  assign test_ray_o     = test_q[test_ctx_i];
  assign look_valid_o   = look.valid;
  assign look_ignore_o  = look.ignore;
  assign node_ray_o     = node_q[node_ctx_i];
  assign step_any_hit_o = {any_hit_q[step_ctx_i[1]], any_hit_q[step_ctx_i[0]]};
  assign hit_ray_o      = hit_q[hit_ctx_i];
  assign out_tag_o      = out.tag;
  assign out_sx_o       = out.sx;
  assign out_sy_o       = out.sy;
  assign out_axis_o     = out.axis;
  assign out_neg_o      = out.neg;
  assign out_any_hit_o  = out.any_hit;
endmodule
