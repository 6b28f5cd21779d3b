// SPDX-License-Identifier: Apache-2.0
// What a record of a list asks for:
//   tmin, tmax   clamped to 0 and TMax
//   ignore       a number that no primitive can have: NoPrim
//   ok           0: it hits nothing. Its origin lies outside the scene's grid, a component of its
//                direction exceeds the format, or its range is empty
// legal_o: no flag is set that is none. Combinational.
// Model: cpp_model/mem/ray_request.hpp, equal bit for bit.
module ray_request
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  ray_record_t record_i,
  input  ray_no_t     number_i,

  output logic        legal_o,
  output ray_req_t    req_o
);
  localparam int unsigned CompW = $bits(dir_comp_t);

  function automatic t_t clamp(logic signed [31:0] t);
    return t[31] ? '0 : (t > 32'(TMax)) ? TMax : t_t'(t);
  endfunction

  function automatic logic on_grid(logic [31:0] coord);
    return coord[31:CoordW] == '0;
  endfunction

  // All bits above the format are its sign.
  function automatic logic fits(logic signed [63:0] component);
    return component[63:CompW-1] == '0 || component[63:CompW-1] == '1;
  endfunction

  t_t   tmin, tmax;
  logic some_range;
  assign tmin       = clamp(record_i.tmin);
  assign tmax       = clamp(record_i.tmax);
  assign some_range = tmin[CoordW+TFrac-1:0] < tmax[CoordW+TFrac-1:0];   // neither is negative

  assign legal_o = (record_i.flags >> NumRayFlags) == '0;
  assign req_o   = '{
    tag:     '{slot: '0, y: number_i[2*PixelW-1:PixelW], x: number_i[PixelW-1:0]},
    org:     '{x: coord_t'(record_i.org_x), y: coord_t'(record_i.org_y), z: coord_t'(record_i.org_z)},
    dir:     '{x: dir_comp_t'(record_i.dir_x), y: dir_comp_t'(record_i.dir_y), z: dir_comp_t'(record_i.dir_z)},
    tmin:    tmin,
    tmax:    tmax,
    cull:    record_i.flags[RayCull],
    any_hit: record_i.flags[RayAnyHit],
    ok:      some_range && on_grid(record_i.org_x) && on_grid(record_i.org_y) && on_grid(record_i.org_z) &&
             fits(record_i.dir_x) && fits(record_i.dir_y) && fits(record_i.dir_z),
    ignore:  (record_i.ignore[31:PrimW] != '0) ? NoPrim : record_i.ignore[PrimW-1:0]
  };
endmodule
