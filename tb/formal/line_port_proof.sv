// SPDX-License-Identifier: Apache-2.0
// mem/line_port: its user asks for lines of a window, at most Lines that are not given yet. Then every burst is one
// whole line inside the window, each beat is passed on with its line's number and its own, and each line is given
// once, in order, after its four beats.
// Prove: k=1 Lines=2
// Prove: k=1 Lines=3
// Cover: 24
module line_port_proof
  import castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Lines = 2
) (
  input logic           clk_i,
  input logic           rst_ni,
  input addr_t          base_i,
  input logic [LineNoW:0] lines_i,      // of the window
  input logic           choose_i,
  input logic [1:0]     beat_i,       // any one beat of the followed line
  input logic           in_valid_i,
  input line_req_t      in_i,
  input logic           out_ready_i,
  input logic           req_ready_i,
  input logic           rsp_valid_i,
  input beat_t          data_i
);
  localparam int unsigned CntW  = $clog2(Lines + 2);
  localparam int unsigned PtrW  = $clog2(Lines);
  localparam int unsigned BeatW = CntW + 3;
  typedef logic [BeatW-1:0] beats_t;
  logic       in_ready_o, data_valid_o, out_valid_o, req_valid_o;
  miss_t      data_miss_o, out_miss_o;
  logic [1:0] data_beat_o;
  beat_t      data_o;
  read_req_t  req_o;
  read_rsp_t  rsp_i;
  line_port #(.Lines(Lines)) u_dut (.*);
  reset_first u_reset (.*);
  read_window u_window (
    .clk_i, .rst_ni, .base_i, .bytes_i(41'(lines_i) << 6), .valid_i(req_valid_o), .ready_i(req_ready_i), .req_i(req_o)
  );
  stream_held #(.data_t(line_req_t), .Assumed(1'b1)) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_o), .data_i(in_i)
  );

  // Beats asked for that have not come.
  beats_t due_q;
  logic   ask, give;
  assign ask   = req_valid_o && req_ready_i;
  assign give  = out_valid_o && out_ready_i;
  assign rsp_i = '{last: due_q[1:0] == 2'd1, data: data_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) due_q <= '0;
    else due_q <= due_q + (ask ? beats_t'(4) : '0) - beats_t'(rsp_valid_i);
  end

  logic [CntW-1:0] asked, ahead;
  logic            follows;
  miss_t           miss;
  stream_follow #(.data_t(miss_t), .Most(Lines)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(ask), .in_i(in_i.miss),
    .out_valid_i(out_valid_o), .out_ready_i(out_ready_i), .out_i(out_miss_o),
    .inside_o(asked), .follows_o(follows), .ahead_o(ahead), .item_o(miss)
  );

  // The followed line's beat beat_i: beats that come before it, or the beat.
  logic [1:0] beat_q;
  beats_t     before_q;
  logic       came_q, comes;
  stream_held #(.data_t(miss_t)) u_out (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .data_i(out_miss_o)
  );
  assign comes = follows && rsp_valid_i && before_q == '0 && !came_q;
  logic first_q = 1'b1;
  addr_t             base_q;
  logic [LineNoW:0]  lines_q;
  always_ff @(posedge clk_i) begin
    first_q <= 1'b0;
    beat_q  <= beat_i;
    base_q  <= base_i;
    lines_q <= lines_i;
    if (!follows) begin
      came_q   <= 1'b0;
      before_q <= due_q - beats_t'(rsp_valid_i) + beats_t'(beat_i);
    end else if (comes) begin
      came_q <= 1'b1;
    end else if (rsp_valid_i && !came_q) before_q <= before_q - 1'b1;
  end

  function automatic logic [PtrW-1:0] behind(logic [PtrW-1:0] place, logic [CntW-1:0] more);
    logic [CntW:0] sum;
    sum = (CntW+1)'(place) + (CntW+1)'(more);
    return PtrW'((sum >= (CntW+1)'(Lines)) ? sum - (CntW+1)'(Lines) : sum);
  endfunction
  // Lines that are waited for, and those that came; of the followed one those before it that are waited for.
  logic [CntW-1:0] waits, whole, earlier;
  assign waits  = CntW'(u_dut.u_order.used_q);
  assign whole  = CntW'(u_dut.u_whole.used_q);
  assign earlier = ahead - whole;

  always_comb begin
    if (!first_q) stand_still: assume (beat_i == beat_q && base_i == base_q && lines_i == lines_q);
    window_is_legal: assume (base_i[5:0] == '0 && 42'(base_i) + (42'(lines_i) << 6) <= 42'h100_0000_0000);
    if (rst_ni) begin
      if (in_valid_i) asks_for_lines_of_the_window: assume ((LineNoW+1)'(in_i.line) < lines_i && asked < CntW'(Lines));
      if (rsp_valid_i) memory_answers_what_was_asked: assume (due_q != '0);

      if (req_valid_o) a_whole_line: assert (req_o.beats == 5'd4 && req_o.addr[5:0] == '0);
      if (req_valid_o) the_line_asked_for: assert (req_o.addr == base_i + (addr_t'(in_i.line) << 6));
      if (out_valid_o && follows && ahead == '0) after_its_beats: assert (came_q);
      a_beat_each: assert (data_valid_o == rsp_valid_i && data_o == rsp_i.data);
      if (comes) its_own_beats: assert (data_miss_o == miss && data_beat_o == beat_i);
      nothing_lost: assert (out_valid_o == (asked != '0 && due_q <= beats_t'(asked - 1'b1) << 2));

      inv_counts: assert (asked == waits + whole && due_q == (beats_t'(waits) << 2) - beats_t'(u_dut.beat_q) &&
                          asked <= CntW'(Lines) && (waits != '0 || u_dut.beat_q == '0));
      inv_order: assert ((CntW+1)'(u_dut.u_order.head_q) < (CntW+1)'(Lines) && waits <= CntW'(Lines) &&
                         u_dut.u_order.tail_q == behind(u_dut.u_order.head_q, waits));
      inv_whole: assert ((CntW+1)'(u_dut.u_whole.head_q) < (CntW+1)'(Lines) && whole <= CntW'(Lines) &&
                         u_dut.u_whole.tail_q == behind(u_dut.u_whole.head_q, whole));
      if (follows && ahead < whole) inv_came: assert (came_q && u_dut.u_whole.mem_q[behind(u_dut.u_whole.head_q, ahead)] == miss);
      if (follows && ahead >= whole) begin
        inv_miss: assert (u_dut.u_order.mem_q[behind(u_dut.u_order.head_q, earlier)] == miss);
        inv_before: assert (came_q == (earlier == '0 && u_dut.beat_q > beat_i) &&
                            (came_q || before_q == (beats_t'(earlier) << 2) + beats_t'(beat_i) - beats_t'(u_dut.beat_q)));
      end

      c_full: cover (asked == CntW'(Lines) && due_q == '0);
      c_given: cover (give && follows && ahead == '0 && asked == CntW'(1));
    end
  end
endmodule
