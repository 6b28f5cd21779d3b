// SPDX-License-Identifier: Apache-2.0
// Attributes of the primitives that were hit, through a small cache: two ways, least recently
// used. It does not wait for memory (Igehy, Eldridge, Proudfoot 1998): a hit's tag is looked up
// and a miss asked for when it enters; then it waits in a queue, and the data memory is written
// and read only at the queue's head. So hits pass on under misses, in order, a place may be given
// away while an older request for it still waits, and a line in flight is not asked for again.
//
//   look   two cycles a hit: attr_tags
//   queue  Queue hits, each with its place and whether its line comes from memory
//   head   two cycles a hit, half a line each: from the data memory, or from the lines that came;
//          those are written to the data memory a cycle later
//   out    the hit with its attributes, from a register
//
// At most Misses lines are outstanding, each with room reserved before it is asked for.
// Lines come in the order of their requests (one AXI ID). base_i stands still while hits enter.
// One hit every two cycles, in order; latency 5 cycles where nothing waits.
// Model of hit_o and miss_o: cpp_model/mem/attr_tags.hpp.
module attr_cache
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Entries = DefaultAttrEntries,
  parameter int unsigned Misses  = DefaultAttrMisses,
  parameter int unsigned Queue   = 32
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  addr_t      base_i,        // of the attributes
  output logic       hit_o,         // a line was there, or was not: for the counters
  output logic       miss_o,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  hit_t       in_i,          // found

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output shade_req_t out_o,

  output logic       req_valid_o,
  input  logic       req_ready_i,
  output read_req_t  req_o,
  input  logic       rsp_valid_i,
  input  read_rsp_t  rsp_i
);
  if (Queue < 2) begin : g_queue
    $error("attr_cache: Queue must be at least 2");
  end
  if (AttrBytes * 8 != 4 * DataW) begin : g_line
    $error("attr_cache: a line must be four beats");
  end

  localparam int unsigned PlaceW = $clog2(Entries);
  typedef logic [2*DataW-1:0] half_t;
  typedef logic [PlaceW:0]    half_at_t;   // a place's lower or upper half

  // ---- Look ----
  logic              look_valid, look_ready, look_miss, line_used;
  logic [PlaceW-1:0] look_place;
  attr_tags #(.Entries(Entries), .Misses(Misses)) u_tags (
    .clk_i, .rst_ni, .base_i, .hit_o, .miss_o,
    .in_valid_i, .in_ready_o, .in_i(in_i.number),
    .out_valid_o(look_valid), .out_ready_i(look_ready), .out_place_o(look_place), .out_miss_o(look_miss),
    .req_valid_o, .req_ready_i, .req_o, .given_i(line_used)
  );

  // ---- Queue ----
  typedef struct packed {
    hit_t              hit;
    logic [PlaceW-1:0] place;
    logic              miss;
  } item_t;
  item_t head;
  logic  head_valid, head_taken;
  stream_fifo #(.data_t(item_t), .Depth(Queue)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(look_valid), .ready_o(look_ready),
    .data_i('{hit: in_i, place: look_place, miss: look_miss}),
    .valid_o(head_valid), .ready_i(head_taken), .data_o(head), .used_o()
  );

  // ---- Lines that came: two beats make a half ----
  logic  odd_q, lines_ready, line_valid, line_taken;
  beat_t even_q;
  half_t line;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) odd_q <= 1'b0;
    else if (rsp_valid_i) odd_q <= !odd_q;
  end
  always_ff @(posedge clk_i) begin
    if (rsp_valid_i && !odd_q) even_q <= rsp_i.data;
  end
  stream_fifo #(.data_t(half_t), .Depth(2 * Misses)) u_lines (
    .clk_i, .rst_ni,
    .valid_i(rsp_valid_i && odd_q), .ready_o(lines_ready), .data_i({rsp_i.data, even_q}),
    .valid_o(line_valid), .ready_i(line_taken), .data_o(line), .used_o()
  );

  // ---- Head: a half a cycle ----
  logic load, upper_q, read_valid, read_taken;
  pipe_chain #(.Stages(1)) u_read (
    .clk_i, .rst_ni,
    .valid_i(head_valid && (!head.miss || line_valid)), .ready_o(),
    .valid_o(read_valid), .ready_i(read_taken), .load_o(load)
  );
  assign line_taken = load && head.miss;
  assign line_used  = line_taken && upper_q;
  assign head_taken = load && upper_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) upper_q <= 1'b0;
    else if (load) upper_q <= !upper_q;
  end

  // A half that came is used from fresh_q. It is in the memory before the next hit on its place
  // reads it: that comes two halves later.
  (* ram_style = "block" *) half_t data_q [2*Entries];
  half_t    kept_q, fresh_q;
  half_at_t read_at, write_at_q;
  logic     write_q, is_fresh_q, is_upper_q;
  hit_t     hit_q;
  assign read_at = {head.place, upper_q};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= 1'b0;
    else write_q <= line_taken;
  end
  always_ff @(posedge clk_i) begin
    if (load) begin
      is_fresh_q <= head.miss;
      is_upper_q <= upper_q;
    end
    if (head_taken) hit_q <= head.hit;
    if (line_taken) begin
      fresh_q    <= line;
      write_at_q <= read_at;
    end
  end
  always_ff @(posedge clk_i) begin
    if (write_q) data_q[write_at_q] <= fresh_q;
    if (load && !head.miss) kept_q <= data_q[read_at];
  end

  // ---- Out: the halves meet ----
  half_t half, lower_q;
  logic  out_ready;
  assign half       = is_fresh_q ? fresh_q : kept_q;
  assign read_taken = !is_upper_q || out_ready;
  always_ff @(posedge clk_i) begin
    if (read_valid && !is_upper_q) lower_q <= half;
  end
  pipe_stage #(.data_t(shade_req_t)) u_out (
    .clk_i, .rst_ni,
    .valid_i(read_valid && is_upper_q), .ready_o(out_ready),
    .data_i('{attr: attr_t'({half, lower_q}), hit: hit_q}),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_o)
  );

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && rsp_valid_i && odd_q) begin
      assert (lines_ready) else $error("a line came that was not asked for");
    end
  end
`endif
endmodule
