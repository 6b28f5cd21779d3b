// SPDX-License-Identifier: Apache-2.0
// The rays of a frame, tile by tile: tile_walk -> ray_gen -> ray_setup. Instances and wires only.
// One ray a cycle, in the walk's order; a tile is offered to the gather before its pixels come.
// Model: ray_setup(ray_gen(pixel)) over the pixels of cpp_model/camera/tile_walk.hpp, equal bit for bit.
module ray_source
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned TileLog2 = DefaultTileLog2,
  parameter int unsigned Slots    = tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2)
) (
  input  logic    clk_i,
  input  logic    rst_ni,

  input  logic    start_i,
  input  job_t    job_i,          // held from the start until done, as the camera
  input  camera_t camera_i,
  output logic    walk_done_o,    // every pixel has been issued
  output logic    none_in_setup_o,
  output logic    exhausted_o,    // both: no more rays come

  output logic    tile_valid_o,
  input  logic    tile_ready_i,
  output tile_t   tile_o,

  output logic    out_valid_o,
  input  logic    out_ready_i,
  output ray_t    out_o
);
  logic       px_valid, px_ready, dir_valid, dir_ready;
  pixel_tag_t px;
  pixel_dir_t dir;

  tile_walk #(.TileLog2(TileLog2), .Slots(Slots)) u_tile_walk (
    .clk_i, .rst_ni,
    .start_i, .job_i, .done_o(walk_done_o),
    .tile_valid_o, .tile_ready_i, .tile_o,
    .out_valid_o(px_valid), .out_ready_i(px_ready), .out_o(px)
  );

  ray_gen u_ray_gen (
    .clk_i, .rst_ni, .camera_i,
    .in_valid_i(px_valid), .in_ready_o(px_ready), .in_i(px),
    .out_valid_o(dir_valid), .out_ready_i(dir_ready), .out_o(dir)
  );

  ray_setup u_ray_setup (
    .clk_i, .rst_ni, .camera_i,
    .in_valid_i(dir_valid), .in_ready_o(dir_ready), .in_i(dir),
    .out_valid_o, .out_ready_i, .out_o
  );

  credit #(.Limit(Slots << (2 * TileLog2))) u_in_setup (   // the pixels of all tiles in flight
    .clk_i, .rst_ni,
    .take_i(px_valid && px_ready), .give_i(out_valid_o && out_ready_i),
    .available_o(), .idle_o(none_in_setup_o)
  );
  assign exhausted_o = walk_done_o && none_in_setup_o;
endmodule
