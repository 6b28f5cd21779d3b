// SPDX-License-Identifier: Apache-2.0
// Gathers the pixels of each tile, of many tiles at once and in any order, and writes the tile's
// rows to the frame buffer when all are there: see tile_rows.
//   request  a tile takes a slot, below Slots, as soon as one is free
//   pixels   always taken, one a cycle, each to its place in the slot's part of the memory: four
//            banks, so that four pixels are read at once. A slot's count says when it is complete
//   fill     a tile of one colour is complete without a pixel
//   queue    complete tiles wait for their rows to be written; then the slot is free again
// Each pixel of a requested tile comes once, and after its request, or it is filled; nothing else comes.
// The model of the whole frame writes pixels one by one; this unit has no arithmetic of its own.
module tile_gather
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned TileLog2 = DefaultTileLog2,
  parameter int unsigned Slots    = tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2)
) (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  addr_t       base_i,        // of the frame buffer, a multiple of 64
  input  logic [31:0] stride_i,      // bytes from row to row, a multiple of 64
  output logic        idle_o,        // no slot is taken

  input  logic        tile_valid_i,
  output logic        tile_ready_o,
  input  tile_t       tile_i,        // its slot is not looked at
  output logic [7:0]  tile_slot_o,   // but given to it here

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  shaded_t     in_i,

  input  logic        fill_valid_i,
  output logic        fill_ready_o,
  input  logic [7:0]  fill_slot_i,
  input  logic [31:0] fill_colour_i, // stands still

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output write_req_t  out_o
);
  if (TileLog2 < 2 || TileLog2 > 4) begin : g_tile
    $error("tile_gather: TileLog2 must be 2, 3 or 4");
  end
  if (Slots < 1 || Slots > 256) begin : g_slots
    $error("tile_gather: Slots must be 1 to 256");
  end

  localparam int unsigned SlotW  = (Slots > 1) ? $clog2(Slots) : 1;
  localparam int unsigned Banks  = 4;
  localparam int unsigned PlaceW = SlotW + 2 * TileLog2 - 2;   // slot, row, column / 4
  localparam int unsigned Depth  = 1 << PlaceW;
  typedef logic [SlotW-1:0]      slot_t;
  typedef logic [2*TileLog2:0]   count_t;

  // ---- Requests ----
  logic [Slots-1:0] busy_q, new_q;      // taken; no pixel of it has come
  tile_t            tile_q [Slots];
  count_t           size_q [Slots];
  slot_t            asked, freed;
  logic             request, free;
  assign tile_slot_o  = 8'(asked);
  free_list #(.N(Slots)) u_slots (
    .clk_i, .rst_ni,
    .valid_o(tile_ready_o), .number_o(asked), .take_i(request), .give_i(free), .number_i(freed)
  );
  assign request      = tile_valid_i && tile_ready_o;
  assign idle_o       = busy_q == '0;
  always_ff @(posedge clk_i) begin
    if (request) begin
      tile_q[asked]      <= tile_i;
      tile_q[asked].slot <= tile_slot_o;
      size_q[asked] <= count_t'(tile_i.width) * count_t'(tile_i.height);
    end
  end

  // ---- Pixels ----
  slot_t  slot;
  count_t count_q [Slots];
  count_t count;
  logic   complete;
  assign in_ready_o = 1'b1;
  assign slot       = slot_t'(in_i.tag.slot);
  assign count      = new_q[slot] ? count_t'(1) : count_q[slot] + 1'b1;
  assign complete   = in_valid_i && count == size_q[slot];
  always_ff @(posedge clk_i) begin
    if (in_valid_i) count_q[slot] <= count;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q <= '0;
      new_q  <= '0;
    end else begin
      if (request) begin
        busy_q[asked] <= 1'b1;
        new_q[asked]  <= 1'b1;
      end
      if (in_valid_i) new_q[slot] <= 1'b0;
      if (free) busy_q[freed] <= 1'b0;
    end
  end

  // ---- Memory ----
  logic [PlaceW-1:0] place, read_at;
  logic              read;
  beat_t             beat;
  function automatic logic [PlaceW-1:0] place_of(slot_t s, logic [3:0] row, logic [1:0] group);
    return (PlaceW'({s, row[TileLog2-1:0]}) << (TileLog2 - 2)) | PlaceW'(group);
  endfunction
  assign place = place_of(slot, in_i.tag.y[3:0], 2'(in_i.tag.x[TileLog2-1:0] >> 2));
  for (genvar i = 0; i < Banks; i++) begin : g_bank
    logic [31:0] pixel_q [Depth];
    logic [31:0] read_q;
    always_ff @(posedge clk_i) begin
      if (in_valid_i && in_i.tag.x[1:0] == 2'(i)) pixel_q[place] <= in_i.colour;
      if (read) read_q <= pixel_q[read_at];
    end
    assign beat[32*i +: 32] = read_q;
  end

  // ---- Complete tiles ----
  typedef struct packed {
    logic  fill;
    slot_t slot;
  } complete_t;
  complete_t  next;
  logic       queue_ready, next_valid, next_ready, fill_q;
  logic [7:0] read_slot;
  logic [3:0] read_row;
  logic [1:0] read_beat;
  assign fill_ready_o = !complete;
  stream_fifo #(.data_t(complete_t), .Depth((Slots > 1) ? Slots : 2)) u_complete (
    .clk_i, .rst_ni,
    .valid_i(complete || fill_valid_i), .ready_o(queue_ready),
    .data_i('{fill: !complete, slot: complete ? slot : slot_t'(fill_slot_i)}),
    .valid_o(next_valid), .ready_i(next_ready), .data_o(next), .used_o()
  );
  tile_rows #(.TileLog2(TileLog2)) u_rows (
    .clk_i, .rst_ni, .base_i, .stride_i,
    .tile_valid_i(next_valid), .tile_ready_o(next_ready), .tile_i(tile_q[next.slot]),
    .read_o(read), .slot_o(read_slot), .row_o(read_row), .beat_o(read_beat),
    .beat_i(fill_q ? {Banks{fill_colour_i}} : beat),
    .out_valid_o, .out_ready_i, .out_o, .done_o(free)
  );
  always_ff @(posedge clk_i) begin
    if (next_valid && next_ready) fill_q <= next.fill;
  end
  assign freed   = slot_t'(read_slot);
  assign read_at = place_of(freed, read_row, read_beat);

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && in_valid_i) begin
      assert (busy_q[slot] && count <= size_q[slot]) else $error("a pixel came for no tile");
      assert (queue_ready) else $error("more complete tiles than slots");
    end
    if (rst_ni && request) begin
      assert (!busy_q[asked] && tile_i.width != '0 && tile_i.height != '0)
      else $error("an empty tile, or a slot in use");
    end
  end
`endif
endmodule
