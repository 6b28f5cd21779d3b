// SPDX-License-Identifier: Apache-2.0
// Someone else's design: a picture from power-up, with neither processor nor memory outside. A scene image lies in a memory on
// the chip; after reset the core is told where, renders it into the same memory, and done_o rises. It knows the core by its
// ports and by castray_reg_pkg alone.
module still
  import castray_reg_pkg::*;
#(
  parameter int unsigned Width   = 16,
  parameter int unsigned Height  = 12,
  parameter int unsigned Beats   = 2048,        // of 16 bytes: the memory
  parameter int unsigned FrameAt = 1024,        // the beat at which the frame buffer starts
  parameter              Image   = "image.hex"
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  output logic                     done_o,
  output logic [31:0]              error_o,

  input  logic [$clog2(Beats)-1:0] look_i,      // a look into the memory
  output logic [127:0]             look_o
);
  localparam int unsigned Stride = (4 * Width + 63) / 64 * 64;

  // ---- What is written into which register, in this order; all others are 0 after reset ----
  typedef struct packed {
    logic [RegAddrW-1:0] address;
    logic [31:0]         value;
  } write_t;
  localparam int unsigned NumWrites = 7;
  localparam write_t Writes [NumWrites] = '{
    '{RegAddrW'(RegImageBytes), 32'(16 * FrameAt)},
    '{RegAddrW'(RegFrame),      32'(16 * FrameAt)},
    '{RegAddrW'(RegFrameBytes), 32'(Stride * Height)},
    '{RegAddrW'(RegFrameSize),  32'(Width | Height << 16)},
    '{RegAddrW'(RegIer),        32'd1 << IsrDone},
    '{RegAddrW'(RegGie),        32'd1},
    '{RegAddrW'(RegControl),    32'd1 << CtrlStart}
  };

  typedef enum logic [1:0] {Tell, Render, Ask, Done} state_t;
  state_t      state_q;
  logic [2:0]  next_q;
  logic        asked_q, ready, over, interrupt;
  logic [31:0] got;

  assign done_o = state_q == Done;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= Tell;
      {next_q, asked_q} <= '0;
    end else begin
      if (ready && (state_q == Tell || state_q == Ask)) asked_q <= 1'b1;
      if (over) asked_q <= 1'b0;
      unique case (state_q)
        Tell: if (over) begin
          next_q <= next_q + 3'd1;
          if (next_q == 3'(NumWrites - 1)) state_q <= Render;
        end
        Render: if (interrupt) state_q <= Ask;
        Ask: if (over) begin
          error_o <= got;
          state_q <= Done;
        end
        default: ;
      endcase
    end
  end

  logic                awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready;
  logic [RegAddrW-1:0] awaddr, araddr;
  logic [31:0]         wdata, rdata;
  logic [3:0]          wstrb;

  lite_master #(.AddressBits(RegAddrW)) u_master (
    .clk_i, .rst_ni,
    .in_valid_i(!asked_q && (state_q == Tell || state_q == Ask)), .in_ready_o(ready), .write_i(state_q == Tell),
    .address_i(state_q == Tell ? Writes[next_q].address : RegAddrW'(RegError)), .data_i(Writes[next_q].value),
    .over_o(over), .data_o(got),
    .awvalid_o(awvalid), .awready_i(awready), .awaddr_o(awaddr), .wvalid_o(wvalid), .wready_i(wready), .wdata_o(wdata),
    .wstrb_o(wstrb), .bvalid_i(bvalid), .bready_o(bready), .arvalid_o(arvalid), .arready_i(arready), .araddr_o(araddr),
    .rvalid_i(rvalid), .rready_o(rready), .rdata_i(rdata)
  );

  logic         m_arvalid, m_arready, m_rvalid, m_rready, m_rlast, m_awvalid, m_awready, m_wvalid, m_wready, m_wlast, m_bvalid, m_bready;
  logic [39:0]  m_araddr, m_awaddr;
  logic [7:0]   m_arlen, m_awlen;
  logic [3:0]   m_arid, m_rid, m_awid, m_bid;
  logic [127:0] m_rdata, m_wdata;
  logic [15:0]  m_wstrb;

  chip_memory #(.Beats(Beats), .Image(Image)) u_memory (
    .clk_i, .rst_ni, .look_i, .look_o,
    .arvalid_i(m_arvalid), .arready_o(m_arready), .araddr_i(m_araddr), .arid_i(m_arid), .arlen_i(m_arlen),
    .rvalid_o(m_rvalid), .rready_i(m_rready), .rdata_o(m_rdata), .rid_o(m_rid), .rlast_o(m_rlast),
    .awvalid_i(m_awvalid), .awready_o(m_awready), .awaddr_i(m_awaddr), .awid_i(m_awid), .awlen_i(m_awlen),
    .wvalid_i(m_wvalid), .wready_o(m_wready), .wdata_i(m_wdata), .wstrb_i(m_wstrb), .wlast_i(m_wlast),
    .bvalid_o(m_bvalid), .bready_i(m_bready), .bid_o(m_bid)
  );

  // The instantiation of docs/integrate.md, with one memory port.
  castray_top #(.Lanes(1), .Contexts(4), .TileLog2(2), .Ports(1), .L2Kbytes(0)) u_castray (
    .aclk(clk_i), .aresetn(rst_ni), .interrupt,
    .s_axi_awvalid(awvalid), .s_axi_awready(awready), .s_axi_awaddr(awaddr),
    .s_axi_wvalid(wvalid), .s_axi_wready(wready), .s_axi_wdata(wdata), .s_axi_wstrb(wstrb),
    .s_axi_bvalid(bvalid), .s_axi_bready(bready), .s_axi_bresp(),
    .s_axi_arvalid(arvalid), .s_axi_arready(arready), .s_axi_araddr(araddr),
    .s_axi_rvalid(rvalid), .s_axi_rready(rready), .s_axi_rdata(rdata), .s_axi_rresp(),
    .m_axi_0_arvalid(m_arvalid), .m_axi_0_arready(m_arready), .m_axi_0_araddr(m_araddr), .m_axi_0_arid(m_arid),
    .m_axi_0_arlen(m_arlen), .m_axi_0_arsize(), .m_axi_0_arburst(), .m_axi_0_arcache(), .m_axi_0_arprot(),
    .m_axi_0_rvalid(m_rvalid), .m_axi_0_rready(m_rready), .m_axi_0_rdata(m_rdata), .m_axi_0_rid(m_rid), .m_axi_0_rresp('0),
    .m_axi_0_rlast(m_rlast),
    .m_axi_0_awvalid(m_awvalid), .m_axi_0_awready(m_awready), .m_axi_0_awaddr(m_awaddr), .m_axi_0_awid(m_awid),
    .m_axi_0_awlen(m_awlen), .m_axi_0_awsize(), .m_axi_0_awburst(), .m_axi_0_awcache(), .m_axi_0_awprot(),
    .m_axi_0_wvalid(m_wvalid), .m_axi_0_wready(m_wready), .m_axi_0_wdata(m_wdata), .m_axi_0_wstrb(m_wstrb), .m_axi_0_wlast(m_wlast),
    .m_axi_0_bvalid(m_bvalid), .m_axi_0_bready(m_bready), .m_axi_0_bid(m_bid), .m_axi_0_bresp('0),
    .m_axi_1_arvalid(), .m_axi_1_arready('0), .m_axi_1_araddr(), .m_axi_1_arid(), .m_axi_1_arlen(), .m_axi_1_arsize(),
    .m_axi_1_arburst(), .m_axi_1_arcache(), .m_axi_1_arprot(),
    .m_axi_1_rvalid('0), .m_axi_1_rready(), .m_axi_1_rdata('0), .m_axi_1_rid('0), .m_axi_1_rresp('0), .m_axi_1_rlast('0),
    .m_axi_1_awvalid(), .m_axi_1_awready('0), .m_axi_1_awaddr(), .m_axi_1_awid(), .m_axi_1_awlen(), .m_axi_1_awsize(),
    .m_axi_1_awburst(), .m_axi_1_awcache(), .m_axi_1_awprot(),
    .m_axi_1_wvalid(), .m_axi_1_wready('0), .m_axi_1_wdata(), .m_axi_1_wstrb(), .m_axi_1_wlast(),
    .m_axi_1_bvalid('0), .m_axi_1_bready(), .m_axi_1_bid('0), .m_axi_1_bresp('0)
  );
endmodule
