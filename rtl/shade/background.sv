// SPDX-License-Identifier: Apache-2.0
// The pixel of a ray that hit nothing: the background, unshaded. One a cycle, latency 1.
// Model: cpp_model/shade/background.hpp, equal bit for bit.
module background
  import castray_pkg::*;
(
  input  logic    clk_i,
  input  logic    rst_ni,

  input  paint_t  paint_i,

  input  logic    in_valid_i,
  output logic    in_ready_o,
  input  hit_t    in_i,          // not found

  output logic    out_valid_o,
  input  logic    out_ready_i,
  output shaded_t out_o
);
  // The frame's colour does not travel with the pixel.
  logic [31:0] word;
  pixel_tag_t  tag_q;
  pixel_word u_word (.colour_i(paint_i.background), .swap_rb_i(paint_i.swap_rb), .word_o(word));
  pipe_stage #(.data_t(pixel_tag_t)) u_tag (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o), .data_i(in_i.tag),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(tag_q)
  );
  assign out_o = '{tag: tag_q, colour: word};
endmodule
