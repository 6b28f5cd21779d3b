// SPDX-License-Identifier: Apache-2.0
// One access at a time to registers behind AXI4-Lite: taken when in_ready_o, over with the pulse of over_o.
module lite_master #(
  parameter int unsigned AddressBits = 9
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic                   in_valid_i,
  output logic                   in_ready_o,
  input  logic                   write_i,
  input  logic [AddressBits-1:0] address_i,
  input  logic [31:0]            data_i,
  output logic                   over_o,
  output logic [31:0]            data_o,      // what was read

  output logic                   awvalid_o,
  input  logic                   awready_i,
  output logic [AddressBits-1:0] awaddr_o,
  output logic                   wvalid_o,
  input  logic                   wready_i,
  output logic [31:0]            wdata_o,
  output logic [3:0]             wstrb_o,
  input  logic                   bvalid_i,
  output logic                   bready_o,
  output logic                   arvalid_o,
  input  logic                   arready_i,
  output logic [AddressBits-1:0] araddr_o,
  input  logic                   rvalid_i,
  output logic                   rready_o,
  input  logic [31:0]            rdata_i
);
  logic                busy_q, aw_q, w_q, ar_q;
  logic [AddressBits-1:0] address_q;
  logic [31:0]         data_q;

  assign in_ready_o = !busy_q;
  assign {awvalid_o, wvalid_o, arvalid_o} = {aw_q, w_q, ar_q};
  assign {awaddr_o, araddr_o, wdata_o, wstrb_o} = {address_q, address_q, data_q, 4'hf};
  assign {bready_o, rready_o} = {busy_q, busy_q};
  assign over_o = busy_q && (bvalid_i || rvalid_i);
  assign data_o = rdata_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {busy_q, aw_q, w_q, ar_q} <= '0;
    end else if (in_valid_i && in_ready_o) begin
      busy_q <= 1'b1;
      {aw_q, w_q, ar_q} <= {write_i, write_i, !write_i};
      address_q <= address_i;
      data_q <= data_i;
    end else begin
      if (awready_i) aw_q <= 1'b0;
      if (wready_i) w_q <= 1'b0;
      if (arready_i) ar_q <= 1'b0;
      if (over_o) busy_q <= 1'b0;
    end
  end
endmodule
