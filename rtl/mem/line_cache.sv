// SPDX-License-Identifier: Apache-2.0
// A cache of 64-byte lines that does not wait for memory. Who asks has a number (a lane: its
// context) and one request under way at most; answers come in any order.
//   look   in -> cycle 0 the set's tags
//                cycle 1 compared; the line with those waited for too (line_tags, line_misses)
//                cycle 2 found: to serve. Not found: the number waits in the line's chain; a line
//                        that nobody waited for is asked for. A lookup never waits for memory.
//   fill   a line from memory -> register; cycle 1 it takes its place and its chain goes to wake
//   serve  a number and a place, of a hit or of wake in turn; a cycle each for the data memory and
//          for its output register -> out
// At most Misses lines are waited for, each asked for once; while there may be none left nothing
// is looked up. Of one set, there is one thing at a time: a fill waits while a lookup of the set
// stands in cycle 1 or 2 or a chain of the set is served, and lookups of the set wait for the fill. So a
// line stays until all who waited for it have it.
// Kept lines lie beside the cache's in the data memory. The user writes them, and asks for them by
// their indices, in turn with what the cache serves. Nothing is read in the cycle in which one is
// written, and out must not be blocked then.
// What comes out of out makes everything else move, so out must not wait for in or fill
// (docs/memory.md).
// One lookup a cycle. A hit takes 4 cycles from in to out; a line is offered 4 cycles after it came.
// After a reset nothing is taken for as many cycles as there are sets: the tags are emptied.
module line_cache
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter type         id_t   = ctx_t,
  parameter int unsigned Lines  = DefaultCacheLines,
  parameter int unsigned Ways   = DefaultCacheWays,
  parameter int unsigned Misses = DefaultCacheMisses,
  parameter int unsigned Skip   = 0,   // lowest bits of a number that all lines of this cache share
  parameter int unsigned Kept   = 0,   // kept lines
  parameter int unsigned ReadW  = $bits(line_data_t),   // the lowest bits of a line, which are read
  localparam int unsigned KeptW = (Kept > 1) ? $clog2(Kept) : 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  output logic             hit_o,      // for the counters: one of the two for each lookup
  output logic             miss_o,     // also for a line that is waited for already

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  id_t              in_id_i,
  input  line_no_t         in_line_i,

  input  logic             keep_i,         // a kept line is written
  input  logic [KeptW-1:0] keep_index_i,
  input  logic [ReadW-1:0] keep_data_i,
  input  logic             kept_valid_i,   // a kept line is asked for
  output logic             kept_ready_o,
  input  id_t              kept_id_i,
  input  logic [KeptW-1:0] kept_index_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output id_t              out_id_o,
  output logic             out_kept_o,
  output logic [ReadW-1:0] out_data_o,

  output logic             req_valid_o,
  input  logic             req_ready_i,
  output line_req_t        req_o,

  input  logic             fill_valid_i,   // under the numbers of the requests, in any order
  output logic             fill_ready_o,
  input  line_fill_t       fill_i
);
  localparam int unsigned Sets = Lines / Ways;
  localparam int unsigned SetW = $clog2(Sets);
  localparam int unsigned WayW = $clog2(Ways);
  localparam int unsigned TagW = $bits(line_no_t) - SetW - Skip;
  typedef logic [SetW-1:0]      set_t;
  typedef logic [TagW-1:0]      tag_t;
  typedef logic [SetW+WayW-1:0] place_t;
  localparam int unsigned PlaceW  = $bits(place_t);
  localparam int unsigned DataIdxW = (Kept == 0) ? PlaceW : 1 + ((KeptW > PlaceW) ? KeptW : PlaceW);
  typedef logic [DataIdxW-1:0]  data_place_t;   // kept lines in the upper half
  localparam int unsigned Servers = (Kept == 0) ? 2 : 3;
  function automatic set_t set_of(line_no_t number);
    return number[Skip +: SetW];
  endfunction
  function automatic tag_t tag_of(line_no_t number);
    return number[Skip+SetW +: TagW];
  endfunction

  // ---- Look ----
  logic             emptied, room, open, look, looking, match, match_ready, looked, leaves, found, is_new;
  logic             filled, fill, fill_load;
  logic [WayW-1:0]  found_way, fill_way;
  miss_t            new_miss;
  id_t              id_q, look_id_q;
  line_no_t         line_q, look_line_q, fill_line, fill_line_q;
  miss_t            fill_miss_q;
  logic [ReadW-1:0] fill_data_q;

  always_comb begin
    open = emptied && room;
    if (filled) open = open && set_of(in_line_i) != set_of(fill_line_q);
  end
  logic look_ready;
  assign in_ready_o = open && look_ready;
  pipe_chain #(.Stages(1)) u_look (
    .clk_i, .rst_ni, .valid_i(in_valid_i && open), .ready_o(look_ready),
    .valid_o(looking), .ready_i(match_ready), .load_o(look)
  );
  pipe_chain #(.Stages(1)) u_match (
    .clk_i, .rst_ni, .valid_i(looking), .ready_o(match_ready),
    .valid_o(looked), .ready_i(leaves), .load_o(match)
  );
  always_ff @(posedge clk_i) begin
    if (look) begin
      look_id_q   <= in_id_i;
      look_line_q <= in_line_i;
    end
    if (match) begin
      id_q   <= look_id_q;
      line_q <= look_line_q;
    end
  end

  line_tags #(.Sets(Sets), .Ways(Ways), .TagW(TagW)) u_tags (
    .clk_i, .rst_ni, .ready_o(emptied),
    .look_i(look), .look_set_i(set_of(in_line_i)), .look_tag_i(tag_of(in_line_i)),
    .match_i(match), .held_i(looked), .found_o(found), .found_way_o(found_way), .use_i(hit_o),
    .choose_i(fill_load), .choose_set_i(set_of(fill_line)), .fill_i(fill), .fill_set_i(set_of(fill_line_q)), .fill_tag_i(tag_of(fill_line_q)),
    .fill_way_o(fill_way)
  );

  // A number for each lookup under way, in case that it needs one.
  credit #(.Limit(Misses), .Gives(2)) u_room (
    .clk_i, .rst_ni, .take_i(look), .give_i({fill, looked && leaves && !is_new}),
    .available_o(room), .idle_o()
  );

  // ---- Misses ----
  id_t      head, wake_id, wake_next;
  line_misses #(.id_t(id_t), .Misses(Misses)) u_misses (
    .clk_i, .rst_ni,
    .look_i(match), .look_line_i(look_line_q),
    .add_i(miss_o), .add_id_i(id_q), .add_line_i(line_q), .new_o(is_new), .new_miss_o(new_miss),
    .find_i(fill_i.miss), .find_line_o(fill_line),
    .end_i(fill), .end_miss_i(fill_miss_q), .end_head_o(head),
    .id_i(wake_id), .next_o(wake_next)
  );
  stream_fifo #(.data_t(line_req_t), .Depth(Misses)) u_req (
    .clk_i, .rst_ni,
    .valid_i(is_new), .ready_o(), .data_i('{miss: new_miss, line: line_q}),
    .valid_o(req_valid_o), .ready_i(req_ready_i), .data_o(req_o), .used_o()
  );

  // ---- Fill ----
  logic   wake_room, wake_busy, fill_free;
  place_t fill_place;
  always_comb begin
    fill_free = 1'b0;
    if (filled) begin
      fill_free = wake_room && !wake_busy && !(looking && set_of(look_line_q) == set_of(fill_line_q))
                  && !(looked && set_of(line_q) == set_of(fill_line_q));
    end
  end
  assign fill       = filled && fill_free;
  assign fill_place = {set_of(fill_line_q), fill_way};
  pipe_chain #(.Stages(1)) u_fill (
    .clk_i, .rst_ni, .valid_i(fill_valid_i), .ready_o(fill_ready_o),
    .valid_o(filled), .ready_i(fill_free), .load_o(fill_load)
  );
  always_ff @(posedge clk_i) begin
    if (fill_load) begin
      fill_miss_q <= fill_i.miss;
      fill_data_q <= fill_i.data[ReadW-1:0];
      fill_line_q <= fill_line;
    end
  end

  // ---- Serve ----
  typedef struct packed {
    id_t         id;
    data_place_t place;
  } serve_t;
  serve_t             serve [Servers];
  serve_t             next;
  logic [Servers-1:0] serve_valid, serve_ready;
  logic               wake_valid, next_valid, next_ready;
  place_t             wake_place;
  line_wake #(.id_t(id_t), .SetW(SetW), .WayW(WayW)) u_wake (
    .clk_i, .rst_ni,
    .push_i(fill), .ready_o(wake_room), .head_i(head), .place_i(fill_place),
    .set_i(set_of(fill_line_q)), .busy_o(wake_busy),
    .out_valid_o(wake_valid), .out_ready_i(serve_ready[0]), .out_id_o(wake_id),
    .out_place_o(wake_place), .next_i(wake_next)
  );
  function automatic data_place_t kept_place(logic [KeptW-1:0] index);
    return data_place_t'(index) | (data_place_t'(1) << (DataIdxW - 1));
  endfunction
  always_comb begin
    serve[Servers-1] = '{id: kept_id_i, place: kept_place(kept_index_i)};
    serve[0]         = '{id: wake_id, place: data_place_t'(wake_place)};
    serve[1]         = '{id: id_q, place: data_place_t'({set_of(line_q), found_way})};
  end
  assign serve_valid    = Servers'({kept_valid_i, looked && found, wake_valid});
  assign kept_ready_o   = Kept != 0 && serve_ready[Servers-1];
  assign leaves         = !found || serve_ready[1];
  assign hit_o          = looked && found && serve_ready[1];
  assign miss_o         = looked && !found;
  stream_arb #(.data_t(serve_t), .N(Servers)) u_serve (
    .clk_i, .rst_ni, .valid_i(serve_valid), .ready_o(serve_ready), .data_i(serve),
    .valid_o(next_valid), .ready_i(next_ready), .data_o(next), .index_o()
  );

  // ---- Data ----
  // Two ports: fills are written at the one, kept lines are written and all lines are read at the other.
  (* ram_style = "block" *) logic [ReadW-1:0] data_q [1 << DataIdxW];
  logic [ReadW-1:0] read_q, out_q;
  id_t              read_id_q, out_id_q;
  logic             keep, read_kept_q, out_kept_q, chain_ready;
  logic [1:0]       load;
  data_place_t      place;
  assign keep       = keep_i && Kept != 0;
  assign place      = keep ? kept_place(keep_index_i) : next.place;
  assign next_ready = chain_ready && !keep;
  pipe_chain #(.Stages(2)) u_data (
    .clk_i, .rst_ni, .valid_i(next_valid && !keep), .ready_o(chain_ready),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .load_o(load)
  );
  always @(posedge clk_i) begin
    if (fill) data_q[data_place_t'(fill_place)] <= fill_data_q;
  end
  always @(posedge clk_i) begin
    if (load[0] || keep) begin
      if (keep) data_q[place] <= keep_data_i;
      read_q <= data_q[place];
    end
  end
  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      read_id_q   <= next.id;
      read_kept_q <= Kept != 0 && next.place[DataIdxW-1];
    end
    if (load[1]) begin
      out_q      <= read_q;
      out_id_q   <= read_id_q;
      out_kept_q <= read_kept_q;
    end
  end
  assign out_id_o   = out_id_q;
  assign out_kept_o = out_kept_q;
  assign out_data_o = out_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && keep) assert (!out_valid_o || out_ready_i) else $error("a kept line is written while out is blocked");
  end
  stream_check #(.data_t(id_t)) u_check_out (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .data_i(out_id_o)
  );
`endif
endmodule
