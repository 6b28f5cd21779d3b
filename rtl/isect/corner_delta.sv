// SPDX-License-Identifier: Apache-2.0
// A position seen from the ray's origin, on axes permuted so that the dominant one comes last:
// (x, y, z) becomes (y, z, x) for axis 0, (z, x, y) for axis 1, itself otherwise. Combinational,
// exact; the permutation is cyclic, so a triangle keeps its orientation.
// Model: cpp_model/isect/corner_delta.hpp, equal bit for bit.
module corner_delta
  import castray_pkg::*;
(
  input  point_t point_i,
  input  point_t org_i,
  input  axis_t  axis_i,
  output delta_t x_o,
  output delta_t y_o,
  output delta_t z_o
);
  function automatic coord_t pick(axis_t axis, coord_t axis0, coord_t axis1, coord_t axis2);
    unique case (axis)
      2'd0:    return axis0;
      2'd1:    return axis1;
      default: return axis2;
    endcase
  endfunction
  function automatic delta_t minus(coord_t a, coord_t b);
    return delta_t'({1'b0, a}) - delta_t'({1'b0, b});
  endfunction

  assign x_o = minus(pick(axis_i, point_i.y, point_i.z, point_i.x),
                     pick(axis_i, org_i.y, org_i.z, org_i.x));
  assign y_o = minus(pick(axis_i, point_i.z, point_i.x, point_i.y),
                     pick(axis_i, org_i.z, org_i.x, org_i.y));
  assign z_o = minus(pick(axis_i, point_i.x, point_i.y, point_i.z),
                     pick(axis_i, org_i.x, org_i.y, org_i.z));
endmodule
