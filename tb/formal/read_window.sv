// SPDX-License-Identifier: Apache-2.0
// What an axi_reader asks of each of its clients, and what the memory's owner asks of all: a burst has 1 to 16
// beats, stays inside a 4 KiB page and inside a window of memory, and stands still until it is taken.
module read_window
  import castray_pkg::*;
(
  input logic              clk_i,
  input logic              rst_ni,
  input addr_t             base_i,     // the window's first byte,
  input logic [AddrW:0]    bytes_i,    // and how many it has
  input logic              valid_i,
  input logic              ready_i,
  input read_req_t         req_i
);
  stream_held #(.data_t(read_req_t)) u_held (.clk_i, .rst_ni, .valid_i, .ready_i, .data_i(req_i));
  localparam int unsigned W = AddrW + 2;
  logic [W-1:0] first, behind;
  assign first  = W'(req_i.addr);
  assign behind = W'(req_i.addr) + (W'(req_i.beats) << $clog2(StrbW));
  always_comb begin
    if (rst_ni && valid_i) begin
      one_to_16_beats: assert (req_i.beats >= 1 && req_i.beats <= 16);
      whole_beats: assert (req_i.addr[$clog2(StrbW)-1:0] == '0);
      inside_4_kib: assert (W'(req_i.addr[11:0]) + (behind - first) <= W'(4096));
      inside_window: assert (first >= W'(base_i) && behind <= W'(base_i) + W'(bytes_i));
    end
  end
endmodule
