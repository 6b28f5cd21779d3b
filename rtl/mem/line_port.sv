// SPDX-License-Identifier: Apache-2.0
// Fetches lines through one client of an axi_reader: a burst of four beats each. Lines come in the
// order of their requests (one AXI ID) and are given under the numbers of those.
// Each beat has its place before it is asked for: at most Lines lines may be asked for and not
// given, which is for the user to keep.
// A request is passed on in its own cycle; a line is offered the cycle after its last beat.
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

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output line_fill_t out_o,

  output logic       req_valid_o,
  input  logic       req_ready_i,
  output read_req_t  req_o,
  input  logic       rsp_valid_i,
  input  read_rsp_t  rsp_i
);
  if (LineBytes != 4 * StrbW || $bits(line_data_t) != 8 * LineBytes) begin : g_line
    $error("line_port: a line must be four beats");
  end
  localparam int unsigned PtrW = $clog2(Lines);
  localparam int unsigned CntW = $clog2(Lines + 1);
  localparam logic [PtrW-1:0] Last = PtrW'(Lines - 1);

  // ---- Ask ----
  logic  order_ready, give;
  miss_t miss;
  assign in_ready_o  = req_ready_i && order_ready;
  assign req_valid_o = in_valid_i && order_ready;
  assign req_o       = '{addr: base_i + addr_t'({in_i.line, {$clog2(LineBytes){1'b0}}}),
                         beats: BeatsW'(LineBytes / StrbW)};
  stream_fifo #(.data_t(miss_t), .Depth(Lines)) u_order (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i && req_ready_i), .ready_o(order_ready), .data_i(in_i.miss),
    .valid_o(), .ready_i(give), .data_o(miss), .used_o()
  );

  // ---- Beats: number b of a line in memory b ----
  logic [1:0]      beat_q;
  logic [PtrW-1:0] head_q, tail_q;
  logic [CntW-1:0] whole_q;         // lines
  logic            whole;           // one more, with this beat
  beat_t [3:0]     beats;
  assign whole = rsp_valid_i && beat_q == 2'd3;
  for (genvar b = 0; b < 4; b++) begin : g_beat
    beat_t mem_q [Lines];
    always_ff @(posedge clk_i) begin
      if (rsp_valid_i && beat_q == 2'(b)) mem_q[tail_q] <= rsp_i.data;
    end
    assign beats[b] = mem_q[head_q];
  end

  assign out_valid_o = whole_q != '0;
  assign out_o       = '{miss: miss, data: beats};
  assign give        = out_valid_o && out_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      beat_q  <= '0;
      head_q  <= '0;
      tail_q  <= '0;
      whole_q <= '0;
    end else begin
      if (rsp_valid_i) beat_q <= beat_q + 1'b1;
      if (whole) tail_q <= (tail_q == Last) ? '0 : tail_q + 1'b1;
      if (give) head_q <= (head_q == Last) ? '0 : head_q + 1'b1;
      if (whole != give) whole_q <= whole ? whole_q + 1'b1 : whole_q - 1'b1;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && whole) begin
      assert (rsp_i.last) else $error("a line of more than four beats");
      assert (whole_q != CntW'(Lines)) else $error("a line came that has no place");
    end
  end
`endif
endmodule
