// SPDX-License-Identifier: Apache-2.0
// The dominant axis of a direction, and the operands of its two shear divisions:
//   s0  magnitudes and signs
//   s1  axis = that of the largest magnitude, the lowest of equals
//       the components in the order (second, third, dominant): cyclic: (y z x), (z x y), (x y z)
//   s2  shift that brings the dominant magnitude's top one to the top bit
//   s3  the three magnitudes shifted by it, their upper ShearDivW bits (the rest is dropped)
// num0, num1 <= den. A zero direction: axis 0, all operands zero; else den >= 2^(ShearDivW-1).
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
  output tag_t                 out_tag_o
);
  localparam int unsigned MagW   = $bits(dir_comp_t);  // the most negative one needs them all
  localparam int unsigned ShiftW = $clog2(MagW);
  if (ShearDivW > MagW) begin : g_check
    $error("dominant_axis: ShearDivW must not exceed the width of a direction's component");
  end
  typedef logic [MagW-1:0] mag_t;


  typedef struct packed {
    axis_t axis;
    logic  neg;
    logic  minus0;
    logic  minus1;
  } signs_t;

  typedef struct packed {
    signs_t signs;
    mag_t   n0;
    mag_t   n1;
    mag_t   dom;
  } ordered_t;

  function automatic mag_t magnitude(dir_comp_t v);
    return (mag_t'(v) ^ {MagW{v[MagW-1]}}) + mag_t'(v[MagW-1]);
  endfunction

  function automatic mag_t pick(axis_t axis, mag_t v0, mag_t v1, mag_t v2);
    return (axis == 2'd0) ? v0 : (axis == 2'd1) ? v1 : v2;
  endfunction

  // minus: the signs of x, y, z. A zero's sign bit is 0.
  function automatic ordered_t order(mag_t x, mag_t y, mag_t z, logic [2:0] minus);
    axis_t axis;
    axis = (x >= y && x >= z) ? 2'd0 : (y >= z) ? 2'd1 : 2'd2;
    order.n0  = pick(axis, y, z, x);
    order.n1  = pick(axis, z, x, y);
    order.dom = pick(axis, x, y, z);
    order.signs.axis   = axis;
    order.signs.neg    = minus[axis];
    order.signs.minus0 = minus[(axis == 2'd2) ? 2'd0 : axis + 2'd1] ^ minus[axis];
    order.signs.minus1 = minus[(axis == 2'd0) ? 2'd2 : axis - 2'd1] ^ minus[axis];
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

  logic [3:0] load;
  pipe_chain #(.Stages(4)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i),
    .load_o(load)
  );

  mag_t                 x_q, y_q, z_q, n0_q, n1_q, dom_q;
  logic [2:0]           minus_q;
  ordered_t             s1_q;
  signs_t               s2_signs_q, s3_signs_q;
  logic [ShiftW-1:0]    shift_q;
  logic [ShearDivW-1:0] num0_q, num1_q, den_q;
  tag_t                 tag_q [4];

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      x_q      <= magnitude(in_dir_i.x);
      y_q      <= magnitude(in_dir_i.y);
      z_q      <= magnitude(in_dir_i.z);
      minus_q  <= {in_dir_i.z[MagW-1], in_dir_i.y[MagW-1], in_dir_i.x[MagW-1]};
      tag_q[0] <= in_tag_i;
    end
    if (load[1]) begin
      s1_q     <= order(x_q, y_q, z_q, minus_q);
      tag_q[1] <= tag_q[0];
    end
    if (load[2]) begin
      n0_q       <= s1_q.n0;
      n1_q       <= s1_q.n1;
      dom_q      <= s1_q.dom;
      s2_signs_q <= s1_q.signs;
      shift_q    <= leading_zeros(s1_q.dom);
      tag_q[2]   <= tag_q[1];
    end
    if (load[3]) begin
      num0_q     <= upper(n0_q, shift_q);
      num1_q     <= upper(n1_q, shift_q);
      den_q      <= upper(dom_q, shift_q);
      s3_signs_q <= s2_signs_q;
      tag_q[3]   <= tag_q[2];
    end
  end

  assign out_num0_o   = num0_q;
  assign out_num1_o   = num1_q;
  assign out_den_o    = den_q;
  assign out_axis_o   = s3_signs_q.axis;
  assign out_neg_o    = s3_signs_q.neg;
  assign out_minus0_o = s3_signs_q.minus0;
  assign out_minus1_o = s3_signs_q.minus1;
  assign out_tag_o    = tag_q[3];
endmodule
