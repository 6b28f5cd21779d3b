// SPDX-License-Identifier: Apache-2.0
// Positions seen from the ray's origin, on axes permuted so that the dominant one comes last:
// (x, y, z) becomes (y, z, x) for axis 0, (z, x, y) for axis 1, itself otherwise. Combinational,
// exact for positions below 2^CoordW, else modulo 2^(CoordW+1); the permutation is cyclic, so a
// triangle keeps its orientation. The origin comes permuted, and is subtracted in the LUT that chooses a
// position's coordinate: p - o as ~o - ~p, whose minuend is no multiplexer. With Back the complements of x
// and y come, and z turned back, o - p - 1 and o - p: then the origin needs no inverters.
// Model: cpp_model/isect/corner_delta.hpp, equal bit for bit.
module corner_delta
  import castray_pkg::*;
#(
  parameter int unsigned Points = 1,
  parameter bit          Back   = 1'b0
) (
  input  point_t [Points-1:0] point_i,
  input  point_t              org_i,    // permuted
  input  axis_t               axis_i,
  output delta_t [Points-1:0] x_o,
  output delta_t [Points-1:0] y_o,
  output delta_t [Points-1:0] z_o
);
  for (genvar i = 0; i < Points; i++) begin : g_point
    point_t point;
    assign point = permute(point_i[i], axis_i);
    if (Back) begin : g_back
      assign x_o[i] = delta_t'({1'b0, org_i.x}) + ~delta_t'({1'b0, point.x});
      assign y_o[i] = delta_t'({1'b0, org_i.y}) + ~delta_t'({1'b0, point.y});
      assign z_o[i] = delta_t'({1'b0, org_i.z}) - delta_t'({1'b0, point.z});
    end else begin : g_ahead
      assign x_o[i] = ~delta_t'({1'b0, org_i.x}) - ~delta_t'({1'b0, point.x});
      assign y_o[i] = ~delta_t'({1'b0, org_i.y}) - ~delta_t'({1'b0, point.y});
      assign z_o[i] = ~delta_t'({1'b0, org_i.z}) - ~delta_t'({1'b0, point.z});
    end
  end
endmodule
