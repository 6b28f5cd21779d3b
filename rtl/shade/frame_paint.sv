// SPDX-License-Identifier: Apache-2.0
// The materials' parameters out of a frame record. Combinational.
// Model: cpp_model/shade/paint.hpp, frame_paint.
module frame_paint
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  frame_record_t record_i,
  output paint_t        paint_o
);
  assign paint_o = '{
    background:    rgb_t'(record_i.background[23:0]),
    colour_a:      rgb_t'(record_i.colour_a[23:0]),
    colour_b:      rgb_t'(record_i.colour_b[23:0]),
    checker_scale: checker_t'(record_i.checker_scale),
    swap_rb:       record_i.pixel_format == PixelBgra8
  };
endmodule
