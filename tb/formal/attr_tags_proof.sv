// SPDX-License-Identifier: Apache-2.0
// mem/attr_tags: it is asked for primitives below a number, and the window holds the attributes of as many. Then
// every burst is one whole line inside the window; at most Misses lines are asked for and not used up.
// Prove: k=1 Entries=4 Misses=2
// Prove: k=1 Entries=8 Misses=5
// Cover: 24
module attr_tags_proof
  import castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Entries = 4,
  parameter int unsigned Misses  = 2,
  localparam int unsigned PlaceW = $clog2(Entries)
) (
  input logic        clk_i,
  input logic        rst_ni,
  input addr_t       base_i,
  input prim_t       primitives_i,
  input logic        in_valid_i,
  input prim_t       in_i,
  input logic        out_ready_i,
  input logic        req_ready_i,
  input logic        given_i
);
  localparam int unsigned CntW = $clog2(Misses + 2) + 1;
  logic              hit_o, miss_o, in_ready_o, out_valid_o, out_miss_o, req_valid_o;
  logic [PlaceW-1:0] out_place_o;
  read_req_t         req_o;
  attr_tags #(.Entries(Entries), .Misses(Misses)) u_dut (.*);
  reset_first u_reset (.*);
  read_window u_window (
    .clk_i, .rst_ni, .base_i, .bytes_i(41'(primitives_i) << 6), .valid_i(req_valid_o), .ready_i(req_ready_i), .req_i(req_o)
  );
  stream_held #(.data_t(prim_t), .Assumed(1'b1)) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_o), .data_i(in_i)
  );

  logic [CntW-1:0] lines_q;     // asked for and not used up
  logic [1:0]      waiting_q;   // asked for and not on the port
  addr_t           base_q, addr_q;
  prim_t           primitives_q;
  logic first_q = 1'b1;
  always_ff @(posedge clk_i) begin
    first_q      <= 1'b0;
    base_q       <= base_i;
    primitives_q <= primitives_i;
    if (miss_o) addr_q <= base_i + (addr_t'(in_i) << 6);
    if (!rst_ni) lines_q <= '0;
    else lines_q <= lines_q + CntW'(miss_o) - CntW'(given_i);
    if (!rst_ni) waiting_q <= '0;
    else waiting_q <= waiting_q + 2'(miss_o) - 2'(req_valid_o && req_ready_i);
  end

  always_comb begin
    if (!first_q) stand_still: assume (base_i == base_q && primitives_i == primitives_q);
    window_is_legal: assume (base_i[5:0] == '0 && 42'(base_i) + (42'(primitives_i) << 6) <= 42'h100_0000_0000);
    if (rst_ni) begin
      if (in_valid_i) asks_for_primitives_of_the_image: assume (in_i < primitives_i);
      if (given_i) uses_what_came: assume (lines_q > CntW'(waiting_q));

      never_more_outstanding: assert (lines_q <= CntW'(Misses));
      if (req_valid_o) a_whole_line: assert (req_o.beats == 5'd4 && req_o.addr[5:0] == '0);
      if (req_valid_o) the_line_of_the_primitive: assert (waiting_q == 2'd1 && req_o.addr == addr_q);
      nothing_lost: assert (req_valid_o == (waiting_q != '0));

      inv_waiting: assert (waiting_q <= 2'd1 && CntW'(waiting_q) <= lines_q);
      inv_used: assert (CntW'(u_dut.u_room.used_q) == lines_q);
      if (u_dut.compare_q) inv_compare: assert (in_valid_i);
      if (waiting_q != '0)
        inv_window: assert (addr_q >= base_q && addr_q[5:0] == '0 && 42'(addr_q) + 42'd64 <= 42'(base_q) + (42'(primitives_q) << 6));

      c_full: cover (lines_q == CntW'(Misses) && u_dut.compare_q && !out_valid_o);
      c_hit: cover (hit_o);
    end
  end
endmodule
