// SPDX-License-Identifier: Apache-2.0
// mem/ray_reader: it is started with a window of memory that holds the list. Then every burst lies inside the
// window, and each record that is asked for has a place in the queue.
// Prove: k=1 Depth=4
// Prove: k=1 Depth=6
// Cover: 40
module ray_reader_proof
  import castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Depth = 4
) (
  input logic       clk_i,
  input logic       rst_ni,
  input logic       start_i,
  input addr_t      base_i,
  input ray_count_t count_i,
  input logic       req_ready_i,
  input logic       rsp_valid_i,
  input beat_t      data_i,
  input logic       out_ready_i
);
  logic      done_o, req_valid_o, out_valid_o;
  error_t    fault_o;
  read_req_t req_o;
  read_rsp_t rsp_i;
  ray_req_t  out_o;
  ray_reader #(.Depth(Depth)) u_dut (.*);
  reset_first u_reset (.*);
  localparam int unsigned BeatW = $clog2(4 * Depth + 32);
  typedef logic [BeatW-1:0] beats_t;
  beats_t due;
  read_window u_window (
    .clk_i, .rst_ni, .base_i, .bytes_i(41'(count_i) << 6), .valid_i(req_valid_o), .ready_i(req_ready_i), .req_i(req_o)
  );
  read_beats #(.Most(4 * Depth)) u_beats (
    .clk_i, .rst_ni, .req_valid_i(req_valid_o), .req_ready_i, .req_i(req_o), .rsp_valid_i, .beats_o(due)
  );
  assign rsp_i = '{last: 1'b0, data: data_i};   // not looked at

  // A start is allowed before the first and when all is done; the window stands still meanwhile.
  logic       busy_q;
  addr_t      base_q;
  ray_count_t count_q, asked_q;
  always_ff @(posedge clk_i) begin
    base_q  <= base_i;
    count_q <= count_i;
    if (!rst_ni) busy_q <= 1'b0;
    else if (start_i) busy_q <= 1'b1;
    if (start_i) asked_q <= '0;
    else if (req_valid_o && req_ready_i) asked_q <= asked_q + ray_count_t'(req_o.beats >> 2);
  end

  always_comb begin
    if (rst_ni) begin
      if (start_i) starts_when_idle: assume (!busy_q || done_o);
      if (busy_q && !start_i) stands_still: assume (base_i == base_q && count_i == count_q);
      window_is_legal: assume (base_i[5:0] == '0 && count_i != '0 && 42'(base_i) + (42'(count_i) << 6) <= 42'h100_0000_0000);

      if (rsp_valid_i && due[1:0] == 2'd1) a_place_for_each_record: assert (u_dut.u_queue.ready_o);
      if (req_valid_o) in_order: assert (busy_q && req_o.addr == base_i + (addr_t'(asked_q) << 6));
      if (busy_q && done_o) all_of_the_list: assert (asked_q == count_q && due == '0 && !out_valid_o);

      inv_left: assert (busy_q || u_dut.left_q == '0);
      if (busy_q)
        inv_asked: assert (asked_q <= count_q && u_dut.left_q == count_q - asked_q && u_dut.addr_q == base_q + (addr_t'(asked_q) << 6) &&
                           base_q[5:0] == '0 && 42'(base_q) + (42'(count_q) << 6) <= 42'h100_0000_0000);
      inv_places: assert (beats_t'(u_dut.free_q) * beats_t'(4) + due + beats_t'(u_dut.beat_q) + beats_t'(u_dut.u_queue.used_q) * beats_t'(4)
                          == beats_t'(4 * Depth));
      inv_bounds: assert (32'(u_dut.free_q) <= Depth && 32'(u_dut.u_queue.used_q) <= Depth && due <= beats_t'(4 * Depth));
      inv_started: assert (u_dut.started_q == busy_q);
      if (!busy_q) inv_idle: assert (due == '0 && u_dut.beat_q == '0 && !out_valid_o);

      c_full_burst: cover (req_valid_o && req_ready_i && req_o.beats == 5'd16);
      c_full: cover (32'(u_dut.u_queue.used_q) == Depth);
    end
  end
endmodule
