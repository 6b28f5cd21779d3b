// SPDX-License-Identifier: Apache-2.0
// A cache of 64-byte lines that does not wait for memory. Who asks has a number (a lane: its
// context) and one request under way at most; answers come in any order.
//   look   in -> cycle 0 the set's tags
//                cycle 1 compared
//                cycle 2 found: to serve. Found, but still waited for: the number waits in the
//                        line's chain. Not found: the line is asked for, takes its place at once
//                        and is waited for there (line_tags, line_misses)
//   fill   data, to the place that its line has; the line's number -> register; cycle 1 the line is
//          there and its chain goes to wake
//   serve  a number and a place, of a hit or of wake in turn; a cycle each for the data memory and
//          for its output register -> out
// At most Misses lines are waited for, each asked for once; while there may be none left nothing
// is looked up. A lookup waits in cycle 2 while all ways of its set are waited for, or a chain of the
// set is served; no other lookup waits for memory. A set's lines come while no lookup of it is in cycle
// 2, but for one that waits there; lookups of a set wait for a line that comes. So the line before stays
// until all who waited for it have it.
// Kept lines lie beside the cache's in the data memory. The user writes them through data_i, and asks for
// them by their indices, in turn with what the cache serves. In the cycle in which one is written no line
// comes.
// What comes out of out makes everything else move, so out must not wait for in or fill
// (docs/memory.md).
// One lookup a cycle; two cycles less for one that follows a new line of its own set. A hit takes 4 cycles
// from in to out; a line is offered 4 cycles after it came.
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
  parameter int unsigned Parts  = 1,   // in which a line's data comes
  localparam int unsigned KeptW = (Kept > 1) ? $clog2(Kept) : 1,
  localparam int unsigned PartW = (Parts > 1) ? $clog2(Parts) : 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  output logic             hit_o,      // for the counters: one of the two for each lookup
  output logic             miss_o,     // also for a line that is waited for already

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  id_t              in_id_i,
  input  line_no_t         in_line_i,

  input  logic             keep_i,         // data_i is a kept line
  input  logic [KeptW-1:0] keep_index_i,
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

  input  logic                   data_valid_i,   // a part of a line that is waited for
  input  miss_t                  data_miss_i,
  input  logic [PartW-1:0]       data_part_i,
  input  logic [ReadW/Parts-1:0] data_i,
  input  logic                   fill_valid_i,   // all of its data came, with this or before; in any order
  output logic                   fill_ready_o,
  input  miss_t                  fill_miss_i
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
  if (Kept != 0 && Parts != 1) begin : g_kept
    $error("line_cache: kept lines come whole");
  end
  function automatic set_t set_of(line_no_t number);
    return number[Skip +: SetW];
  endfunction
  function automatic tag_t tag_of(line_no_t number);
    return number[Skip+SetW +: TagW];
  endfunction

  // ---- Look ----
  logic             emptied, room, open, look, looking, match, match_ready, looked, leaves, again_q, stale, held;
  logic             found, waits, none, served, is_new, same_set;
  logic             filled, fill, fill_load;
  logic [WayW-1:0]  found_way, put_way;
  miss_t            new_miss, found_miss, fill_miss_q;
  id_t              id_q, look_id_q;
  line_no_t         line_q, look_line_q;
  place_t           data_place, fill_place, fill_place_q;
  set_t             fill_set;
  assign fill_set = fill_place_q[PlaceW-1:WayW];

  always_comb begin
    open = emptied && room;
    if (filled) open = open && set_of(in_line_i) != fill_set;
  end
  logic look_ready;
  assign in_ready_o = open && look_ready;
  pipe_chain #(.Stages(1)) u_look (
    .clk_i, .rst_ni, .valid_i(in_valid_i && open), .ready_o(look_ready),
    .valid_o(looking), .ready_i(match_ready && !held), .load_o(look)
  );
  pipe_chain #(.Stages(1)) u_match (
    .clk_i, .rst_ni, .valid_i(looking && !held), .ready_o(match_ready),
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

  // A new line of a set: the tags of the lookup behind it are read again, if they are of that set.
  assign same_set = set_of(look_line_q) == set_of(line_q);
  assign stale    = (is_new && same_set) || (fill && set_of(look_line_q) == fill_set);
  assign held     = again_q || stale;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) again_q <= 1'b0;
    else again_q <= look ? is_new && set_of(in_line_i) == set_of(line_q) : looking && stale;
  end

  line_tags #(.Sets(Sets), .Ways(Ways), .TagW(TagW)) u_tags (
    .clk_i, .rst_ni, .ready_o(emptied),
    .look_i(look), .look_set_i(set_of(in_line_i)), .look_tag_i(tag_of(in_line_i)), .again_i(again_q),
    .match_i(match), .held_i(looked), .found_o(found), .found_way_o(found_way), .waits_o(waits), .miss_o(found_miss),
    .none_o(none), .put_way_o(put_way), .use_i(hit_o),
    .put_i(is_new), .put_miss_i(new_miss), .came_i(fill), .came_set_i(fill_set), .came_way_i(fill_place_q[WayW-1:0])
  );

  // A number for each lookup under way, in case that it needs one.
  credit #(.Limit(Misses), .Gives(2)) u_room (
    .clk_i, .rst_ni, .take_i(look), .give_i({fill, looked && leaves && !is_new}),
    .available_o(room), .idle_o()
  );

  // ---- Misses ----
  id_t head, wake_id, wake_next;
  assign is_new = looked && !found && !none && !served && !fill;
  assign miss_o = is_new || (looked && waits);
  line_misses #(.id_t(id_t), .place_t(place_t), .Misses(Misses)) u_misses (
    .clk_i, .rst_ni,
    .add_i(miss_o), .add_id_i(id_q), .new_i(is_new), .new_place_i({set_of(line_q), put_way}), .join_miss_i(found_miss),
    .new_miss_o(new_miss),
    .data_miss_i, .data_place_o(data_place), .fill_miss_i, .fill_place_o(fill_place),
    .end_i(fill), .end_miss_i(fill_miss_q), .end_head_o(head),
    .id_i(wake_id), .next_o(wake_next)
  );
  stream_fifo #(.data_t(line_req_t), .Depth(Misses)) u_req (
    .clk_i, .rst_ni,
    .valid_i(is_new), .ready_o(), .data_i('{miss: new_miss, line: line_q}),
    .valid_o(req_valid_o), .ready_i(req_ready_i), .data_o(req_o), .used_o()
  );

  // ---- Fill ----
  logic wake_room, fill_free, fill_ready, keep, stuck_q;   // stuck: the lookup in cycle 2 waits for a line of its set
  always_comb begin
    fill_free = 1'b0;
    if (filled) fill_free = wake_room && !(looked && !stuck_q && set_of(line_q) == fill_set);
  end
  assign fill = filled && fill_free;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) stuck_q <= 1'b0;
    else stuck_q <= looked && !found && none;
  end
  assign keep         = keep_i && Kept != 0;
  assign fill_ready_o = fill_ready && !keep;
  pipe_chain #(.Stages(1)) u_fill (
    .clk_i, .rst_ni, .valid_i(fill_valid_i && !keep), .ready_o(fill_ready),
    .valid_o(filled), .ready_i(fill_free), .load_o(fill_load)
  );
  always_ff @(posedge clk_i) begin
    if (fill_load) begin
      fill_miss_q  <= fill_miss_i;
      fill_place_q <= fill_place;
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
    .push_i(fill), .ready_o(wake_room), .head_i(head), .place_i(fill_place_q),
    .set_i(set_of(line_q)), .busy_o(served),
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
  assign serve_valid    = Servers'({kept_valid_i, looked && found && !waits, wake_valid});
  assign kept_ready_o   = Kept != 0 && serve_ready[Servers-1];
  assign leaves         = found ? waits || serve_ready[1] : !none && !served && !fill;
  assign hit_o          = looked && found && !waits && serve_ready[1];
  stream_arb #(.data_t(serve_t), .N(Servers)) u_serve (
    .clk_i, .rst_ni, .valid_i(serve_valid), .ready_o(serve_ready), .data_i(serve),
    .valid_o(next_valid), .ready_i(next_ready), .data_o(next), .index_o()
  );

  // ---- Data ----
  (* ram_style = "block" *) logic [Parts-1:0][ReadW/Parts-1:0] data_q [1 << DataIdxW];
  logic [ReadW-1:0] read_q, out_q;
  id_t              read_id_q, out_id_q;
  logic             read_kept_q, out_kept_q;
  logic [1:0]       load;
  data_place_t      write_place;
  assign write_place = keep ? kept_place(keep_index_i) : data_place_t'(data_place);
  pipe_chain #(.Stages(2)) u_data (
    .clk_i, .rst_ni, .valid_i(next_valid), .ready_o(next_ready),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .load_o(load)
  );
  always_ff @(posedge clk_i) begin
    if (data_valid_i || keep) begin
      for (int unsigned p = 0; p < Parts; p++)
        if (Parts == 1 || data_part_i == PartW'(p)) data_q[write_place][p] <= data_i;
    end
    if (load[0]) read_q <= data_q[next.place];
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
  stream_check #(.data_t(id_t)) u_check_out (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .data_i(out_id_o)
  );
`endif
endmodule
