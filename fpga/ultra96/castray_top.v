// SPDX-License-Identifier: Apache-2.0
// The core with flat ports, in plain Verilog: what Vivado's packager, a block design or a design in another language instantiates.
// Names and widths are those of AXI, so that the interfaces s_axi, m_axi_0 and m_axi_1 are inferred. Wires only: what the ports
// mean, and the parameters, stand in rtl/castray_core.sv and docs/integrate.md.
//
// With Ports = 1 the second memory port asks for nothing and its inputs are not looked at. The defaults are those of
// castray_cfg_pkg, which Verilog cannot read: a test compares them.
module castray_top #(
  parameter Lanes       = 3,
  parameter Contexts    = 32,
  parameter TileLog2    = 3,
  parameter AttrEntries = 128,
  parameter Ports       = 2,
  parameter L2Kbytes    = 128
) (
  (* X_INTERFACE_INFO = "xilinx.com:signal:clock:1.0 aclk CLK" *)
  (* X_INTERFACE_PARAMETER = "XIL_INTERFACENAME aclk, ASSOCIATED_BUSIF s_axi:m_axi_0:m_axi_1, ASSOCIATED_RESET aresetn" *)
  input  wire         aclk,
  (* X_INTERFACE_INFO = "xilinx.com:signal:reset:1.0 aresetn RST" *)
  (* X_INTERFACE_PARAMETER = "XIL_INTERFACENAME aresetn, POLARITY ACTIVE_LOW" *)
  input  wire         aresetn,
  (* X_INTERFACE_INFO = "xilinx.com:signal:interrupt:1.0 interrupt INTERRUPT" *)
  (* X_INTERFACE_PARAMETER = "XIL_INTERFACENAME interrupt, SENSITIVITY LEVEL_HIGH" *)
  output wire         interrupt,

  input  wire         s_axi_awvalid,
  output wire         s_axi_awready,
  input  wire [8:0]   s_axi_awaddr,
  input  wire         s_axi_wvalid,
  output wire         s_axi_wready,
  input  wire [31:0]  s_axi_wdata,
  input  wire [3:0]   s_axi_wstrb,
  output wire         s_axi_bvalid,
  input  wire         s_axi_bready,
  output wire [1:0]   s_axi_bresp,
  input  wire         s_axi_arvalid,
  output wire         s_axi_arready,
  input  wire [8:0]   s_axi_araddr,
  output wire         s_axi_rvalid,
  input  wire         s_axi_rready,
  output wire [31:0]  s_axi_rdata,
  output wire [1:0]   s_axi_rresp,

  output wire         m_axi_0_arvalid,
  input  wire         m_axi_0_arready,
  output wire [39:0]  m_axi_0_araddr,
  output wire [3:0]   m_axi_0_arid,
  output wire [7:0]   m_axi_0_arlen,
  output wire [2:0]   m_axi_0_arsize,
  output wire [1:0]   m_axi_0_arburst,
  output wire [3:0]   m_axi_0_arcache,
  output wire [2:0]   m_axi_0_arprot,
  input  wire         m_axi_0_rvalid,
  output wire         m_axi_0_rready,
  input  wire [127:0] m_axi_0_rdata,
  input  wire [3:0]   m_axi_0_rid,
  input  wire [1:0]   m_axi_0_rresp,
  input  wire         m_axi_0_rlast,
  output wire         m_axi_0_awvalid,
  input  wire         m_axi_0_awready,
  output wire [39:0]  m_axi_0_awaddr,
  output wire [3:0]   m_axi_0_awid,
  output wire [7:0]   m_axi_0_awlen,
  output wire [2:0]   m_axi_0_awsize,
  output wire [1:0]   m_axi_0_awburst,
  output wire [3:0]   m_axi_0_awcache,
  output wire [2:0]   m_axi_0_awprot,
  output wire         m_axi_0_wvalid,
  input  wire         m_axi_0_wready,
  output wire [127:0] m_axi_0_wdata,
  output wire [15:0]  m_axi_0_wstrb,
  output wire         m_axi_0_wlast,
  input  wire         m_axi_0_bvalid,
  output wire         m_axi_0_bready,
  input  wire [3:0]   m_axi_0_bid,
  input  wire [1:0]   m_axi_0_bresp,

  output wire         m_axi_1_arvalid,
  input  wire         m_axi_1_arready,
  output wire [39:0]  m_axi_1_araddr,
  output wire [3:0]   m_axi_1_arid,
  output wire [7:0]   m_axi_1_arlen,
  output wire [2:0]   m_axi_1_arsize,
  output wire [1:0]   m_axi_1_arburst,
  output wire [3:0]   m_axi_1_arcache,
  output wire [2:0]   m_axi_1_arprot,
  input  wire         m_axi_1_rvalid,
  output wire         m_axi_1_rready,
  input  wire [127:0] m_axi_1_rdata,
  input  wire [3:0]   m_axi_1_rid,
  input  wire [1:0]   m_axi_1_rresp,
  input  wire         m_axi_1_rlast,
  output wire         m_axi_1_awvalid,
  input  wire         m_axi_1_awready,
  output wire [39:0]  m_axi_1_awaddr,
  output wire [3:0]   m_axi_1_awid,
  output wire [7:0]   m_axi_1_awlen,
  output wire [2:0]   m_axi_1_awsize,
  output wire [1:0]   m_axi_1_awburst,
  output wire [3:0]   m_axi_1_awcache,
  output wire [2:0]   m_axi_1_awprot,
  output wire         m_axi_1_wvalid,
  input  wire         m_axi_1_wready,
  output wire [127:0] m_axi_1_wdata,
  output wire [15:0]  m_axi_1_wstrb,
  output wire         m_axi_1_wlast,
  input  wire         m_axi_1_bvalid,
  output wire         m_axi_1_bready,
  input  wire [3:0]   m_axi_1_bid,
  input  wire [1:0]   m_axi_1_bresp
);
  // Of each signal the core has one vector for its ports, port 0's part the lowest.
  wire [Ports-1:0] arvalid;
  assign m_axi_0_arvalid = arvalid[0];
  assign m_axi_1_arvalid = (Ports == 2) && arvalid[Ports-1];
  wire [1:0] arready = {m_axi_1_arready, m_axi_0_arready};
  wire [40*Ports-1:0] araddr;
  assign m_axi_0_araddr = araddr[39:0];
  assign m_axi_1_araddr = araddr[40*Ports-1 -: 40];
  wire [4*Ports-1:0] arid;
  assign m_axi_0_arid = arid[3:0];
  assign m_axi_1_arid = arid[4*Ports-1 -: 4];
  wire [8*Ports-1:0] arlen;
  assign m_axi_0_arlen = arlen[7:0];
  assign m_axi_1_arlen = arlen[8*Ports-1 -: 8];
  wire [3*Ports-1:0] arsize;
  assign m_axi_0_arsize = arsize[2:0];
  assign m_axi_1_arsize = arsize[3*Ports-1 -: 3];
  wire [2*Ports-1:0] arburst;
  assign m_axi_0_arburst = arburst[1:0];
  assign m_axi_1_arburst = arburst[2*Ports-1 -: 2];
  wire [4*Ports-1:0] arcache;
  assign m_axi_0_arcache = arcache[3:0];
  assign m_axi_1_arcache = arcache[4*Ports-1 -: 4];
  wire [3*Ports-1:0] arprot;
  assign m_axi_0_arprot = arprot[2:0];
  assign m_axi_1_arprot = arprot[3*Ports-1 -: 3];
  wire [1:0] rvalid = {m_axi_1_rvalid, m_axi_0_rvalid};
  wire [Ports-1:0] rready;
  assign m_axi_0_rready = rready[0];
  assign m_axi_1_rready = (Ports == 2) && rready[Ports-1];
  wire [255:0] rdata = {m_axi_1_rdata, m_axi_0_rdata};
  wire [7:0] rid = {m_axi_1_rid, m_axi_0_rid};
  wire [3:0] rresp = {m_axi_1_rresp, m_axi_0_rresp};
  wire [1:0] rlast = {m_axi_1_rlast, m_axi_0_rlast};
  wire [Ports-1:0] awvalid;
  assign m_axi_0_awvalid = awvalid[0];
  assign m_axi_1_awvalid = (Ports == 2) && awvalid[Ports-1];
  wire [1:0] awready = {m_axi_1_awready, m_axi_0_awready};
  wire [40*Ports-1:0] awaddr;
  assign m_axi_0_awaddr = awaddr[39:0];
  assign m_axi_1_awaddr = awaddr[40*Ports-1 -: 40];
  wire [4*Ports-1:0] awid;
  assign m_axi_0_awid = awid[3:0];
  assign m_axi_1_awid = awid[4*Ports-1 -: 4];
  wire [8*Ports-1:0] awlen;
  assign m_axi_0_awlen = awlen[7:0];
  assign m_axi_1_awlen = awlen[8*Ports-1 -: 8];
  wire [3*Ports-1:0] awsize;
  assign m_axi_0_awsize = awsize[2:0];
  assign m_axi_1_awsize = awsize[3*Ports-1 -: 3];
  wire [2*Ports-1:0] awburst;
  assign m_axi_0_awburst = awburst[1:0];
  assign m_axi_1_awburst = awburst[2*Ports-1 -: 2];
  wire [4*Ports-1:0] awcache;
  assign m_axi_0_awcache = awcache[3:0];
  assign m_axi_1_awcache = awcache[4*Ports-1 -: 4];
  wire [3*Ports-1:0] awprot;
  assign m_axi_0_awprot = awprot[2:0];
  assign m_axi_1_awprot = awprot[3*Ports-1 -: 3];
  wire [Ports-1:0] wvalid;
  assign m_axi_0_wvalid = wvalid[0];
  assign m_axi_1_wvalid = (Ports == 2) && wvalid[Ports-1];
  wire [1:0] wready = {m_axi_1_wready, m_axi_0_wready};
  wire [128*Ports-1:0] wdata;
  assign m_axi_0_wdata = wdata[127:0];
  assign m_axi_1_wdata = wdata[128*Ports-1 -: 128];
  wire [16*Ports-1:0] wstrb;
  assign m_axi_0_wstrb = wstrb[15:0];
  assign m_axi_1_wstrb = wstrb[16*Ports-1 -: 16];
  wire [Ports-1:0] wlast;
  assign m_axi_0_wlast = wlast[0];
  assign m_axi_1_wlast = wlast[Ports-1];
  wire [1:0] bvalid = {m_axi_1_bvalid, m_axi_0_bvalid};
  wire [Ports-1:0] bready;
  assign m_axi_0_bready = bready[0];
  assign m_axi_1_bready = (Ports == 2) && bready[Ports-1];
  wire [7:0] bid = {m_axi_1_bid, m_axi_0_bid};
  wire [3:0] bresp = {m_axi_1_bresp, m_axi_0_bresp};

  castray_core #(
    .Lanes(Lanes), .Contexts(Contexts), .TileLog2(TileLog2), .AttrEntries(AttrEntries), .Ports(Ports), .L2Kbytes(L2Kbytes)
  ) u_core (
    .clk_i(aclk), .rst_ni(aresetn), .irq_o(interrupt),
    .s_axi_awvalid_i(s_axi_awvalid), .s_axi_awready_o(s_axi_awready), .s_axi_awaddr_i(s_axi_awaddr),
    .s_axi_wvalid_i(s_axi_wvalid), .s_axi_wready_o(s_axi_wready), .s_axi_wdata_i(s_axi_wdata),
    .s_axi_wstrb_i(s_axi_wstrb), .s_axi_bvalid_o(s_axi_bvalid), .s_axi_bready_i(s_axi_bready),
    .s_axi_bresp_o(s_axi_bresp), .s_axi_arvalid_i(s_axi_arvalid), .s_axi_arready_o(s_axi_arready),
    .s_axi_araddr_i(s_axi_araddr), .s_axi_rvalid_o(s_axi_rvalid), .s_axi_rready_i(s_axi_rready),
    .s_axi_rdata_o(s_axi_rdata), .s_axi_rresp_o(s_axi_rresp), .m_axi_arvalid_o(arvalid),
    .m_axi_arready_i(arready[Ports-1:0]), .m_axi_araddr_o(araddr), .m_axi_arid_o(arid), .m_axi_arlen_o(arlen),
    .m_axi_arsize_o(arsize), .m_axi_arburst_o(arburst), .m_axi_arcache_o(arcache), .m_axi_arprot_o(arprot),
    .m_axi_rvalid_i(rvalid[Ports-1:0]), .m_axi_rready_o(rready), .m_axi_rdata_i(rdata[128*Ports-1:0]),
    .m_axi_rid_i(rid[4*Ports-1:0]), .m_axi_rresp_i(rresp[2*Ports-1:0]), .m_axi_rlast_i(rlast[Ports-1:0]),
    .m_axi_awvalid_o(awvalid), .m_axi_awready_i(awready[Ports-1:0]), .m_axi_awaddr_o(awaddr), .m_axi_awid_o(awid),
    .m_axi_awlen_o(awlen), .m_axi_awsize_o(awsize), .m_axi_awburst_o(awburst), .m_axi_awcache_o(awcache),
    .m_axi_awprot_o(awprot), .m_axi_wvalid_o(wvalid), .m_axi_wready_i(wready[Ports-1:0]), .m_axi_wdata_o(wdata),
    .m_axi_wstrb_o(wstrb), .m_axi_wlast_o(wlast), .m_axi_bvalid_i(bvalid[Ports-1:0]), .m_axi_bready_o(bready),
    .m_axi_bid_i(bid[4*Ports-1:0]), .m_axi_bresp_i(bresp[2*Ports-1:0])
  );
endmodule
