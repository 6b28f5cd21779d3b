// SPDX-License-Identifier: Apache-2.0
// axi/axi_reader: its clients ask for legal bursts, and hold on while it is not blocked. Then each burst on AR is one of theirs, unchanged and in the
// order in which they were taken, with its client's number; no more than MaxReads are outstanding; each beat goes
// to the client of its ID, once.
// Prove: k=1 Clients=1 MaxReads=1
// Prove: k=1 Clients=3 MaxReads=4
// Prove: k=1 Clients=5 MaxReads=48
// Cover: 40
module axi_reader_proof
  import castray_pkg::*;
#(
  parameter int unsigned Clients  = 3,
  parameter int unsigned MaxReads = 4
) (
  input logic                                 clk_i,
  input logic                                 rst_ni,
  input logic                                 choose_i,
  input logic [Clients-1:0]                   req_valid_i,
  input logic [Clients-1:0][$bits(read_req_t)-1:0] reqs_i,
  input logic                                 block_i,
  input logic                                 m_axi_arready_i,
  input logic                                 m_axi_rvalid_i,
  input beat_t                                m_axi_rdata_i,
  input logic [3:0]                           m_axi_rid_i,
  input logic [1:0]                           m_axi_rresp_i,
  input logic                                 m_axi_rlast_i
);
  localparam int unsigned CntW = $clog2(MaxReads + 4) + 1;
  logic [Clients-1:0] req_ready_o, rsp_valid_o;
  read_req_t          req_i [Clients];
  read_rsp_t          rsp_o;
  logic               idle_o, error_o, beat_o, m_axi_arvalid_o, m_axi_rready_o;
  addr_t              m_axi_araddr_o;
  logic [3:0]         m_axi_arid_o, m_axi_arcache_o;
  logic [7:0]         m_axi_arlen_o;
  logic [2:0]         m_axi_arsize_o, m_axi_arprot_o;
  logic [1:0]         m_axi_arburst_o;
  axi_reader #(.Clients(Clients), .MaxReads(MaxReads)) u_dut (.*);
  reset_first u_reset (.*);

  function automatic logic legal(addr_t addr, logic [8:0] beats);
    return beats >= 9'd1 && beats <= 9'd16 && addr[3:0] == '0 && 9'(addr[11:4]) + beats <= 9'd256;
  endfunction

  // ---- The clients; what is taken ----
  typedef struct packed {
    logic [3:0] id;
    addr_t      addr;
    logic [7:0] len;
  } burst_t;
  logic [Clients-1:0] taken;
  logic               asked_legally;
  burst_t             in, out;
  assign taken = req_valid_i & req_ready_o;
  for (genvar i = 0; i < Clients; i++) begin : g_client
    assign req_i[i] = reqs_i[i];
    stream_held #(.data_t(read_req_t), .Assumed(1'b1)) u_held (
      .clk_i, .rst_ni(rst_ni && !block_i), .valid_i(req_valid_i[i]), .ready_i(req_ready_o[i]), .data_i(reqs_i[i])
    );
  end
  always_comb begin
    asked_legally = 1'b1;
    in            = '0;
    for (int unsigned i = 0; i < Clients; i++) begin
      if (req_valid_i[i] && !legal(req_i[i].addr, 9'(req_i[i].beats))) asked_legally = 1'b0;
      if (taken[i]) in = '{id: 4'(i), addr: req_i[i].addr, len: 8'(req_i[i].beats) - 8'd1};
    end
  end

  // ---- AR ----
  logic [1:0] waiting, ahead;
  logic       follows, ar;
  burst_t     burst;
  assign out = '{id: m_axi_arid_o, addr: m_axi_araddr_o, len: m_axi_arlen_o};
  assign ar  = m_axi_arvalid_o && m_axi_arready_i;
  stream_held #(.data_t(burst_t)) u_ar (
    .clk_i, .rst_ni, .valid_i(m_axi_arvalid_o), .ready_i(m_axi_arready_i), .data_i(out)
  );
  stream_follow #(.data_t(burst_t), .Most(2)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(taken != '0), .in_i(in),
    .out_valid_i(m_axi_arvalid_o), .out_ready_i(m_axi_arready_i), .out_i(out),
    .inside_o(waiting), .follows_o(follows), .ahead_o(ahead), .item_o(burst)
  );

  // ---- Bursts and beats outstanding; a burst all alone, for the covers ----
  logic [CntW-1:0] bursts_q;
  logic            alone_q, came_q, last_q;
  logic [7:0]      len_q, beats_q;
  logic [3:0]      id_q;
  logic [1:0]      resp_q;
  beat_t           data_q;
  logic            r;
  assign r = m_axi_rvalid_i && m_axi_rready_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      bursts_q <= '0;
      came_q   <= 1'b0;
      alone_q  <= 1'b0;
    end else begin
      bursts_q <= bursts_q + CntW'(ar) - CntW'(r && m_axi_rlast_i);
      came_q   <= r;
      if (ar) alone_q <= bursts_q == '0;
    end
  end
  always_ff @(posedge clk_i) begin
    {last_q, id_q, resp_q, data_q} <= {m_axi_rlast_i, m_axi_rid_i, m_axi_rresp_i, m_axi_rdata_i};
    if (ar) len_q <= m_axi_arlen_o;
    beats_q <= ar ? '0 : beats_q + 8'(r);
  end

  always_comb begin
    if (rst_ni) begin
      clients_ask_legally: assume (asked_legally);
      if (m_axi_rvalid_i) memory_answers_what_was_asked: assume (bursts_q != '0);

      if (m_axi_arvalid_o) begin
        at_most_16_beats: assert (m_axi_arlen_o <= 8'd15);
        inside_4_kib: assert (13'(m_axi_araddr_o[11:0]) + 13'(16 * (9'(m_axi_arlen_o) + 9'd1)) <= 13'd4096);
        as_the_port_wants_it: assert (m_axi_arsize_o == 3'd4 && m_axi_arburst_o == 2'b01 && m_axi_arcache_o == 4'b0011);
      end
      one_at_a_time: assert ((taken & (taken - 1'b1)) == '0);
      if (block_i) nothing_taken_while_blocked: assert (taken == '0);
      nothing_lost: assert (m_axi_arvalid_o == (waiting != '0));
      never_more_outstanding: assert (bursts_q <= CntW'(MaxReads) && CntW'(waiting) + bursts_q <= CntW'(MaxReads));
      if (idle_o) idle_when_none: assert (bursts_q == '0 && waiting == '0);
      each_beat_to_its_client: assert (rsp_valid_o == ((came_q && 32'(id_q) < Clients) ? Clients'(1) << id_q : '0));
      if (came_q) beat_unchanged: assert (rsp_o == {last_q, data_q} && error_o == resp_q[1] && beat_o);
      else no_beat_invented: assert (!beat_o && !error_o);
      always_taken: assert (m_axi_rready_o);

      inv_cut: assert (u_dut.u_ar.main_valid_q == (waiting != '0) && u_dut.u_ar.spare_valid_q == (waiting == 2'd2));
      inv_bursts: assert (CntW'(u_dut.bursts_q) == CntW'(waiting) + bursts_q + CntW'(came_q && last_q) &&
                          32'(u_dut.bursts_q) <= MaxReads);
      inv_beat: assert (u_dut.beat_q == came_q && (!came_q || u_dut.last_q == last_q));
      if (waiting != '0) inv_main: assert (legal(u_dut.u_ar.main_q.req.addr, 9'(u_dut.u_ar.main_q.req.beats)));
      if (waiting == 2'd2) inv_spare: assert (legal(u_dut.u_ar.spare_q.req.addr, 9'(u_dut.u_ar.spare_q.req.beats)));
      if (follows && ahead == 2'd1)
        inv_item: assert (u_dut.u_ar.spare_q.id == burst.id && u_dut.u_ar.spare_q.req.addr == burst.addr &&
                          8'(u_dut.u_ar.spare_q.req.beats) - 8'd1 == burst.len);

      c_full_burst: cover (alone_q && bursts_q == CntW'(1) && !ar && len_q == 8'd15 && beats_q == 8'd15 && r && m_axi_rlast_i);
      if (MaxReads <= 4) c_full: cover (bursts_q == CntW'(MaxReads) && req_valid_i == '1);
    end
  end
endmodule
