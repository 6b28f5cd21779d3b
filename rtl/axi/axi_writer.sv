// SPDX-License-Identifier: Apache-2.0
// The write half of an AXI4 port: takes whole bursts from Clients and sends them.
//   take    round robin, while fewer than MaxWrites bursts are outstanding and block_i is low,
//           in the cycle in which the last beat of the burst before leaves: one beat a cycle
//   AW      from a register of two places, so an address may be ahead of its data or behind;
//           INCR, 16 bytes a beat, AxCACHE 0011, the ID is the client's number
//   W       the burst shifts out of its register, lowest bytes first
//   B       always taken
// A client's burst has 1, 2 or 4 beats, MaxBeats at most, and is aligned to its own size.
// error_o: a response came with an error (one cycle).
// block_i: no burst is taken; those taken before are sent whole. idle_o: nothing is outstanding.
// Latency: 1 cycle from a request to AW and to the first beat of W.
module axi_writer
  import castray_pkg::*;
#(
  parameter int unsigned Clients   = WriteClients,
  parameter int unsigned MaxWrites = 16,
  parameter int unsigned MaxBeats  = 4
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic [Clients-1:0] req_valid_i,
  output logic [Clients-1:0] req_ready_o,
  input  write_req_t         req_i [Clients],

  input  logic               block_i,
  output logic               idle_o,
  output logic               error_o,
  output logic               beat_o,    // a beat left: for the counter

  output logic               m_axi_awvalid_o,
  input  logic               m_axi_awready_i,
  output addr_t              m_axi_awaddr_o,
  output logic [3:0]         m_axi_awid_o,
  output logic [7:0]         m_axi_awlen_o,
  output logic [2:0]         m_axi_awsize_o,
  output logic [1:0]         m_axi_awburst_o,
  output logic [3:0]         m_axi_awcache_o,
  output logic [2:0]         m_axi_awprot_o,

  output logic               m_axi_wvalid_o,
  input  logic               m_axi_wready_i,
  output beat_t              m_axi_wdata_o,
  output logic [StrbW-1:0]   m_axi_wstrb_o,
  output logic               m_axi_wlast_o,

  input  logic               m_axi_bvalid_i,
  output logic               m_axi_bready_o,
  input  logic [3:0]         m_axi_bid_i,      // not needed: the clients await no response
  input  logic [1:0]         m_axi_bresp_i
);
  if (Clients < 1 || Clients > 16) begin : g_clients
    $error("axi_writer: Clients must be 1 to 16, the IDs of the port");
  end
  if (MaxWrites < 1 || MaxWrites > 256) begin : g_writes
    $error("axi_writer: MaxWrites must be 1 to 256");
  end
  if (MaxBeats != 1 && MaxBeats != 2 && MaxBeats != 4) begin : g_beats
    $error("axi_writer: MaxBeats must be 1, 2 or 4");
  end

  localparam int unsigned IdxW = (Clients > 1) ? $clog2(Clients) : 1;
  localparam int unsigned CntW = $clog2(MaxWrites + 1);

  // ---- Take: the choice between clients is forgotten while blocked, for they may be reset then ----
  logic            any_valid, room, cut_ready, data_ready, take;
  logic [IdxW-1:0] client;
  write_req_t      req;
  logic            chosen [Clients];
  assign chosen = '{default: 1'b0};
  stream_arb #(.data_t(logic), .N(Clients)) u_arb (   // only the choice: a burst is wide, it goes straight to its registers
    .clk_i, .rst_ni(rst_ni && !block_i),
    .valid_i(req_valid_i), .ready_o(req_ready_o), .data_i(chosen),
    .valid_o(any_valid), .ready_i(room && cut_ready && data_ready), .data_o(), .index_o(client)
  );
  assign req  = req_i[client];
  assign take = any_valid && room && cut_ready && data_ready;

  // ---- AW ----
  typedef struct packed {
    logic [3:0] id;
    logic [2:0] beats;
    addr_t      addr;
  } aw_t;
  aw_t aw;
  pipe_cut #(.data_t(aw_t)) u_aw (
    .clk_i, .rst_ni,
    .valid_i(any_valid && room && data_ready), .ready_o(cut_ready),
    .data_i('{id: 4'(client), beats: req.beats, addr: req.addr}),
    .valid_o(m_axi_awvalid_o), .ready_i(m_axi_awready_i), .data_o(aw)
  );
  assign m_axi_awaddr_o  = aw.addr;
  assign m_axi_awid_o    = aw.id;
  assign m_axi_awlen_o   = 8'(aw.beats) - 8'd1;
  assign m_axi_awsize_o  = 3'($clog2(StrbW));
  assign m_axi_awburst_o = 2'b01;
  assign m_axi_awcache_o = 4'b0011;
  assign m_axi_awprot_o  = 3'b000;

  // ---- W: the burst in flight, its next beat at index 0 ----
  logic [2:0]       left_q;
  beat_t            data_q [MaxBeats];
  logic [StrbW-1:0] strb_q [MaxBeats];
  logic             send;
  assign send           = m_axi_wvalid_o && m_axi_wready_i;
  assign data_ready     = left_q == '0 || (send && m_axi_wlast_o);
  assign m_axi_wvalid_o = left_q != '0;
  assign m_axi_wlast_o  = left_q == 3'd1;
  assign m_axi_wdata_o  = data_q[0];
  assign m_axi_wstrb_o  = strb_q[0];
  assign beat_o         = send;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) left_q <= '0;
    else if (take) left_q <= req.beats;
    else if (send) left_q <= left_q - 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      for (int unsigned i = 0; i < MaxBeats; i++) begin
        data_q[i] <= req.data[DataW*i +: DataW];
        strb_q[i] <= req.strb[StrbW*i +: StrbW];
      end
    end else if (send) begin
      for (int unsigned i = 0; i + 1 < MaxBeats; i++) begin
        data_q[i] <= data_q[i+1];
        strb_q[i] <= strb_q[i+1];
      end
    end
  end

  // ---- B: bursts taken and not yet answered ----
  logic [CntW-1:0] bursts_q;
  logic            error_q;
  logic            unused_bid;
  assign unused_bid     = ^m_axi_bid_i;
  assign m_axi_bready_o = 1'b1;
  assign room    = bursts_q != CntW'(MaxWrites) && !block_i;
  assign idle_o  = bursts_q == '0;
  assign error_o = error_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      bursts_q <= '0;
      error_q  <= 1'b0;
    end else begin
      if (take != m_axi_bvalid_i) bursts_q <= take ? bursts_q + 1'b1 : bursts_q - 1'b1;
      error_q <= m_axi_bvalid_i && m_axi_bresp_i[1];
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && take) begin
      assert (32'(req.beats) <= MaxBeats) else $error("client %0d writes %0d beats", client, req.beats);
      assert ((req.beats == 1 && req.addr[3:0] == '0) || (req.beats == 2 && req.addr[4:0] == '0) ||
              (req.beats == 4 && req.addr[5:0] == '0))
      else $error("client %0d writes %0d beats at %h", client, req.beats, req.addr);
    end
  end
`endif
endmodule
