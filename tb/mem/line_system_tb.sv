// SPDX-License-Identifier: Apache-2.0
// Caches, the memory behind them and two readers, wired as in the core: three caches of which the
// last is small, two ports, the second cache, and on each port another client that reads bursts.
module line_system_tb
  import castray_pkg::*;
#(
  parameter int unsigned Caches = 3
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  addr_t             base_i,

  output logic [Caches-1:0] hit_o,
  output logic [Caches-1:0] miss_o,
  output logic [1:0]        l2_hit_o,
  output logic [1:0]        l2_miss_o,

  input  logic [Caches-1:0] in_valid_i,
  output logic [Caches-1:0] in_ready_o,
  input  ctx_t              in_id_i    [Caches],
  input  line_no_t          in_line_i  [Caches],
  output logic [Caches-1:0] out_valid_o,
  input  logic [Caches-1:0] out_ready_i,
  output ctx_t              out_id_o   [Caches],
  output line_data_t        out_data_o [Caches],

  input  logic [1:0]        other_valid_i,
  output logic [1:0]        other_ready_o,
  input  read_req_t         other_i,
  output logic [1:0]        other_rsp_o,

  output logic [1:0]        idle_o,
  output logic [1:0]        error_o,
  output logic [1:0]        beat_o,
  output logic [1:0]        m_axi_arvalid_o,
  input  logic [1:0]        m_axi_arready_i,
  output addr_t             m_axi_araddr_o  [2],
  output logic [3:0]        m_axi_arid_o    [2],
  output logic [7:0]        m_axi_arlen_o   [2],
  output logic [2:0]        m_axi_arsize_o  [2],
  output logic [1:0]        m_axi_arburst_o [2],
  output logic [3:0]        m_axi_arcache_o [2],
  output logic [2:0]        m_axi_arprot_o  [2],
  input  logic [1:0]        m_axi_rvalid_i,
  output logic [1:0]        m_axi_rready_o,
  input  beat_t             m_axi_rdata_i   [2],
  input  logic [3:0]        m_axi_rid_i     [2],
  input  logic [1:0]        m_axi_rresp_i   [2],
  input  logic [1:0]        m_axi_rlast_i
);
  localparam int unsigned Lines [Caches] = '{512, 512, 64};

  logic [Caches-1:0] req_valid, req_ready, fill_valid, fill_ready;
  line_req_t         req [Caches];
  line_fill_t        fill;
  for (genvar i = 0; i < Caches; i++) begin : g_cache
    line_cache #(.Lines(Lines[i])) u_cache (
      .clk_i, .rst_ni, .hit_o(hit_o[i]), .miss_o(miss_o[i]),
      .in_valid_i(in_valid_i[i]), .in_ready_o(in_ready_o[i]), .in_id_i(in_id_i[i]), .in_line_i(in_line_i[i]),
      .keep_i(1'b0), .keep_index_i('0),
      .kept_valid_i(1'b0), .kept_ready_o(), .kept_id_i('0), .kept_index_i('0),
      .out_valid_o(out_valid_o[i]), .out_ready_i(out_ready_i[i]), .out_id_o(out_id_o[i]), .out_kept_o(),
      .out_data_o(out_data_o[i]),
      .req_valid_o(req_valid[i]), .req_ready_i(req_ready[i]), .req_o(req[i]),
      .data_valid_i(fill_valid[i]), .data_miss_i(fill.miss), .data_part_i('0), .data_i(fill.data),
      .fill_valid_i(fill_valid[i]), .fill_ready_o(fill_ready[i]), .fill_miss_i(fill.miss)
    );
  end

  logic [1:0] read_valid, read_ready, rsp_valid;
  read_req_t  read [2];
  read_rsp_t  rsp [2];
  line_memory #(.Clients(Caches), .Ports(2)) u_memory (
    .clk_i, .rst_ni, .base_i, .hit_o(l2_hit_o), .miss_o(l2_miss_o),
    .req_valid_i(req_valid), .req_ready_o(req_ready), .req_i(req),
    .fill_valid_o(fill_valid), .fill_ready_i(fill_ready), .fill_o(fill),
    .read_valid_o(read_valid), .read_ready_i(read_ready), .read_o(read),
    .rsp_valid_i(rsp_valid), .rsp_i(rsp)
  );

  for (genvar p = 0; p < 2; p++) begin : g_port
    read_req_t requests [2];
    assign requests = '{read[p], other_i};
    axi_reader #(.Clients(2), .MaxReads(32)) u_reader (
      .clk_i, .rst_ni,
      .req_valid_i({other_valid_i[p], read_valid[p]}), .req_ready_o({other_ready_o[p], read_ready[p]}),
      .req_i(requests), .rsp_valid_o({other_rsp_o[p], rsp_valid[p]}), .rsp_o(rsp[p]),
      .block_i(1'b0), .idle_o(idle_o[p]), .error_o(error_o[p]), .beat_o(beat_o[p]),
      .m_axi_arvalid_o(m_axi_arvalid_o[p]), .m_axi_arready_i(m_axi_arready_i[p]),
      .m_axi_araddr_o(m_axi_araddr_o[p]), .m_axi_arid_o(m_axi_arid_o[p]), .m_axi_arlen_o(m_axi_arlen_o[p]),
      .m_axi_arsize_o(m_axi_arsize_o[p]), .m_axi_arburst_o(m_axi_arburst_o[p]),
      .m_axi_arcache_o(m_axi_arcache_o[p]), .m_axi_arprot_o(m_axi_arprot_o[p]),
      .m_axi_rvalid_i(m_axi_rvalid_i[p]), .m_axi_rready_o(m_axi_rready_o[p]),
      .m_axi_rdata_i(m_axi_rdata_i[p]), .m_axi_rid_i(m_axi_rid_i[p]), .m_axi_rresp_i(m_axi_rresp_i[p]),
      .m_axi_rlast_i(m_axi_rlast_i[p])
    );
  end
endmodule
