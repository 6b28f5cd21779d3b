// SPDX-License-Identifier: Apache-2.0
// The lines that a cache waits for, at most Misses, and who waits for each. Those who wait for a
// line form a chain: head_q of the line, then next_q of each; the last one's next is itself.
//   look   cycle 0: the line is compared with all that are waited for
//   add    cycle 1: id waits for the line of the last look. If the line is new, it has a number
//          from now on and is to be asked for.
//   end    the number is free again; its chain goes to who serves it
// The last to come is the first in a chain. Whoever waits in a chain is not added before it was
// served. A line is not looked up in the cycle in which it ends. A number is free for a line that
// is added two cycles after its end, or later.
module line_misses
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter type         id_t   = ctx_t,
  parameter int unsigned Misses = DefaultCacheMisses
) (
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     look_i,
  input  line_no_t look_line_i,

  input  logic     add_i,
  input  id_t      add_id_i,
  input  line_no_t add_line_i,   // of the last look
  output logic     new_o,
  output miss_t    new_miss_o,

  input  miss_t    find_i,       // combinational
  output line_no_t find_line_o,

  input  logic     end_i,
  input  miss_t    end_miss_i,
  output id_t      end_head_o,

  input  id_t      id_i,         // combinational, for who serves a chain
  output id_t      next_o
);
  if (Misses < 2 || Misses > 2 ** MissW) begin : g_misses
    $error("line_misses: Misses must be 2 to %0d", 2 ** MissW);
  end

  typedef logic [$clog2(Misses)-1:0] number_t;
  logic [Misses-1:0] used_q, match_q;
  logic [Misses-1:0] free_q;             // the number that the next new line takes, one bit; none: zero
  logic [Misses-1:0] rest;               // that and those in use
  line_no_t          line_q [Misses];    // all compared at once
  line_no_t          find_q [Misses];    // the same, where one is read
  id_t               head_q [Misses];
  id_t               next_q [2**$bits(id_t)];
  number_t           at, find, finish;
  assign find   = number_t'(find_i);
  assign finish = number_t'(end_miss_i);

  // Three bits a LUT, joined by a carry.
  function automatic logic same(line_no_t a, line_no_t b);
    localparam int unsigned Groups = ($bits(line_no_t) + 2) / 3;
    logic [3*Groups-1:0] differ;
    logic [Groups-1:0]   equal;
    logic [Groups:0]     carry;
    differ = (3*Groups)'(a) ^ (3*Groups)'(b);
    for (int unsigned g = 0; g < Groups; g++) equal[g] = differ[3*g +: 3] == '0;
    carry = {1'b0, equal} + 1'b1;
    return carry[Groups];
  endfunction

  // ---- Look: as the lines will be in cycle 1 ----
  always_ff @(posedge clk_i) begin
    if (look_i) begin
      for (int unsigned i = 0; i < Misses; i++) begin
        match_q[i] <= 1'b0;
        if (new_o && free_q[i]) match_q[i] <= add_line_i == look_line_i;
        else if (used_q[i]) match_q[i] <= same(line_q[i], look_line_i);
      end
    end
  end

  // ---- Add: to the line that matches, or to the free number that is held ready ----
  assign new_o      = add_i && match_q == '0;
  assign new_miss_o = miss_t'(at);
  function automatic number_t number(logic [Misses-1:0] one);
    number = '0;
    for (int unsigned i = 0; i < Misses; i++) if (one[i]) number |= number_t'(i);
  endfunction
  assign at = number(match_q) | ((match_q == '0) ? number(free_q) : '0);
  assign rest = used_q | free_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) free_q <= '0;
    else if (new_o || free_q == '0) free_q <= ~rest & (rest + 1'b1);
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) used_q <= '0;
    else begin
      if (new_o) used_q <= rest;
      if (end_i) used_q[finish] <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (new_o) begin
      for (int unsigned i = 0; i < Misses; i++) if (free_q[i]) line_q[i] <= add_line_i;
      find_q[at] <= add_line_i;
    end
    if (add_i) begin
      head_q[at]       <= add_id_i;
      next_q[add_id_i] <= new_o ? add_id_i : head_q[at];
    end
  end

  assign find_line_o = find_q[find];
  assign end_head_o  = head_q[finish];
  assign next_o      = next_q[id_i];

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && add_i) begin
      assert (!new_o || free_q != '0) else $error("no number is free");
      assert ($onehot0(match_q)) else $error("a line is waited for twice");
    end
    if (rst_ni && end_i) assert (used_q[finish]) else $error("nobody waits for this line");
  end
`endif
endmodule
