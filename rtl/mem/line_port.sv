// SPDX-License-Identifier: Apache-2.0
// Fetches lines through one client of an axi_reader: a burst of four beats each. Lines come in the
// order of their requests (one AXI ID). Each beat is passed on as it comes, with the number of its line
// and its own, and after the last the line's number is offered: every beat has its place before it is
// asked for.
// At most Lines lines may be asked for and not given, which is for the user to keep.
// A request is passed on in its own cycle, a beat too; a line is offered the cycle after its last beat.
module line_port
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Lines = DefaultL2Misses
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  addr_t      base_i,        // of line 0

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  line_req_t  in_i,

  output logic       data_valid_o,
  output miss_t      data_miss_o,
  output logic [1:0] data_beat_o,
  output beat_t      data_o,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output miss_t      out_miss_o,

  output logic       req_valid_o,
  input  logic       req_ready_i,
  output read_req_t  req_o,
  input  logic       rsp_valid_i,
  input  read_rsp_t  rsp_i
);
  if (LineBytes != 4 * StrbW || $bits(line_data_t) != 8 * LineBytes) begin : g_line
    $error("line_port: a line must be four beats");
  end
  // ---- Ask ----
  logic order_ready, whole;
  assign in_ready_o  = req_ready_i && order_ready;
  assign req_valid_o = in_valid_i && order_ready;
  assign req_o       = '{addr: base_i + addr_t'({in_i.line, {$clog2(LineBytes){1'b0}}}),
                         beats: BeatsW'(LineBytes / StrbW)};
  stream_fifo #(.data_t(miss_t), .Depth(Lines)) u_order (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i && req_ready_i), .ready_o(order_ready), .data_i(in_i.miss),
    .valid_o(), .ready_i(whole), .data_o(data_miss_o), .used_o()
  );

  // ---- Beats ----
  logic [1:0] beat_q;
  logic       out_ready;
  assign data_valid_o = rsp_valid_i;
  assign data_beat_o  = beat_q;
  assign data_o       = rsp_i.data;
  assign whole        = rsp_valid_i && beat_q == 2'd3;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) beat_q <= '0;
    else if (rsp_valid_i) beat_q <= beat_q + 1'b1;
  end
  stream_fifo #(.data_t(miss_t), .Depth(Lines)) u_whole (
    .clk_i, .rst_ni,
    .valid_i(whole), .ready_o(out_ready), .data_i(data_miss_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_miss_o), .used_o()
  );

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && whole) begin
      assert (rsp_i.last) else $error("a line of more than four beats");
      assert (out_ready) else $error("a line came that has no place");
    end
  end
`endif
endmodule
