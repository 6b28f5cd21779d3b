// SPDX-License-Identifier: Apache-2.0
// From hits to the two buffers: a record of each ray to the hit buffer when asked, and a colour,
// shaded or of the background, to its tile and so to the frame buffer. Instances, and which way a
// hit goes.
//
//   in -> fork -+-> hit_writer -------------------------------------------> hit buffer
//               +-> found: queue -> attr_cache -> shade -+-> tile_gather -> frame buffer
//               +-> a miss: background ------------------+
//
// Of a list of rays there are records only: its rays have no colour.
//
// Only rays of tiles that tile_* has asked for come in, each once. Every input but the streams
// stands still from the first tile until idle.
// Model: cpp_model/core.cpp (colour_of, write_pixel), equal bit for bit.
module shading
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned TileLog2    = DefaultTileLog2,
  parameter int unsigned Slots       = tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2),
  parameter int unsigned AttrEntries = DefaultAttrEntries
) (
  input  logic          clk_i,
  input  logic          rst_ni,

  input  job_t          job_i,
  input  frame_record_t record_i,
  input  point_t        eye_i,
  input  addr_t         attributes_i,   // where they begin

  input  logic          tile_valid_i,
  output logic          tile_ready_o,
  input  tile_t         tile_i,
  output logic [7:0]    tile_slot_o,    // that it is given

  input  logic          fill_valid_i,   // a tile of background
  output logic          fill_ready_o,
  input  logic [7:0]    fill_slot_i,

  input  logic          in_valid_i,
  output logic          in_ready_o,
  input  cast_t         in_i,

  output logic          read_valid_o,   // attributes
  input  logic          read_ready_i,
  output read_req_t     read_o,
  input  logic          rsp_valid_i,
  input  read_rsp_t     rsp_i,

  output logic          pixel_valid_o,
  input  logic          pixel_ready_i,
  output write_req_t    pixel_o,

  output logic          record_valid_o,
  input  logic          record_ready_i,
  output write_req_t    record_o,

  output logic          coloured_o,     // each hit that came has its colour in a tile
  output logic          idle_o,         // and each tile and record has been given to the writer
  output logic          attr_hit_o,     // counter events
  output logic          attr_miss_o,
  output logic          shader_busy_o
);
  // ---- In ----
  logic hit_valid, hit_ready, written_valid, written_ready, colour_valid, colour_ready;
  cast_t cast;
  hit_t  hit;
  assign hit = cast.hit;

  pipe_cut #(.data_t(cast_t)) u_in (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o), .data_i(in_i),
    .valid_o(hit_valid), .ready_i(hit_ready), .data_o(cast)
  );

  stream_fork #(.N(2)) u_fork (
    .clk_i, .rst_ni,
    .valid_i(hit_valid), .ready_o(hit_ready),
    .valid_o({written_valid, colour_valid}), .ready_i({written_ready, colour_ready})
  );

  // ---- The hit buffer: without one every record is dropped here ----
  logic writer_ready, records_idle;
  assign written_ready = !job_i.want_hits || writer_ready;

  hit_writer u_hit_writer (
    .clk_i, .rst_ni, .base_i(job_i.hits), .width_i(job_i.is_list ? extent_t'(MaxFrameSize) : job_i.width),
    .want_work_i(job_i.want_work),
    .in_valid_i(written_valid && job_i.want_hits), .in_ready_o(writer_ready), .in_i(cast),
    .out_valid_o(record_valid_o), .out_ready_i(record_ready_i), .out_o(record_o),
    .idle_o(records_idle)
  );

  // ---- Colours ----
  localparam int unsigned WaitingHits = 64;
  logic       found_valid, found_ready, unlit_valid, unlit_ready, miss_valid, miss_ready, attr_valid, attr_ready;
  hit_t       unlit;
  logic       lit_valid, lit_ready, back_valid, back_ready, shaded_valid, shaded_ready;
  shade_req_t shade_req;
  paint_t     paint;
  shaded_t    lit, back, shaded;

  assign found_valid  = colour_valid && hit.found && !job_i.is_list;
  assign miss_valid   = colour_valid && !hit.found && !job_i.is_list;
  assign colour_ready = job_i.is_list || (hit.found ? found_ready : miss_ready);

  frame_paint u_frame_paint (.record_i, .paint_o(paint));

  // Hits come in clusters, faster than a shader takes them: here they wait, and not in the lanes.
  stream_fifo #(.data_t(hit_t), .Depth(WaitingHits)) u_waiting (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(found_valid), .ready_o(found_ready), .data_i(hit),
    .valid_o(unlit_valid), .ready_i(unlit_ready), .data_o(unlit)
  );

  attr_cache #(.Entries(AttrEntries)) u_attr_cache (
    .clk_i, .rst_ni, .base_i(attributes_i),
    .in_valid_i(unlit_valid), .in_ready_o(unlit_ready), .in_i(unlit),
    .out_valid_o(attr_valid), .out_ready_i(attr_ready), .out_o(shade_req),
    .req_valid_o(read_valid_o), .req_ready_i(read_ready_i), .req_o(read_o), .rsp_valid_i, .rsp_i,
    .hit_o(attr_hit_o), .miss_o(attr_miss_o)
  );

  shade u_shade (
    .clk_i, .rst_ni, .eye_i, .paint_i(paint),
    .in_valid_i(attr_valid), .in_ready_o(attr_ready), .in_i(shade_req),
    .out_valid_o(lit_valid), .out_ready_i(lit_ready), .out_o(lit), .busy_o(shader_busy_o)
  );

  background u_background (
    .clk_i, .rst_ni, .paint_i(paint),
    .in_valid_i(miss_valid), .in_ready_o(miss_ready), .in_i(hit),
    .out_valid_o(back_valid), .out_ready_i(back_ready), .out_o(back)
  );

  stream_arb #(.data_t(shaded_t), .N(2)) u_colours (
    .clk_i, .rst_ni,
    .valid_i({lit_valid, back_valid}), .ready_o({lit_ready, back_ready}), .data_i('{back, lit}),
    .valid_o(shaded_valid), .ready_i(shaded_ready), .data_o(shaded), .index_o()
  );

  // ---- Tiles ----
  logic        gather_idle;
  logic [31:0] background_word;
  pixel_word u_background_word (
    .colour_i(paint.background), .swap_rb_i(paint.swap_rb), .word_o(background_word)
  );

  tile_gather #(.TileLog2(TileLog2), .Slots(Slots)) u_tile_gather (
    .clk_i, .rst_ni, .base_i(job_i.frame), .stride_i(record_i.stride),
    .tile_valid_i, .tile_ready_o, .tile_i, .tile_slot_o,
    .fill_valid_i, .fill_ready_o, .fill_slot_i, .fill_colour_i(background_word),
    .in_valid_i(shaded_valid), .in_ready_o(shaded_ready), .in_i(shaded),
    .out_valid_o(pixel_valid_o), .out_ready_i(pixel_ready_i), .out_o(pixel_o),
    .idle_o(gather_idle)
  );

  credit #(.Limit(Slots << (2 * TileLog2))) u_uncoloured (   // the pixels of all tiles in flight
    .clk_i, .rst_ni,
    .take_i(in_valid_i && in_ready_o && !job_i.is_list), .give_i(shaded_valid && shaded_ready),
    .available_o(), .idle_o(coloured_o)
  );
  assign idle_o = coloured_o && gather_idle && records_idle && !hit_valid;
endmodule
