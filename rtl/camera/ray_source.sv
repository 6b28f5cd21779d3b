// SPDX-License-Identifier: Apache-2.0
// The rays of a frame, tile by tile, or those of a list. Instances, and which of them share a pipe.
//
//   tile_walk -> tile_start -> tile_deal -> tile_pixels -+-> ray_gen -+
//                  ^   |                                 |            |
//                  |   +--------- corner pixels ---------+            v
//                  |                                              ray_choice <- list
//                  |                                                  |
//                  +-- corner rays --+-- ray_setup <------------------+
//                                    +-> slab_setup -> out
//
// A tile is offered to the gather (tile_*) before its pixels come. One ray a cycle, corners before
// others. A tile that no ray of it can hit is filled (fill_*), or where hits are wanted gives its
// pixels at miss_*. With job_i.is_list only the rays of list_* come, and nothing walks. Every input
// but the streams stands still from start_i until done.
// Models: cpp_model/camera/tile_walk.hpp, ray_gen.hpp, ray_setup.hpp, slab_setup.hpp,
// cpp_model/traverse/tile_start.hpp, equal bit for bit.
module ray_source
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Lanes    = DefaultLanes,
  parameter int unsigned TileLog2 = DefaultTileLog2,
  parameter int unsigned Slots    = tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2)
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             start_i,        // a frame
  input  job_t             job_i,
  input  camera_t          camera_i,
  input  ref_t             root_i,
  input  line_no_t         nodes_i,        // where the nodes begin
  input  logic [31:0]      node_count_i,
  output error_t           fault_o,
  output logic             walk_done_o,    // every pixel, or ray of the list, has been issued
  output logic             none_in_setup_o,
  output logic             exhausted_o,    // both: no more rays come

  input  logic             list_valid_i,
  output logic             list_ready_o,
  input  ray_req_t         list_i,
  input  logic             list_done_i,    // every ray has been taken

  output logic             tile_valid_o,
  input  logic             tile_ready_i,
  output tile_t            tile_o,
  input  logic [7:0]       tile_slot_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output ray_t             out_o,

  output logic             miss_valid_o,   // a pixel whose ray hits nothing
  input  logic             miss_ready_i,
  output pixel_tag_t       miss_o,

  output logic             fill_valid_o,   // a tile of such pixels
  input  logic             fill_ready_i,
  output logic [7:0]       fill_slot_o,

  output logic             deal_valid_o,   // which lane a tile's rays go to, and how they start
  output lane_no_t         deal_lane_o,
  output started_t         deal_o,
  input  logic [Lanes-1:0] left_i,         // a ray left its lane's queue

  output logic             store_valid_o,  // a node of the frontier of the tile in a slot
  output logic [7:0]       store_slot_o,
  output logic             store_second_o,
  output node_t            store_node_o,

  output logic             req_valid_o,    // nodes for tile_start
  input  logic             req_ready_i,
  output line_req_t        req_o,
  input  logic             fill_line_valid_i,
  output logic             fill_line_ready_o,
  input  line_fill_t       fill_line_i,

  output logic             node_o,         // counter events
  output logic             node_busy_o,    // one is split
  output logic             node_hit_o,
  output logic             node_miss_o
);
  // ---- Tiles ----
  logic       walked, walk_valid, walk_ready, started_valid, started_ready, pixels_valid, pixels_ready;
  logic       pixels_idle, tile_miss, corner_valid, corner_ready, corner_ray_valid, corner_ray_ready;
  logic       started_idle, dealt_idle;
  tile_t      walk;
  started_t   started;
  pixel_tag_t corner;
  ray_t       ray;

  tile_walk #(.TileLog2(TileLog2)) u_tile_walk (
    .clk_i, .rst_ni,
    .start_i, .job_i, .done_o(walked),
    .tile_valid_o, .tile_ready_i, .tile_o, .tile_slot_i,
    .out_valid_o(walk_valid), .out_ready_i(walk_ready), .out_o(walk)
  );

  tile_start #(.Tiles(StartTiles)) u_tile_start (
    .clk_i, .rst_ni,
    .direct_i(job_i.brute || job_i.from_root), .eye_i(camera_i.eye), .root_i, .nodes_i, .node_count_i, .fault_o,
    .in_valid_i(walk_valid), .in_ready_o(walk_ready), .in_i(walk),
    .corner_valid_o(corner_valid), .corner_ready_i(corner_ready), .corner_o(corner),
    .ray_valid_i(corner_ray_valid), .ray_ready_o(corner_ray_ready), .ray_i(ray),
    .out_valid_o(started_valid), .out_ready_i(started_ready), .out_o(started), .idle_o(started_idle),
    .store_valid_o, .store_slot_o, .store_second_o, .store_node_o,
    .req_valid_o, .req_ready_i, .req_o,
    .fill_valid_i(fill_line_valid_i), .fill_ready_o(fill_line_ready_o), .fill_i(fill_line_i),
    .node_o, .busy_o(node_busy_o), .hit_o(node_hit_o), .miss_o(node_miss_o)
  );

  tile_deal #(.Lanes(Lanes), .TileLog2(TileLog2)) u_tile_deal (
    .clk_i, .rst_ni, .direct_i(job_i.brute), .each_miss_i(job_i.want_hits),
    .in_valid_i(started_valid), .in_ready_o(started_ready), .in_i(started), .idle_o(dealt_idle),
    .pixels_valid_o(pixels_valid), .pixels_ready_i(pixels_ready), .miss_o(tile_miss), .out_o(deal_o),
    .fill_valid_o, .fill_ready_i, .fill_slot_o,
    .deal_valid_o, .deal_lane_o, .left_i
  );

  // ---- Pixels ----
  logic       px_valid, px_ready, px_miss, ray_px_valid, ray_px_ready;
  pixel_tag_t px;
  tile_pixels u_tile_pixels (
    .clk_i, .rst_ni,
    .in_valid_i(pixels_valid), .in_ready_o(pixels_ready), .in_i(deal_o.tile), .miss_i(tile_miss),
    .out_valid_o(px_valid), .out_ready_i(px_ready), .out_o(px), .miss_o(px_miss), .idle_o(pixels_idle)
  );
  assign miss_valid_o = px_valid && px_miss;
  assign miss_o       = px;
  assign ray_px_valid = px_valid && !px_miss;
  assign px_ready     = px_miss ? miss_ready_i : ray_px_ready;
  assign walk_done_o  = job_i.is_list ? list_done_i : walked && started_idle && dealt_idle && pixels_idle;

  // ---- Rays: of corners first; which they are waits beside the pipes ----
  logic       camera_valid, camera_ready, dir_valid, dir_ready, ray_valid, ray_ready, is_corner;
  logic       flag_ready, req_valid, req_ready, flagged, slab_valid, slab_ready, issued, ray_taken;
  pixel_tag_t camera_px;
  pixel_dir_t dir;
  ray_req_t   req;

  assign camera_valid = (corner_valid || ray_px_valid) && flag_ready;
  assign camera_px    = corner_valid ? corner : px;
  assign corner_ready = camera_ready && flag_ready;
  assign ray_px_ready = camera_ready && flag_ready && !corner_valid;
  assign issued       = camera_valid && camera_ready;

  localparam int unsigned SetupRays = 32;   // at least what ray_gen and ray_setup hold
  stream_fifo #(.data_t(logic), .Depth(SetupRays)) u_flags (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(issued), .ready_o(flag_ready), .data_i(corner_valid),
    .valid_o(), .ready_i(ray_valid && ray_ready), .data_o(flagged)
  );
  assign is_corner = flagged && !job_i.is_list;

  ray_gen u_ray_gen (
    .clk_i, .rst_ni, .camera_i,
    .in_valid_i(camera_valid), .in_ready_o(camera_ready), .in_i(camera_px),
    .out_valid_o(dir_valid), .out_ready_i(dir_ready), .out_o(dir)
  );

  ray_choice u_ray_choice (
    .is_list_i(job_i.is_list), .eye_i(camera_i.eye),
    .pixel_valid_i(dir_valid), .pixel_ready_o(dir_ready), .pixel_i(dir),
    .list_valid_i, .list_ready_o, .list_i,
    .out_valid_o(req_valid), .out_ready_i(req_ready), .out_o(req)
  );

  ray_setup u_ray_setup (
    .clk_i, .rst_ni,
    .in_valid_i(req_valid), .in_ready_o(req_ready), .in_i(req),
    .out_valid_o(ray_valid), .out_ready_i(ray_ready), .out_o(ray)
  );
  assign corner_ray_valid = ray_valid && is_corner;
  assign slab_valid       = ray_valid && !is_corner;
  assign ray_ready        = is_corner ? corner_ray_ready : slab_ready;

  slab_setup u_slab_setup (
    .clk_i, .rst_ni,
    .in_valid_i(slab_valid), .in_ready_o(slab_ready), .in_i(ray),
    .out_valid_o, .out_ready_i, .out_o
  );

  assign ray_taken = (ray_px_valid && ray_px_ready) || (list_valid_i && list_ready_o);
  credit #(.Limit(Slots << (2 * TileLog2))) u_in_setup (   // the pixels of all tiles in flight
    .clk_i, .rst_ni,
    .take_i(ray_taken), .give_i(out_valid_o && out_ready_i),
    .available_o(), .idle_o(none_in_setup_o)
  );
  assign exhausted_o = walk_done_o && none_in_setup_o;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (flag_ready || !camera_ready) else $error("ray_gen and ray_setup hold more than SetupRays");
  end
`endif
endmodule
