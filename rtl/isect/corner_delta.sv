// SPDX-License-Identifier: Apache-2.0
// A position seen from the ray's origin, on axes permuted so that the dominant one comes last:
// (x, y, z) becomes (y, z, x) for axis 0, (z, x, y) for axis 1, itself otherwise. Combinational,
// exact for positions below 2^CoordW, else modulo 2^(CoordW+1); the permutation is cyclic, so a
// triangle keeps its orientation.
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
  logic   to0, to1;
  delta_t dx, dy, dz;
  assign to0 = axis_i == 2'd0;
  assign to1 = axis_i == 2'd1;

  assign dx = delta_t'({1'b0, point_i.x}) - delta_t'({1'b0, org_i.x});
  assign dy = delta_t'({1'b0, point_i.y}) - delta_t'({1'b0, org_i.y});
  assign dz = delta_t'({1'b0, point_i.z}) - delta_t'({1'b0, org_i.z});

  assign x_o = to0 ? dy : to1 ? dz : dx;
  assign y_o = to0 ? dz : to1 ? dx : dy;
  assign z_o = to0 ? dx : to1 ? dy : dz;
endmodule
