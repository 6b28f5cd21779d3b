// SPDX-License-Identifier: Apache-2.0
// axi/axi_writer: its clients ask for legal bursts, and hold on while it is not blocked. Then each burst on AW is one of theirs, unchanged and in the
// order in which they were taken, with its client's number; W carries their beats in the same order, the last of
// each marked; no more than MaxWrites are outstanding.
// Prove: k=1 Clients=1 MaxWrites=1
// Prove: k=1 Clients=2 MaxWrites=4
// Prove: k=1 Clients=2 MaxWrites=48
// Cover: 40
module axi_writer_proof
  import castray_pkg::*;
#(
  parameter int unsigned Clients   = 2,
  parameter int unsigned MaxWrites = 4
) (
  input logic               clk_i,
  input logic               rst_ni,
  input logic               choose_i,
  input logic [1:0]         beat_i,      // which of its beats
  input logic [Clients-1:0] req_valid_i,
  input logic [Clients-1:0][$bits(write_req_t)-1:0] reqs_i,
  input logic               block_i,
  input logic               m_axi_awready_i,
  input logic               m_axi_wready_i,
  input logic               m_axi_bvalid_i,
  input logic [3:0]         m_axi_bid_i,
  input logic [1:0]         m_axi_bresp_i
);
  localparam int unsigned CntW = $clog2(MaxWrites + 4) + 1;
  logic [Clients-1:0] req_ready_o;
  write_req_t         req_i [Clients];
  logic               idle_o, error_o, beat_o, m_axi_awvalid_o, m_axi_wvalid_o, m_axi_wlast_o, m_axi_bready_o;
  addr_t              m_axi_awaddr_o;
  logic [3:0]         m_axi_awid_o, m_axi_awcache_o;
  logic [7:0]         m_axi_awlen_o;
  logic [2:0]         m_axi_awsize_o, m_axi_awprot_o;
  logic [1:0]         m_axi_awburst_o;
  beat_t              m_axi_wdata_o;
  logic [StrbW-1:0]   m_axi_wstrb_o;
  axi_writer #(.Clients(Clients), .MaxWrites(MaxWrites)) u_dut (.*);
  reset_first u_reset (.*);

  function automatic logic legal(addr_t addr, logic [2:0] beats);
    return (beats == 3'd1 && addr[3:0] == '0) || (beats == 3'd2 && addr[4:0] == '0) || (beats == 3'd4 && addr[5:0] == '0);
  endfunction

  // ---- The clients; what is taken ----
  typedef struct packed {
    logic [3:0] id;
    addr_t      addr;
    logic [7:0] len;
  } burst_t;
  logic [Clients-1:0] taken;
  logic               asked_legally, take;
  burst_t             in, out;
  write_req_t         req;
  assign taken = req_valid_i & req_ready_o;
  assign take  = taken != '0;
  for (genvar i = 0; i < Clients; i++) begin : g_client
    assign req_i[i] = reqs_i[i];
    stream_held #(.data_t(write_req_t), .Assumed(1'b1)) u_held (
      .clk_i, .rst_ni(rst_ni && !block_i), .valid_i(req_valid_i[i]), .ready_i(req_ready_o[i]), .data_i(reqs_i[i])
    );
  end
  always_comb begin
    asked_legally = 1'b1;
    in            = '0;
    req           = '0;
    for (int unsigned i = 0; i < Clients; i++) begin
      if (req_valid_i[i] && !legal(req_i[i].addr, req_i[i].beats)) asked_legally = 1'b0;
      if (taken[i]) in = '{id: 4'(i), addr: req_i[i].addr, len: 8'(req_i[i].beats) - 8'd1};
      if (taken[i]) req = req_i[i];
    end
  end

  // ---- AW ----
  logic [1:0] waiting, ahead;
  logic       follows, aw;
  burst_t     burst;
  assign out = '{id: m_axi_awid_o, addr: m_axi_awaddr_o, len: m_axi_awlen_o};
  assign aw  = m_axi_awvalid_o && m_axi_awready_i;
  stream_held #(.data_t(burst_t)) u_aw (
    .clk_i, .rst_ni, .valid_i(m_axi_awvalid_o), .ready_i(m_axi_awready_i), .data_i(out)
  );
  stream_follow #(.data_t(burst_t), .Most(2)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(take), .in_i(in),
    .out_valid_i(m_axi_awvalid_o), .out_ready_i(m_axi_awready_i), .out_i(out),
    .inside_o(waiting), .follows_o(follows), .ahead_o(ahead), .item_o(burst)
  );

  // ---- W: how many beats of the burst taken last are to come; any one beat of it ----
  typedef struct packed {
    logic             last;
    logic [StrbW-1:0] strb;
    beat_t            data;
  } w_t;
  logic [2:0] left_q;
  logic       w, take_beat, follows_w_q, four_q;
  logic [1:0] before_q;    // beats that come before the followed one
  w_t         w_out, beat_q, held;
  assign w     = m_axi_wvalid_o && m_axi_wready_i;
  assign w_out = '{last: m_axi_wlast_o, strb: m_axi_wstrb_o, data: m_axi_wdata_o};
  stream_held #(.data_t(w_t)) u_w (
    .clk_i, .rst_ni, .valid_i(m_axi_wvalid_o), .ready_i(m_axi_wready_i), .data_i(w_out)
  );
  assign take_beat = take && choose_i && 3'(beat_i) < req.beats;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q      <= '0;
      follows_w_q <= 1'b0;
    end else begin
      left_q      <= take ? req.beats : left_q - 3'(w);
      follows_w_q <= take_beat || (follows_w_q && !(w && before_q == '0));
    end
    if (take) four_q <= req.beats == 3'd4;
    if (take_beat) begin
      before_q <= beat_i;
      beat_q   <= '{last: 3'(beat_i) + 3'd1 == req.beats, strb: req.strb[StrbW*beat_i +: StrbW], data: req.data[DataW*beat_i +: DataW]};
    end else if (w) before_q <= before_q - 1'b1;
  end
  assign held = '{last: 3'(before_q) + 3'd1 == left_q, strb: u_dut.strb_q[before_q], data: u_dut.data_q[before_q]};

  // ---- Bursts whose address has left, or whose last beat, and that were not answered ----
  logic [CntW-1:0] addrs_q, datas_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      addrs_q <= '0;
      datas_q <= '0;
    end else begin
      addrs_q <= addrs_q + CntW'(aw) - CntW'(m_axi_bvalid_i && m_axi_bready_o);
      datas_q <= datas_q + CntW'(w && m_axi_wlast_o) - CntW'(m_axi_bvalid_i && m_axi_bready_o);
    end
  end

  always_comb begin
    if (rst_ni) begin
      clients_ask_legally: assume (asked_legally);
      if (m_axi_bvalid_i) memory_answers_whole_bursts: assume (addrs_q != '0 && datas_q != '0);

      if (m_axi_awvalid_o) begin
        at_most_16_beats: assert (m_axi_awlen_o <= 8'd15);
        inside_4_kib: assert (13'(m_axi_awaddr_o[11:0]) + 13'(16 * (9'(m_axi_awlen_o) + 9'd1)) <= 13'd4096);
        as_the_port_wants_it: assert (m_axi_awsize_o == 3'd4 && m_axi_awburst_o == 2'b01 && m_axi_awcache_o == 4'b0011);
      end
      one_at_a_time: assert ((taken & (taken - 1'b1)) == '0);
      if (block_i) nothing_taken_while_blocked: assert (!take);
      nothing_lost: assert (m_axi_awvalid_o == (waiting != '0) && m_axi_wvalid_o == (left_q != '0));
      if (take) one_burst_after_another: assert (left_q == '0 || (left_q == 3'd1 && w));
      if (m_axi_wvalid_o) as_many_beats_as_said: assert (m_axi_wlast_o == (left_q == 3'd1));
      if (m_axi_wvalid_o && follows_w_q && before_q == '0) beats_unchanged_in_order: assert (w_out == beat_q);
      never_more_outstanding: assert (addrs_q <= CntW'(MaxWrites) && CntW'(waiting) + addrs_q <= CntW'(MaxWrites) &&
                                      datas_q <= CntW'(MaxWrites));
      if (idle_o) idle_when_none: assert (addrs_q == '0 && waiting == '0 && datas_q == '0 && left_q == '0);
      always_taken: assert (m_axi_bready_o);

      inv_cut: assert (u_dut.u_aw.main_valid_q == (waiting != '0) && u_dut.u_aw.spare_valid_q == (waiting == 2'd2));
      inv_bursts: assert (CntW'(u_dut.bursts_q) == CntW'(waiting) + addrs_q && 32'(u_dut.bursts_q) <= MaxWrites &&
                          CntW'(u_dut.bursts_q) == CntW'(left_q != '0) + datas_q);
      inv_left: assert (u_dut.left_q == left_q && left_q <= 3'd4);
      if (follows_w_q) inv_beat: assert (3'(before_q) < left_q && held == beat_q);
      if (waiting != '0) inv_main: assert (legal(u_dut.u_aw.main_q.addr, u_dut.u_aw.main_q.beats));
      if (waiting == 2'd2) inv_spare: assert (legal(u_dut.u_aw.spare_q.addr, u_dut.u_aw.spare_q.beats));
      if (follows && ahead == 2'd1)
        inv_item: assert (u_dut.u_aw.spare_q.id == burst.id && u_dut.u_aw.spare_q.addr == burst.addr &&
                          8'(u_dut.u_aw.spare_q.beats) - 8'd1 == burst.len);

      c_full_burst: cover (w && m_axi_wlast_o && follows_w_q && four_q);
      if (MaxWrites <= 4) c_full: cover (addrs_q == CntW'(MaxWrites) && datas_q == CntW'(MaxWrites) && req_valid_i == '1);
    end
  end
endmodule
