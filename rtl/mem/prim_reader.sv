// SPDX-License-Identifier: Apache-2.0
// Reads the primitive buffer from its first line to its last and gives its slots in that order,
// empty ones left out.
//   ask      bursts of 4 lines (16 beats, 256 bytes) while the queue has room for all their slots
//   arrive   two beats make a slot, the lower address in the lower half; an empty slot (number
//            NoPrim) is dropped; so is one whose number is not below primitives_i, and fault_o
//            is ErrPrimitive for a cycle
//   queue    Depth slots, prefetched
// base_i is aligned to 256 bytes. base_i, lines_i and primitives_i are held until done.
// done_o: a level, from the cycle after the last slot was taken or dropped until the next start.
// A start is allowed before the first and after each done.
// One slot every two cycles while the memory keeps up.
// Model: cpp_model/mem/prim_reader.hpp, same slots in the same order.
module prim_reader
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Depth = 32
) (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  logic        start_i,
  input  addr_t       base_i,
  input  logic [31:0] lines_i,
  input  logic [31:0] primitives_i,
  output logic        done_o,
  output error_t      fault_o,

  output logic        req_valid_o,
  input  logic        req_ready_i,
  output read_req_t   req_o,
  input  logic        rsp_valid_i,
  input  read_rsp_t   rsp_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output prim_slot_t  out_o
);
  localparam int unsigned BurstLines   = 4;
  localparam int unsigned SlotsPerLine = LineBytes / SlotBytes;
  localparam int unsigned BeatsPerLine = LineBytes / StrbW;
  localparam int unsigned BurstSlots   = BurstLines * SlotsPerLine;
  localparam int unsigned FreeW        = $clog2(Depth + 1);
  typedef logic [FreeW-1:0] free_t;
  if (Depth < BurstSlots) begin : g_depth
    $error("prim_reader: Depth must hold the slots of a burst");
  end
  if ($bits(prim_slot_t) != 2 * DataW || SlotBytes != 2 * StrbW) begin : g_slot
    $error("prim_reader: a slot must be two beats");
  end

  // ---- Ask ----
  logic        started_q;
  addr_t       addr_q;
  logic [31:0] left_q;          // lines not asked for
  logic        ask, short_burst;
  logic [2:0]  burst_lines;
  free_t       free_q;          // places of the queue neither taken nor promised

  assign short_burst = left_q < 32'(BurstLines);
  assign burst_lines = short_burst ? left_q[2:0] : 3'(BurstLines);
  assign req_valid_o = left_q != '0 && free_q >= free_t'(BurstSlots);
  assign req_o       = '{addr: addr_q, beats: BeatsW'(burst_lines) * BeatsW'(BeatsPerLine)};
  assign ask         = req_valid_o && req_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      left_q    <= '0;
    end else if (start_i) begin
      started_q <= 1'b1;
      left_q    <= lines_i;
    end else if (ask) begin
      left_q <= left_q - 32'(burst_lines);
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i) addr_q <= base_i;
    else if (ask) addr_q <= addr_q + addr_t'(BurstLines * LineBytes);
  end

  // ---- Arrive ----
  logic       half_q;           // the lower half of a slot is here
  beat_t      lower_q;
  prim_slot_t slot;
  logic       whole, some, legal, push, drop, fault_q;

  assign slot  = {rsp_i.data, lower_q};
  assign whole = rsp_valid_i && half_q;
  assign some  = slot.number != NoPrim;
  assign legal = 32'(slot.number) < primitives_i;
  assign push  = whole && some && legal;
  assign drop  = whole && !(some && legal);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      half_q  <= 1'b0;
      fault_q <= 1'b0;
    end else begin
      if (rsp_valid_i) half_q <= !half_q;
      fault_q <= whole && some && !legal;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rsp_valid_i && !half_q) lower_q <= rsp_i.data;
  end
  assign fault_o = fault_q ? ErrPrimitive : ErrNone;

  // ---- Queue ----
  logic  pop, unused_ready;
  free_t unused_count;
  stream_fifo #(.data_t(prim_slot_t), .Depth(Depth)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(push), .ready_o(unused_ready), .data_i(slot),   // there is room: it was promised
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_o),
    .used_o(unused_count)
  );
  assign pop = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) free_q <= free_t'(Depth);
    else free_q <= free_q - (ask ? free_t'(burst_lines) * free_t'(SlotsPerLine) : '0) + free_t'(pop) + free_t'(drop);
  end

  assign done_o = started_q && left_q == '0 && free_q == free_t'(Depth);

  logic unused_last;  // beats are counted
  assign unused_last = rsp_i.last;
endmodule
