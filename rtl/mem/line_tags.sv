// SPDX-License-Identifier: Apache-2.0
// The tags of a cache of lines: Sets sets of Ways ways, and which way of a set to replace.
//   look   cycle 0: a set's tags out of the memory; again_i: once more those of the last look
//   match  a cycle later or more: they are compared, three bits each
//          from the cycle behind that until the next match, while held_i: found_o, and the way; whether
//          the line there is still waited for and under which number; else the way to replace, or
//          that the lines of all ways are waited for
//   put    the line of the last match takes that way, and is waited for under put_miss_i
//   came   a line is not waited for any more
// A look takes 2 cycles; one may come with the match of the one before. A set's tags are to be read
// again if a line was put there between a look, its cycle too, and the match. Replaced is the way that a
// tree of one bit a fork points to, or the first if that one's line is waited for: each use and each put
// turns the forks above the way away from it. With two ways that is the one used longer ago, and an empty
// way comes first. A use does not turn the forks for a match in its cycle, and not at all if a line comes.
// After a reset the sets are emptied, one a cycle; only then ready_o, and a look. A line is not put in the
// cycle in which one comes.
// The place of a line under way is that of its answer: Farkas and Jouppi 1994, in-cache MSHRs.
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
  input  logic            again_i,
  input  logic            match_i,
  input  logic            held_i,
  output logic            found_o,
  output logic [WayW-1:0] found_way_o,
  output logic            waits_o,       // with found_o
  output miss_t           miss_o,        // with waits_o
  output logic            none_o,        // no way to replace
  output logic [WayW-1:0] put_way_o,
  input  logic            use_i,         // what was found is used

  input  logic            put_i,
  input  miss_t           put_miss_i,
  input  logic            came_i,
  input  logic [SetW-1:0] came_set_i,
  input  logic [WayW-1:0] came_way_i
);
  if (Sets < 2 || (Sets & (Sets - 1)) != 0) begin : g_sets
    $error("line_tags: Sets must be a power of two, at least 2");
  end
  if (Ways < 2 || (Ways & (Ways - 1)) != 0) begin : g_ways
    $error("line_tags: Ways must be a power of two, at least 2");
  end
  typedef struct packed {
    logic            waits;   // written alone too: a byte of a block RAM
    logic            full;
    miss_t           miss;
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
  logic [SetW-1:0] read_set, write_set, look_set_q, set_q;
  logic [TagW-1:0] look_tag_q, tag_q;
  logic [Ways-1:0] found, waits;
  miss_t           miss_q [Ways];
  assign read_set  = again_i ? look_set_q : look_set_i;
  always_comb begin
    write_set = set_q;
    if (came_i) write_set = came_set_i;
    if (!ready_o) write_set = emptied_q[SetW-1:0];
  end
  always_ff @(posedge clk_i) begin
    if (look_i) begin
      look_set_q <= look_set_i;
      look_tag_q <= look_tag_i;
    end
    if (match_i) begin
      set_q <= look_set_q;
      tag_q <= look_tag_q;
    end
  end
  for (genvar w = 0; w < Ways; w++) begin : g_way
    (* ram_style = "block" *) entry_t way_q [Sets];
    entry_t look_q;
    logic                full_q;
    logic [Groups-1:0]   same_q;
    logic [3*Groups-1:0] differ;
    assign differ = (3*Groups)'(look_q.tag) ^ (3*Groups)'(look_tag_q);
    logic                put, come;
    assign put  = !ready_o || (put_i && put_way_o == WayW'(w));
    assign come = came_i && came_way_i == WayW'(w);
    always_ff @(posedge clk_i) begin
      if (put || come) way_q[write_set].waits <= !come;
      if (put) begin
        way_q[write_set].full <= ready_o;
        way_q[write_set].miss <= put_miss_i;
        way_q[write_set].tag  <= tag_q;
      end
      if (look_i || again_i) look_q <= way_q[read_set];
    end
    always_ff @(posedge clk_i) begin
      if (match_i) begin
        full_q    <= look_q.full;
        miss_q[w] <= look_q.miss;
        for (int unsigned g = 0; g < Groups; g++) same_q[g] <= differ[3*g +: 3] == '0;
      end
    end
    always_comb begin
      found[w] = 1'b0;
      if (held_i) found[w] = full_q && (&same_q);
    end

    logic held_waits_q;
    always_ff @(posedge clk_i) begin
      if (match_i) held_waits_q <= look_q.full && look_q.waits;
      else if (come && came_set_i == set_q) held_waits_q <= 1'b0;
    end
    assign waits[w] = held_waits_q;
  end
  assign found_o = |found;
  assign waits_o = |(found & waits);
  assign none_o  = &waits;
  always_comb begin
    found_way_o = '0;
    miss_o      = '0;
    for (int unsigned w = 0; w < Ways; w++) begin
      if (found[w]) found_way_o |= WayW'(w);
      if (found[w]) miss_o |= miss_q[w];
    end
  end

  // ---- Forks: number 1 is the root, n forks into 2n and 2n+1, Ways + w is way w; 1: to the upper half ----
  typedef logic [Ways-1:1] forks_t;
  forks_t          forks_q [Sets];
  forks_t          held_forks_q, turned;
  logic [WayW-1:0] used_way;
  assign used_way = put_i ? put_way_o : found_way_o;
  for (genvar n = 1; n < Ways; n++) begin : g_fork
    localparam int unsigned Level = $clog2(Ways) - ($clog2(n + 1) - 1);   // ways below it, log2
    logic above;
    assign above     = ((Ways + 32'(used_way)) >> Level) == n;
    assign turned[n] = above ? !used_way[Level-1] : held_forks_q[n];
  end
  always_ff @(posedge clk_i) begin
    if (!ready_o || put_i || (use_i && !came_i)) forks_q[write_set] <= ready_o ? turned : '0;
  end
  always_ff @(posedge clk_i) begin
    if (match_i) held_forks_q <= forks_q[look_set_q];
  end
  function automatic logic [WayW-1:0] pointed(forks_t to);
    logic [WayW:0] n;
    n = 1;
    for (int unsigned l = 0; l < WayW; l++) n = {n[WayW-1:0], to[n[WayW-1:0]]};
    return n[WayW-1:0];
  endfunction
  logic [WayW-1:0] older;
  assign older = pointed(held_forks_q);
  always_comb begin
    put_way_o = older;
    if (waits[older]) begin
      put_way_o = '0;
      for (int unsigned w = Ways; w > 0; w--) if (!waits[w-1]) put_way_o = WayW'(w - 1);
    end
  end
endmodule
