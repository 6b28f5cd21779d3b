// SPDX-License-Identifier: Apache-2.0
// Positions seen from the ray's origin, on axes permuted so that the dominant one comes last:
// (x, y, z) becomes (y, z, x) for axis 0, (z, x, y) for axis 1, itself otherwise. Combinational,
// exact for positions below 2^CoordW, else modulo 2^(CoordW+1); the permutation is cyclic, so a
// triangle keeps its orientation. The origin is permuted once for all of them, and subtracted in the
// LUT that chooses a position's coordinate: p - o as ~o - ~p, whose minuend is no multiplexer. With BackZ
// z is turned back: the origin seen from the position.
// Model: cpp_model/isect/corner_delta.hpp, equal bit for bit.
module corner_delta
  import castray_pkg::*;
#(
  parameter int unsigned Points = 1,
  parameter bit          BackZ  = 1'b0
) (
  input  point_t [Points-1:0] point_i,
  input  point_t              org_i,
  input  axis_t               axis_i,
  output delta_t [Points-1:0] x_o,
  output delta_t [Points-1:0] y_o,
  output delta_t [Points-1:0] z_o
);
  logic to0, to1;
  assign to0 = axis_i == 2'd0;
  assign to1 = axis_i == 2'd1;

  function automatic point_t permuted(point_t p, logic first, logic second);
    return '{x: first ? p.y : second ? p.z : p.x,
             y: first ? p.z : second ? p.x : p.y,
             z: first ? p.x : second ? p.y : p.z};
  endfunction
  function automatic delta_t minus(coord_t p, delta_t not_o);
    return not_o - ~delta_t'({1'b0, p});
  endfunction

  point_t org;
  delta_t not_x, not_y;
  assign org   = permuted(org_i, to0, to1);
  assign not_x = ~delta_t'({1'b0, org.x});
  assign not_y = ~delta_t'({1'b0, org.y});

  for (genvar i = 0; i < Points; i++) begin : g_point
    point_t point;
    assign point  = permuted(point_i[i], to0, to1);
    assign x_o[i] = minus(point.x, not_x);
    assign y_o[i] = minus(point.y, not_y);
    if (BackZ) begin : g_back
      assign z_o[i] = delta_t'({1'b0, org.z}) - delta_t'({1'b0, point.z});
    end else begin : g_ahead
      assign z_o[i] = minus(point.z, ~delta_t'({1'b0, org.z}));
    end
  end
endmodule
