// SPDX-License-Identifier: Apache-2.0
// The registers of the core through its flat wrapper: who it is, and a job that it must refuse, up to the interrupt. What it
// renders is the business of tb/fpga/dependent and of tb/frame.
module bench
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
  import castray_reg_pkg::*;
#(
  parameter int unsigned Lanes    = 1,
  parameter int unsigned Contexts = 4,
  parameter int unsigned TileLog2 = 2
) (
  input  logic clk_i,
  input  logic rst_ni,
  output logic done_o,
  output logic failed_o
);
  typedef enum logic [1:0] {Read, Write, Wait} action_t;
  typedef struct packed {
    action_t             action;
    logic [RegAddrW-1:0] address;
    logic [31:0]         value;     // to be written, or expected
  } step_t;

  localparam logic [31:0] Ended     = (32'd1 << CtrlDone) | (32'd1 << CtrlIdle) | (32'd1 << CtrlReady) | (32'd1 << CtrlInterrupt);
  localparam int unsigned NumSteps  = 12;
  localparam step_t Steps [NumSteps] = '{
    '{Read, RegAddrW'(RegVersion), 32'(VersionMajor << 16 | VersionMinor << 8 | VersionPatch)},
    '{Read, RegAddrW'(RegConfig), 32'(Lanes | Contexts << 8 | (1 << TileLog2) << 16)},
    '{Read, RegAddrW'(RegParameters), 32'(ImageParameters)},
    '{Read, RegAddrW'(RegControl), 32'd1 << CtrlIdle},
    '{Write, RegAddrW'(RegIer), 32'd1 << IsrDone},
    '{Write, RegAddrW'(RegGie), 32'd1},
    '{Write, RegAddrW'(RegControl), 32'd1 << CtrlStart},
    '{Wait, RegAddrW'(0), 32'd0},
    '{Read, RegAddrW'(RegError), 32'(ErrRegister)},
    '{Read, RegAddrW'(RegControl), Ended},
    '{Write, RegAddrW'(RegIsr), 32'd1 << IsrDone},
    '{Read, RegAddrW'(RegControl), 32'd1 << CtrlIdle}
  };

  logic [3:0]  step_q;
  logic        asked_q, ready, over, interrupt, failed_q;
  logic [31:0] got;
  step_t       step;

  assign step     = Steps[step_q];
  assign done_o   = step_q == 4'(NumSteps);
  assign failed_o = failed_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {step_q, asked_q, failed_q} <= '0;
    end else if (!done_o) begin
      if (step.action == Wait ? interrupt : over) begin
        step_q  <= step_q + 4'd1;
        asked_q <= 1'b0;
        if (step.action == Read && got != step.value) begin
          $display("register 0x%03x holds 0x%08x, expected 0x%08x", step.address, got, step.value);
          failed_q <= 1'b1;
        end
      end else if (step.action != Wait && ready) begin
        asked_q <= 1'b1;
      end
    end
  end

  logic                awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready;
  logic [RegAddrW-1:0] awaddr, araddr;
  logic [31:0]         wdata, rdata;
  logic [3:0]          wstrb;

  lite_master u_master (
    .clk_i, .rst_ni,
    .in_valid_i(!done_o && !asked_q && step.action != Wait), .in_ready_o(ready),
    .write_i(step.action == Write), .address_i(step.address), .data_i(step.value), .over_o(over), .data_o(got),
    .awvalid_o(awvalid), .awready_i(awready), .awaddr_o(awaddr), .wvalid_o(wvalid), .wready_i(wready), .wdata_o(wdata),
    .wstrb_o(wstrb), .bvalid_i(bvalid), .bready_o(bready), .arvalid_o(arvalid), .arready_i(arready), .araddr_o(araddr),
    .rvalid_i(rvalid), .rready_o(rready), .rdata_i(rdata)
  );

  // A job that is refused asks the memory for nothing, so its ports are left open.
  castray_top #(.Lanes(Lanes), .Contexts(Contexts), .TileLog2(TileLog2), .Ports(1), .L2Kbytes(0)) u_castray (
    .aclk(clk_i), .aresetn(rst_ni), .interrupt,
    .s_axi_awvalid(awvalid), .s_axi_awready(awready), .s_axi_awaddr(awaddr),
    .s_axi_wvalid(wvalid), .s_axi_wready(wready), .s_axi_wdata(wdata), .s_axi_wstrb(wstrb),
    .s_axi_bvalid(bvalid), .s_axi_bready(bready), .s_axi_bresp(),
    .s_axi_arvalid(arvalid), .s_axi_arready(arready), .s_axi_araddr(araddr),
    .s_axi_rvalid(rvalid), .s_axi_rready(rready), .s_axi_rdata(rdata), .s_axi_rresp(),
    .m_axi_0_arvalid(), .m_axi_0_arready('0), .m_axi_0_araddr(), .m_axi_0_arid(), .m_axi_0_arlen(), .m_axi_0_arsize(),
    .m_axi_0_arburst(), .m_axi_0_arcache(), .m_axi_0_arprot(),
    .m_axi_0_rvalid('0), .m_axi_0_rready(), .m_axi_0_rdata('0), .m_axi_0_rid('0), .m_axi_0_rresp('0), .m_axi_0_rlast('0),
    .m_axi_0_awvalid(), .m_axi_0_awready('0), .m_axi_0_awaddr(), .m_axi_0_awid(), .m_axi_0_awlen(), .m_axi_0_awsize(),
    .m_axi_0_awburst(), .m_axi_0_awcache(), .m_axi_0_awprot(),
    .m_axi_0_wvalid(), .m_axi_0_wready('0), .m_axi_0_wdata(), .m_axi_0_wstrb(), .m_axi_0_wlast(),
    .m_axi_0_bvalid('0), .m_axi_0_bready(), .m_axi_0_bid('0), .m_axi_0_bresp('0),
    .m_axi_1_arvalid(), .m_axi_1_arready('0), .m_axi_1_araddr(), .m_axi_1_arid(), .m_axi_1_arlen(), .m_axi_1_arsize(),
    .m_axi_1_arburst(), .m_axi_1_arcache(), .m_axi_1_arprot(),
    .m_axi_1_rvalid('0), .m_axi_1_rready(), .m_axi_1_rdata('0), .m_axi_1_rid('0), .m_axi_1_rresp('0), .m_axi_1_rlast('0),
    .m_axi_1_awvalid(), .m_axi_1_awready('0), .m_axi_1_awaddr(), .m_axi_1_awid(), .m_axi_1_awlen(), .m_axi_1_awsize(),
    .m_axi_1_awburst(), .m_axi_1_awcache(), .m_axi_1_awprot(),
    .m_axi_1_wvalid(), .m_axi_1_wready('0), .m_axi_1_wdata(), .m_axi_1_wstrb(), .m_axi_1_wlast(),
    .m_axi_1_bvalid('0), .m_axi_1_bready(), .m_axi_1_bid('0), .m_axi_1_bresp('0)
  );
endmodule
