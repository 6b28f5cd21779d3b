// SPDX-License-Identifier: Apache-2.0
// A colour as the word of a pixel, opaque: R in the lowest byte, or B for BGRA. Combinational.
// Model: cpp_model/shade/background.hpp, pixel_word.
module pixel_word
  import castray_pkg::*;
(
  input  rgb_t        colour_i,
  input  logic        swap_rb_i,
  output logic [31:0] word_o
);
  assign word_o = swap_rb_i ? {8'd255, colour_i.r, colour_i.g, colour_i.b}
                            : {8'd255, colour_i.b, colour_i.g, colour_i.r};
endmodule
