// SPDX-License-Identifier: Apache-2.0
// The tags of a cache of lines: Sets sets of Ways ways, and which way of a set to replace.
//   look   cycle 0: a set's tags out of the memory
//   match  a cycle later or more: they are compared, three bits each
//          from the cycle behind that until the next match, while held_i: found_o, and the way
//   choose a cycle before a fill or more: the way to replace -> fill_way_o, until the next
//   fill   the tag replaces that of fill_way_o, all in one cycle
// A look takes 2 cycles; one may come with the match of the one before. Replaced is the way that a tree
// of one bit a fork points to: each use turns the forks above it away from it. With two ways that is the
// one used longer ago, and an empty way comes first.
// A set is not filled from its look until what was found is used. A use in the cycle of a fill does not
// turn the forks.
// After a reset the sets are emptied, one a cycle; only then ready_o, and a look or a fill.
module line_tags
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Sets = DefaultCacheLines / DefaultCacheWays,
  parameter int unsigned Ways = DefaultCacheWays,
  parameter int unsigned TagW = LineNoW - $clog2(Sets),
  localparam int unsigned SetW = $clog2(Sets),
  localparam int unsigned WayW = $clog2(Ways)
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  output logic            ready_o,

  input  logic            look_i,
  input  logic [SetW-1:0] look_set_i,
  input  logic [TagW-1:0] look_tag_i,
  input  logic            match_i,
  input  logic            held_i,
  output logic            found_o,
  output logic [WayW-1:0] found_way_o,
  input  logic            use_i,         // what was found is used

  input  logic            choose_i,
  input  logic [SetW-1:0] choose_set_i,
  input  logic            fill_i,
  input  logic [SetW-1:0] fill_set_i,
  input  logic [TagW-1:0] fill_tag_i,
  output logic [WayW-1:0] fill_way_o
);
  if (Sets < 2 || (Sets & (Sets - 1)) != 0) begin : g_sets
    $error("line_tags: Sets must be a power of two, at least 2");
  end
  if (Ways < 2 || (Ways & (Ways - 1)) != 0) begin : g_ways
    $error("line_tags: Ways must be a power of two, at least 2");
  end
  typedef struct packed {
    logic            full;
    logic [TagW-1:0] tag;
  } entry_t;

  // ---- Emptying ----
  logic [SetW:0] emptied_q;   // sets
  assign ready_o = emptied_q[SetW];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) emptied_q <= '0;
    else if (!ready_o) emptied_q <= emptied_q + 1'b1;
  end

  // ---- Tags ----
  localparam int unsigned Groups = (TagW + 2) / 3;
  logic [SetW-1:0] write_set, look_set_q, set_q;
  logic [TagW-1:0] tag_q;
  logic [Ways-1:0] found;
  logic            write;
  assign write     = fill_i || !ready_o;
  assign write_set = ready_o ? fill_set_i : emptied_q[SetW-1:0];
  always_ff @(posedge clk_i) begin
    if (look_i) begin
      look_set_q <= look_set_i;
      tag_q      <= look_tag_i;
    end
    if (match_i) set_q <= look_set_q;
  end
  for (genvar w = 0; w < Ways; w++) begin : g_way
    entry_t way_q [Sets];
    entry_t look_q;
    logic                full_q;
    logic [Groups-1:0]   same_q;
    logic [3*Groups-1:0] differ;
    assign differ = (3*Groups)'(look_q.tag) ^ (3*Groups)'(tag_q);
    always_ff @(posedge clk_i) begin
      if (write) begin
        if (!ready_o || fill_way_o == WayW'(w)) way_q[write_set] <= '{full: ready_o, tag: fill_tag_i};
      end
      if (look_i) look_q <= way_q[look_set_i];
    end
    always_ff @(posedge clk_i) begin
      if (match_i) begin
        full_q <= look_q.full;
        for (int unsigned g = 0; g < Groups; g++) same_q[g] <= differ[3*g +: 3] == '0;
      end
    end
    always_comb begin
      found[w] = 1'b0;
      if (held_i) found[w] = full_q && (&same_q);
    end
  end
  assign found_o = |found;
  always_comb begin
    found_way_o = '0;
    for (int unsigned w = 0; w < Ways; w++) if (found[w]) found_way_o |= WayW'(w);
  end

  // ---- Forks: number 1 is the root, n forks into 2n and 2n+1, Ways + w is way w ----
  logic [Ways-1:1] points;       // of the set to choose from: to the upper half
  logic [WayW-1:0] used_way;
  logic [SetW-1:0] turn_set;
  logic            turn;
  assign turn     = write || use_i;
  assign used_way = fill_i ? fill_way_o : found_way_o;
  assign turn_set = write ? write_set : set_q;
  for (genvar n = 1; n < Ways; n++) begin : g_fork
    localparam int unsigned Level = $clog2(Ways) - ($clog2(n + 1) - 1);   // ways below it, log2
    logic points_q [Sets];
    logic above, upper;
    assign above = ((Ways + 32'(used_way)) >> Level) == n;
    assign upper = used_way[Level-1];
    always_ff @(posedge clk_i) begin
      if (turn) begin
        if (!ready_o || above) points_q[turn_set] <= ready_o && !upper;
      end
    end
    assign points[n] = points_q[choose_set_i];
  end
  function automatic logic [WayW-1:0] pointed(logic [Ways-1:1] to);
    logic [WayW:0] n;
    n = 1;
    for (int unsigned l = 0; l < WayW; l++) n = {n[WayW-1:0], to[n[WayW-1:0]]};
    return n[WayW-1:0];
  endfunction
  always_ff @(posedge clk_i) begin
    if (choose_i) fill_way_o <= pointed(points);
  end
endmodule
