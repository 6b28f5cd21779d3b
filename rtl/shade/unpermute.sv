// SPDX-License-Identifier: Apache-2.0
// A vector from a ray's permuted axes, the dominant one last, back to the scene's: (x, y, z)
// becomes (z, x, y) for axis 0, (y, z, x) for axis 1, itself otherwise. Combinational.
// Model: cpp_model/isect/corner_delta.hpp, unpermute.
module unpermute
  import castray_pkg::*;
(
  input  axis_t  axis_i,
  input  span3_t in_i,
  output span3_t out_o
);
  always_comb begin
    unique case (axis_i)
      2'd0:    out_o = '{x: in_i.z, y: in_i.x, z: in_i.y};
      2'd1:    out_o = '{x: in_i.y, y: in_i.z, z: in_i.x};
      default: out_o = in_i;
    endcase
  end
endmodule
