// SPDX-License-Identifier: Apache-2.0
// The lines that a cache waits for, at most Misses, and who waits for each. Those who wait for a
// line form a chain: head_q of the line, then next_q of each; the last one's next is itself.
//   add    id waits for a line: a new one, which gets new_miss_o as its number, or the one that has
//          the number join_miss_i
//   data, fill   the place that the line of a number has
//   end    the number is free again; its chain goes to who serves it
// The last to come is the first in a chain. Whoever waits in a chain is not added before it was
// served. A line that ends is not joined in that cycle. The user bounds the new lines.
module line_misses
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter type         id_t    = ctx_t,
  parameter type         place_t = logic [8:0],
  parameter int unsigned Misses  = DefaultCacheMisses
) (
  input  logic   clk_i,
  input  logic   rst_ni,

  input  logic   add_i,
  input  id_t    add_id_i,
  input  logic   new_i,        // only with add_i
  input  place_t new_place_i,
  input  miss_t  join_miss_i,
  output miss_t  new_miss_o,   // stands there before the line is added

  input  miss_t  data_miss_i,  // combinational
  output place_t data_place_o,
  input  miss_t  fill_miss_i,
  output place_t fill_place_o,

  input  logic   end_i,
  input  miss_t  end_miss_i,
  output id_t    end_head_o,

  input  id_t    id_i,         // combinational, for who serves a chain
  output id_t    next_o
);
  if (Misses < 2 || Misses > 2 ** MissW) begin : g_misses
    $error("line_misses: Misses must be 2 to %0d", 2 ** MissW);
  end

  typedef logic [$clog2(Misses)-1:0] number_t;
  place_t  place_q [Misses];
  id_t     head_q  [Misses];
  id_t     next_q  [2**$bits(id_t)];
  number_t free, at;
  free_list #(.N(Misses)) u_free (
    .clk_i, .rst_ni, .valid_o(), .number_o(free), .take_i(new_i), .give_i(end_i), .number_i(number_t'(end_miss_i))
  );
  assign new_miss_o = miss_t'(free);
  assign at         = new_i ? free : number_t'(join_miss_i);
  always_ff @(posedge clk_i) begin
    if (new_i) place_q[free] <= new_place_i;
    if (add_i) begin
      head_q[at]       <= add_id_i;
      next_q[add_id_i] <= new_i ? add_id_i : head_q[at];
    end
  end

  assign data_place_o = place_q[number_t'(data_miss_i)];
  assign fill_place_o = place_q[number_t'(fill_miss_i)];
  assign end_head_o   = head_q[number_t'(end_miss_i)];
  assign next_o       = next_q[id_i];

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && new_i) assert (add_i) else $error("a line is new to nobody");
    if (rst_ni && add_i && !new_i && end_i) assert (at != number_t'(end_miss_i)) else $error("a line that ends is joined");
  end
`endif
endmodule
