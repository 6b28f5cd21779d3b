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

  // ---- The window in tiles, of one axis ----
  typedef logic [TileLog2-1:0] offset_t;
  typedef struct packed {
    idx_t       first, last;   // the last one counted from the first
    offset_t    skip;          // pixels of the first tile before the window
    logic [4:0] size;          // of the last tile, those before the window counted too
  } span_t;
  span_t cols_q, rows_q;
  logic  empty;
  assign empty = job_i.x0 >= job_i.x1 || job_i.y0 >= job_i.y1;

  function automatic span_t span(extent_t low, extent_t limit);
    extent_t last;
    last = limit - 1'b1;
    return '{first: low[PixelW-1:TileLog2], last: last[PixelW-1:TileLog2] - low[PixelW-1:TileLog2],
             skip: low[TileLog2-1:0], size: 5'(last[TileLog2-1:0]) + 5'd1};
  endfunction
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      cols_q <= span(job_i.x0, job_i.x1);
      rows_q <= span(job_i.y0, job_i.y1);
    end
  end

  // ---- The next place: at_q is {row, column} or the Z code ----
  code_t at_q, at_d, code;
  logic  ended_q, ended_d;
  idx_t  z_col, z_row, col, row;
  logic  z_in_window, in_window, step;

  always_comb begin
    for (int unsigned i = 0; i < IdxW; i++) {z_row[i], z_col[i]} = at_q[2*i +: 2];
  end
  assign {row, col}  = job_i.z_order ? {z_row, z_col} : at_q;
  assign z_in_window = z_col <= cols_q.last && z_row <= rows_q.last;
  assign in_window   = z_in_window || !job_i.z_order;
  assign code        = z_in_window ? code_t'(1) : at_q & (~at_q + 1'b1);

  always_comb begin
    {ended_d, at_d} = {1'b0, at_q} + {1'b0, code};
    if (!job_i.z_order) begin
      at_d    = (col == cols_q.last) ? {row + 1'b1, {IdxW{1'b0}}} : {row, col + 1'b1};
      ended_d = col == cols_q.last && row == rows_q.last;
    end
  end

  // ---- The tile offered to the gather ----
  tile_t      tile_q;
  logic       tile_valid_q;
  logic       granted;

  function automatic offset_t skip_of(idx_t index, span_t of);
    return (index == '0) ? of.skip : '0;
  endfunction
  function automatic pixel_t first_of(idx_t index, span_t of);
    return {of.first + index, skip_of(index, of)};
  endfunction
  function automatic logic [4:0] size_of(idx_t index, span_t of);
    return ((index == of.last) ? of.size : 5'(Size)) - 5'(skip_of(index, of));
  endfunction
  function automatic tile_t tile_at(idx_t tile_col, idx_t tile_row, span_t cols, span_t rows);
    return '{
      x: first_of(tile_col, cols), width: size_of(tile_col, cols),
      y: first_of(tile_row, rows), height: size_of(tile_row, rows), slot: '0
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
      if (in_window) tile_q <= tile_at(col, row, cols_q, rows_q);
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
