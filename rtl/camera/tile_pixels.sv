// SPDX-License-Identifier: Apache-2.0
// The pixels of each tile row by row, from the tile's first one. One pixel a cycle, without a pause
// between tiles. miss_i goes with a tile and miss_o with its pixels. idle_o: no tile is under way.
// Model: cpp_model/camera/tile_walk.hpp (for_each_pixel), same order.
module tile_pixels
  import castray_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  tile_t      in_i,
  input  logic       miss_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output pixel_tag_t out_o,
  output logic       miss_o,
  output logic       idle_o
);
  logic       active_q, miss_q, last_x, last_y, next;
  pixel_tag_t pixel_q;
  pixel_t     first_x_q;
  logic [4:0] width_q, left_x_q, left_y_q;   // left: pixels and rows to come behind this one

  assign last_x      = left_x_q == '0;
  assign last_y      = left_y_q == '0;
  assign next        = !active_q || (out_ready_i && last_x && last_y);
  assign in_ready_o  = next;
  assign out_valid_o = active_q;
  assign out_o       = pixel_q;
  assign miss_o      = miss_q;
  assign idle_o      = !active_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) active_q <= 1'b0;
    else if (next) active_q <= in_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (next && in_valid_i) begin
      first_x_q <= in_i.x;
      width_q   <= in_i.width;
      pixel_q   <= '{slot: in_i.slot, y: in_i.y, x: in_i.x};
      left_x_q  <= in_i.width - 1'b1;
      left_y_q  <= in_i.height - 1'b1;
      miss_q    <= miss_i;
    end else if (active_q && out_ready_i) begin
      pixel_q.x <= last_x ? first_x_q : pixel_q.x + 1'b1;
      left_x_q  <= last_x ? width_q - 1'b1 : left_x_q - 1'b1;
      if (last_x) begin
        pixel_q.y <= pixel_q.y + 1'b1;
        left_y_q  <= left_y_q - 1'b1;
      end
    end
  end
endmodule
