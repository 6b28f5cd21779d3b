// SPDX-License-Identifier: Apache-2.0
// Contexts go to lines of one section of the image, nodes or leaves, and get them from a cache, in
// any order. They come from either of two steps and wait in a queue, so that whoever is sent here is
// taken. An index behind the section raises fault_o, and its context gets nothing. A RefTile goes to a
// line that was written here, if there are such (Kept).
// From visit_valid_i to out_valid_o: 5 cycles for a line that the cache holds, 4 for a kept one.
module line_fetch
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  parameter int unsigned Lines    = DefaultCacheLines,   // of the cache
  parameter error_t      Fault    = ErrNode,
  parameter int unsigned Kept     = 0,        // lines kept
  parameter int unsigned ReadW    = $bits(line_data_t),   // the lowest bits of a line, which are read
  localparam int unsigned KeptW   = (Kept > 1) ? $clog2(Kept) : 1
) (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  line_no_t    base_i,          // the section's first line
  input  logic [31:0] count_i,         // how many it has

  input  logic [1:0]  visit_valid_i,   // at most one of a context under way
  input  ctx_t        visit_ctx_i [2],
  input  ref_t        visit_ref_i [2],

  input  logic             keep_i,        // fill_i.data is a line to keep; no fill is taken then
  input  logic [KeptW-1:0] keep_index_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output ctx_t        out_ctx_o,
  output logic        out_kept_o,
  output line_t       out_index_o,     // but of a kept one
  output logic [ReadW-1:0] out_data_o,
  output error_t      fault_o,

  output logic        req_valid_o,     // to memory
  input  logic        req_ready_i,
  output line_req_t   req_o,
  input  logic        fill_valid_i,
  output logic        fill_ready_o,
  input  line_fill_t  fill_i,

  output logic        hit_o,           // counter events
  output logic        miss_o,
  output logic        wait_o           // a context waits for the cache
);
  localparam int unsigned IdxW       = (Contexts > 1) ? $clog2(Contexts) : 1;
  localparam int unsigned QueueDepth = (Contexts > 1) ? Contexts : 2;
  typedef struct packed {
    ctx_t  ctx;
    logic  kept;
    line_t index;
  } visit_t;

  visit_t visit [2], head;
  logic   head_valid, head_ready, ask, in_range, cache_ready, kept_ready;
  for (genvar i = 0; i < 2; i++) begin : g_visit
    assign visit[i] = '{ctx: visit_ctx_i[i], kept: Kept != 0 && visit_ref_i[i].kind == RefTile, index: visit_ref_i[i].index};
  end

  pair_fifo #(.data_t(visit_t), .Depth(QueueDepth)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(visit_valid_i), .ready_o(), .data_i(visit),
    .valid_o(head_valid), .ready_i(head_ready), .data_o(head)
  );

  line_t index_q [Contexts];
  assign out_index_o = index_q[IdxW'(out_ctx_o)];
  always_ff @(posedge clk_i) begin
    if (ask && cache_ready) index_q[IdxW'(head.ctx)] <= head.index;
  end

  assign in_range   = 32'(head.index) < count_i;
  assign ask        = head_valid && !head.kept && in_range;
  assign head_ready = head.kept ? kept_ready : cache_ready || !in_range;
  assign fault_o    = (head_valid && !head.kept && !in_range) ? Fault : ErrNone;
  assign wait_o     = ask && !cache_ready;

  // A kept line is asked for from a register: the queue does not wait for its turn, and the data memory's address
  // comes from there.
  typedef struct packed {
    ctx_t             ctx;
    logic [KeptW-1:0] index;
  } kept_t;
  logic  kept_valid, cache_kept_ready;
  kept_t kept;
  pipe_stage #(.data_t(kept_t)) u_kept (
    .clk_i, .rst_ni,
    .valid_i(Kept != 0 && head_valid && head.kept), .ready_o(kept_ready),
    .data_i('{ctx: head.ctx, index: KeptW'(head.index)}),
    .valid_o(kept_valid), .ready_i(cache_kept_ready), .data_o(kept)
  );

  line_cache #(.id_t(ctx_t), .Lines(Lines), .Kept(Kept), .ReadW(ReadW)) u_cache (
    .clk_i, .rst_ni, .hit_o, .miss_o,
    .in_valid_i(ask), .in_ready_o(cache_ready),
    .in_id_i(head.ctx), .in_line_i(base_i + line_no_t'(head.index)),
    .keep_i, .keep_index_i,
    .kept_valid_i(kept_valid), .kept_ready_o(cache_kept_ready), .kept_id_i(kept.ctx), .kept_index_i(kept.index),
    .out_valid_o, .out_ready_i, .out_id_o(out_ctx_o), .out_kept_o, .out_data_o,
    .req_valid_o, .req_ready_i, .req_o,
    .data_valid_i(fill_valid_i), .data_miss_i(fill_i.miss), .data_part_i('0), .data_i(fill_i.data[ReadW-1:0]),
    .fill_valid_i, .fill_ready_o, .fill_miss_i(fill_i.miss)
  );
endmodule
