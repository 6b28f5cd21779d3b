// SPDX-License-Identifier: Apache-2.0
// The read half of an AXI4 port: merges the bursts that Clients ask for, and gives each beat back
// to the client whose number its ID carries.
//   take    round robin, while fewer than MaxReads bursts are outstanding and block_i is low
//   AR      one burst a cycle, from a register; INCR, 16 bytes a beat, AxCACHE 0011
//   R       always taken: a client has room for every beat before it asks. Each beat is
//           registered once, then rsp_valid_o[ID] says whose it is; beats of different IDs may
//           come in any order and interleaved.
// A client's burst has 1 to 16 beats and stays inside a 4 KiB page.
// error_o: a beat came with an error (one cycle; the beat is delivered all the same).
// block_i: no burst is taken; those taken before are still sent. idle_o: nothing is outstanding.
// Latency: 1 cycle from a request to AR, 1 from R to the client.
module axi_reader
  import castray_pkg::*;
#(
  parameter int unsigned Clients  = ReadClients,
  parameter int unsigned MaxReads = 16
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic [Clients-1:0] req_valid_i,
  output logic [Clients-1:0] req_ready_o,
  input  read_req_t          req_i [Clients],

  output logic [Clients-1:0] rsp_valid_o,
  output read_rsp_t          rsp_o,

  input  logic               block_i,
  output logic               idle_o,
  output logic               error_o,
  output logic               beat_o,    // a beat came: for the counter

  output logic               m_axi_arvalid_o,
  input  logic               m_axi_arready_i,
  output addr_t              m_axi_araddr_o,
  output logic [3:0]         m_axi_arid_o,
  output logic [7:0]         m_axi_arlen_o,
  output logic [2:0]         m_axi_arsize_o,
  output logic [1:0]         m_axi_arburst_o,
  output logic [3:0]         m_axi_arcache_o,
  output logic [2:0]         m_axi_arprot_o,

  input  logic               m_axi_rvalid_i,
  output logic               m_axi_rready_o,
  input  beat_t              m_axi_rdata_i,
  input  logic [3:0]         m_axi_rid_i,
  input  logic [1:0]         m_axi_rresp_i,
  input  logic               m_axi_rlast_i
);
  if (Clients < 1 || Clients > 16) begin : g_clients
    $error("axi_reader: Clients must be 1 to 16, the IDs of the port");
  end
  if (MaxReads < 1 || MaxReads > 256) begin : g_reads
    $error("axi_reader: MaxReads must be 1 to 256");
  end

  localparam int unsigned IdxW = (Clients > 1) ? $clog2(Clients) : 1;
  localparam int unsigned CntW = $clog2(MaxReads + 1);

  // ---- Take: the choice between clients is forgotten while blocked, for they may be reset then ----
  logic            any_valid, room, cut_ready, take;
  logic [IdxW-1:0] client;
  read_req_t       req;
  stream_arb #(.data_t(read_req_t), .N(Clients)) u_arb (
    .clk_i, .rst_ni(rst_ni && !block_i),
    .valid_i(req_valid_i), .ready_o(req_ready_o), .data_i(req_i),
    .valid_o(any_valid), .ready_i(cut_ready && room), .data_o(req), .index_o(client)
  );
  assign take = any_valid && cut_ready && room;

  // ---- AR ----
  typedef struct packed {
    logic [3:0] id;
    read_req_t  req;
  } ar_t;
  ar_t ar;
  pipe_cut #(.data_t(ar_t)) u_ar (
    .clk_i, .rst_ni,
    .valid_i(any_valid && room), .ready_o(cut_ready), .data_i('{id: 4'(client), req: req}),
    .valid_o(m_axi_arvalid_o), .ready_i(m_axi_arready_i), .data_o(ar)
  );
  assign m_axi_araddr_o  = ar.req.addr;
  assign m_axi_arid_o    = ar.id;
  assign m_axi_arlen_o   = 8'(ar.req.beats) - 8'd1;
  assign m_axi_arsize_o  = 3'($clog2(StrbW));
  assign m_axi_arburst_o = 2'b01;
  assign m_axi_arcache_o = 4'b0011;
  assign m_axi_arprot_o  = 3'b000;

  // ---- R ----
  logic [Clients-1:0] rsp_valid_q;
  logic               beat_q, last_q, error_q;
  beat_t              data_q;
  assign m_axi_rready_o = 1'b1;
  assign rsp_valid_o    = rsp_valid_q;
  assign rsp_o          = '{last: last_q, data: data_q};
  assign beat_o         = beat_q;
  assign error_o        = error_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rsp_valid_q <= '0;
      beat_q      <= 1'b0;
      error_q     <= 1'b0;
    end else begin
      for (int unsigned i = 0; i < Clients; i++)
        rsp_valid_q[i] <= m_axi_rvalid_i && m_axi_rid_i == 4'(i);
      beat_q  <= m_axi_rvalid_i;
      error_q <= m_axi_rvalid_i && m_axi_rresp_i[1];
    end
  end
  always_ff @(posedge clk_i) begin
    if (m_axi_rvalid_i) begin
      last_q <= m_axi_rlast_i;
      data_q <= m_axi_rdata_i;
    end
  end

  // ---- Bursts taken and not yet answered ----
  logic [CntW-1:0] bursts_q;
  logic            finish;
  assign room   = bursts_q != CntW'(MaxReads) && !block_i;
  assign finish = beat_q && last_q;
  assign idle_o = bursts_q == '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) bursts_q <= '0;
    else if (take != finish) bursts_q <= take ? bursts_q + 1'b1 : bursts_q - 1'b1;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && take) begin
      assert (req.beats >= 1 && req.beats <= 16 && req.addr[3:0] == '0 &&
              9'(req.addr[11:4]) + 9'(req.beats) <= 9'd256)
      else $error("client %0d asks for %0d beats at %h", client, req.beats, req.addr);
    end
  end
`endif
endmodule
