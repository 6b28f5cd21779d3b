// SPDX-License-Identifier: Apache-2.0
// Walks over a window in tiles: asks the gather for a slot for each tile, and when that is granted
// gives the tile out with it.
//   Tiles are cut by the frame's grid of 2^TileLog2 pixels and clipped to the window.
//   Rows: left to right, top to bottom. Z order: column and row of a tile, counted from the
//   window's first, are the even and the odd bits of a code that counts up; codes outside the
//   window are skipped, a whole aligned block at a time (code + its lowest one), so that two
//   tiles are at most 20 skips apart: each skip's lowest one is above the last one's.
// A tile every two cycles (in rows).
// done_o: a level, from after the last tile was taken until the next start.
// An empty window is done at once. Model: cpp_model/camera/tile_walk.hpp, same order.
module tile_walk
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned TileLog2 = DefaultTileLog2
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       start_i,
  input  job_t       job_i,        // held from the start until done
  output logic       done_o,

  output logic       tile_valid_o,
  input  logic       tile_ready_i,
  output tile_t      tile_o,       // its slot is zero
  input  logic [7:0] tile_slot_i,  // and this where it is granted

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output tile_t      out_o
);
  if (TileLog2 < 2 || TileLog2 > 4) begin : g_tile
    $error("tile_walk: TileLog2 must be 2, 3 or 4");
  end

  localparam int unsigned Size = 1 << TileLog2;
  localparam int unsigned IdxW = PixelW - TileLog2;  // column or row of a tile
  typedef logic [IdxW-1:0]   idx_t;
  typedef logic [2*IdxW-1:0] code_t;

  // ---- The window in tiles ----
  idx_t first_col, first_row, last_col, last_row;   // last ones counted from the first
  logic empty;
  assign first_col = job_i.x0[PixelW-1:TileLog2];
  assign first_row = job_i.y0[PixelW-1:TileLog2];
  assign last_col  = last_index(job_i.x1) - first_col;
  assign last_row  = last_index(job_i.y1) - first_row;
  assign empty     = job_i.x0 >= job_i.x1 || job_i.y0 >= job_i.y1;

  function automatic idx_t last_index(extent_t limit);
    extent_t last;
    last = limit - 1'b1;
    return last[PixelW-1:TileLog2];
  endfunction

  // ---- The next place: at_q is {row, column} or the Z code ----
  code_t at_q, at_d, code;
  logic  ended_q, ended_d;
  idx_t  col, row;
  logic  in_window, step;

  always_comb begin
    for (int unsigned i = 0; i < IdxW; i++) begin
      col[i] = job_i.z_order ? at_q[2*i] : at_q[i];
      row[i] = job_i.z_order ? at_q[2*i+1] : at_q[IdxW+i];
    end
  end
  assign in_window = col <= last_col && row <= last_row;
  assign code   = in_window ? code_t'(1) : at_q & (~at_q + 1'b1);

  always_comb begin
    {ended_d, at_d} = {1'b0, at_q} + {1'b0, code};
    if (!job_i.z_order) begin
      at_d    = (col == last_col) ? {row + 1'b1, {IdxW{1'b0}}} : {row, col + 1'b1};
      ended_d = col == last_col && row == last_row;
    end
  end

  // ---- The tile offered to the gather ----
  tile_t      tile_q;
  logic       tile_valid_q;
  logic       granted;

  function automatic pixel_t first_of(idx_t index, extent_t low);
    extent_t start;
    start = extent_t'({index, {TileLog2{1'b0}}});
    return pixel_t'((start > low) ? start : low);
  endfunction
  function automatic logic [4:0] size_of(idx_t index, extent_t low, extent_t high);
    extent_t start, limit;
    start = extent_t'({index, {TileLog2{1'b0}}});
    limit = start + extent_t'(Size);
    return 5'(((limit < high) ? limit : high) - ((start > low) ? start : low));
  endfunction
  function automatic tile_t tile_at(idx_t tile_col, idx_t tile_row, job_t job);
    return '{
      x: first_of(tile_col, job.x0), width: size_of(tile_col, job.x0, job.x1),
      y: first_of(tile_row, job.y0), height: size_of(tile_row, job.y0, job.y1), slot: '0
    };
  endfunction

  assign step = !ended_q && (!tile_valid_q || granted);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ended_q      <= 1'b1;
      tile_valid_q <= 1'b0;
    end else if (start_i) begin
      ended_q      <= empty;
      tile_valid_q <= 1'b0;
    end else begin
      if (step) ended_q <= ended_d;
      if (step || granted) tile_valid_q <= step && in_window;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      at_q <= '0;
    end else if (step) begin
      at_q <= at_d;
      if (in_window) tile_q <= tile_at(first_col + col, first_row + row, job_i);
    end
  end

  // ---- The granted tile waits to be taken ----
  tile_t granted_tile;
  always_comb begin
    granted_tile      = tile_q;
    granted_tile.slot = tile_slot_i;
  end
  logic unused_ready;  // only an empty place is offered a tile
  assign tile_valid_o = tile_valid_q && !out_valid_o;
  assign tile_o       = tile_q;
  assign granted      = tile_valid_o && tile_ready_i;
  pipe_stage #(.data_t(tile_t)) u_wait (
    .clk_i, .rst_ni(rst_ni && !start_i),
    .valid_i(granted), .ready_o(unused_ready), .data_i(granted_tile),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_o)
  );

  logic started_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) started_q <= 1'b0;
    else if (start_i) started_q <= 1'b1;
  end
  assign done_o = started_q && ended_q && !tile_valid_q && !out_valid_o;
endmodule
