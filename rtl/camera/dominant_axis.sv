// SPDX-License-Identifier: Apache-2.0
// The dominant axis of a direction, and the operands of its two shear divisions:
//   s0  magnitudes and signs
//   s1  axis = that of the largest magnitude, the lowest of equals
//       the components in the order (second, third, dominant): cyclic, see castray's axes
//   s2  shift that brings the dominant magnitude's top one to the top bit
//   s3  the three magnitudes shifted by it, their upper ShearDivW bits (the rest is dropped)
// num0, num1 <= den. A zero direction: valid 0, axis 0, all operands zero.
// Four stages, one direction a cycle, in order.
// Model: the first half of cpp_model/camera/ray_setup.hpp, equal bit for bit.
module dominant_axis
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter type tag_t = logic [31:0]
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  input  logic                 in_valid_i,
  output logic                 in_ready_o,
  input  dir_t                 in_dir_i,
  input  tag_t                 in_tag_i,

  output logic                 out_valid_o,
  input  logic                 out_ready_i,
  output logic [ShearDivW-1:0] out_num0_o,
  output logic [ShearDivW-1:0] out_num1_o,
  output logic [ShearDivW-1:0] out_den_o,
  output logic                 out_minus0_o,   // the quotient is negative
  output logic                 out_minus1_o,
  output axis_t                out_axis_o,
  output logic                 out_neg_o,      // the dominant component is negative
  output logic                 out_dir_valid_o,
  output tag_t                 out_tag_o
);
  localparam int unsigned MagW   = $bits(dir_comp_t);  // the most negative one needs them all
  localparam int unsigned ShiftW = $clog2(MagW);
  if (ShearDivW > MagW) begin : g_check
    $error("dominant_axis: ShearDivW must not exceed the width of a direction's component");
  end
  typedef logic [MagW-1:0] mag_t;

  // What a stage knows beside the magnitudes.
  typedef struct packed {
    tag_t  tag;
    axis_t axis;
    logic  minus0;
    logic  minus1;
    logic  neg;
  } side_t;

  function automatic mag_t magnitude(dir_comp_t v);
    return v[MagW-1] ? -mag_t'(v) : mag_t'(v);
  endfunction
  function automatic axis_t dominant(mag_t x, mag_t y, mag_t z);
    if (x >= y && x >= z) return 2'd0;
    return (y >= z) ? 2'd1 : 2'd2;
  endfunction
  function automatic logic [ShiftW-1:0] leading_zeros(mag_t v);
    leading_zeros = '0;
    for (int unsigned i = 0; i < MagW; i++) if (v[i]) leading_zeros = ShiftW'(MagW - 1 - i);
  endfunction
  function automatic logic [ShearDivW-1:0] upper(mag_t v, logic [ShiftW-1:0] shift);
    mag_t shifted;
    shifted = v << shift;
    return shifted[MagW-1 -: ShearDivW];
  endfunction
  // Element i of the order in which `axis` comes last.
  function automatic mag_t pick(mag_t x, mag_t y, mag_t z, axis_t axis, axis_t i);
    unique case ((axis + i) % 3)
      2'd0:    return y;
      2'd1:    return z;
      default: return x;
    endcase
  endfunction

  logic [3:0] load;
  pipe_chain #(.Stages(4)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i),
    .load_o(load)
  );

endmodule
