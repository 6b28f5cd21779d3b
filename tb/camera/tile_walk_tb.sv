// SPDX-License-Identifier: Apache-2.0
// The walk and the pixels of its tiles in the three tile sizes: select_i says which.
module tile_walk_tb
  import castray_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic [1:0] select_i,     // tiles of 4 << select_i pixels

  input  logic       start_i,
  input  job_t       job_i,
  output logic       done_o,

  output logic       tile_valid_o,
  input  logic       tile_ready_i,
  output tile_t      tile_o,
  input  logic [7:0] tile_slot_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output pixel_tag_t out_o
);

  logic       done [3], tile_valid [3], out_valid [3];
  tile_t      tile [3];
  pixel_tag_t pixel [3];

  for (genvar i = 0; i < 3; i++) begin : g_size
    logic  walked, in_valid, in_ready, in_idle, unused_miss;
    tile_t in;
    tile_walk #(.TileLog2(2 + i)) u_walk (
      .clk_i, .rst_ni,
      .start_i(start_i && select_i == 2'(i)), .job_i, .done_o(walked),
      .tile_valid_o(tile_valid[i]), .tile_ready_i(tile_ready_i && select_i == 2'(i)), .tile_o(tile[i]), .tile_slot_i,
      .out_valid_o(in_valid), .out_ready_i(in_ready), .out_o(in)
    );
    tile_pixels u_pixels (
      .clk_i, .rst_ni(rst_ni && !start_i),
      .in_valid_i(in_valid), .in_ready_o(in_ready), .in_i(in), .miss_i(1'b0),
      .out_valid_o(out_valid[i]), .out_ready_i(out_ready_i && select_i == 2'(i)), .out_o(pixel[i]),
      .miss_o(unused_miss), .idle_o(in_idle)
    );
    assign done[i] = walked && in_idle;
  end

  assign done_o       = done[select_i];
  assign tile_valid_o = tile_valid[select_i];
  assign tile_o       = tile[select_i];
  assign out_valid_o  = out_valid[select_i];
  assign out_o        = pixel[select_i];
endmodule
