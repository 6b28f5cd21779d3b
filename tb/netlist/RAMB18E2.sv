// SPDX-License-Identifier: Apache-2.0
// The RAMB18E2 in the three ways that synthesis uses it here, all with one clock, read first, without output
// registers and resets; only a table has initial contents:
//   both halves   36 bits: A reads, its data's upper half on B's pins; B writes likewise
//   a table       the same, and nothing writes
//   two ports     A writes and B reads, 9 bits or 18 of them
// Everything else stops: another parameter at elaboration, another mode when it is seen.
module RAMB18E2 #(
  parameter     WRITE_MODE_A = "NO_CHANGE", WRITE_MODE_B = "NO_CHANGE",
  parameter int READ_WIDTH_A = 0, READ_WIDTH_B = 0, WRITE_WIDTH_A = 0, WRITE_WIDTH_B = 0, DOA_REG = 1, DOB_REG = 1,
  parameter logic [255:0] INIT_00 = 256'd0, INIT_01 = 256'd0, INIT_02 = 256'd0, INIT_03 = 256'd0, INIT_04 = 256'd0, INIT_05 = 256'd0, INIT_06 = 256'd0, INIT_07 = 256'd0,
  parameter logic [255:0] INIT_08 = 256'd0, INIT_09 = 256'd0, INIT_0A = 256'd0, INIT_0B = 256'd0, INIT_0C = 256'd0, INIT_0D = 256'd0, INIT_0E = 256'd0, INIT_0F = 256'd0,
  parameter logic [255:0] INIT_10 = 256'd0, INIT_11 = 256'd0, INIT_12 = 256'd0, INIT_13 = 256'd0, INIT_14 = 256'd0, INIT_15 = 256'd0, INIT_16 = 256'd0, INIT_17 = 256'd0,
  parameter logic [255:0] INIT_18 = 256'd0, INIT_19 = 256'd0, INIT_1A = 256'd0, INIT_1B = 256'd0, INIT_1C = 256'd0, INIT_1D = 256'd0, INIT_1E = 256'd0, INIT_1F = 256'd0,
  parameter logic [255:0] INIT_20 = 256'd0, INIT_21 = 256'd0, INIT_22 = 256'd0, INIT_23 = 256'd0, INIT_24 = 256'd0, INIT_25 = 256'd0, INIT_26 = 256'd0, INIT_27 = 256'd0,
  parameter logic [255:0] INIT_28 = 256'd0, INIT_29 = 256'd0, INIT_2A = 256'd0, INIT_2B = 256'd0, INIT_2C = 256'd0, INIT_2D = 256'd0, INIT_2E = 256'd0, INIT_2F = 256'd0,
  parameter logic [255:0] INIT_30 = 256'd0, INIT_31 = 256'd0, INIT_32 = 256'd0, INIT_33 = 256'd0, INIT_34 = 256'd0, INIT_35 = 256'd0, INIT_36 = 256'd0, INIT_37 = 256'd0,
  parameter logic [255:0] INIT_38 = 256'd0, INIT_39 = 256'd0, INIT_3A = 256'd0, INIT_3B = 256'd0, INIT_3C = 256'd0, INIT_3D = 256'd0, INIT_3E = 256'd0, INIT_3F = 256'd0,
  parameter logic [255:0] INITP_00 = 256'd0, INITP_01 = 256'd0, INITP_02 = 256'd0, INITP_03 = 256'd0, INITP_04 = 256'd0, INITP_05 = 256'd0, INITP_06 = 256'd0, INITP_07 = 256'd0
) (
  input  logic        CLKARDCLK,
  input  logic        CLKBWRCLK,
  input  logic        ENARDEN,
  input  logic        ENBWREN,
  input  logic        REGCEAREGCE,
  input  logic        REGCEB,
  input  logic        ADDRENA,
  input  logic        ADDRENB,
  input  logic        RSTRAMARSTRAM,
  input  logic        RSTRAMB,
  input  logic        RSTREGARSTREG,
  input  logic        RSTREGB,
  input  logic        SLEEP,
  input  logic [13:0] ADDRARDADDR,
  input  logic [13:0] ADDRBWRADDR,
  input  logic [1:0]  WEA,
  input  logic [3:0]  WEBWE,
  input  logic [15:0] DINADIN,
  input  logic [1:0]  DINPADINP,
  input  logic [15:0] DINBDIN,
  input  logic [1:0]  DINPBDINP,
  output logic [15:0] DOUTADOUT,
  output logic [1:0]  DOUTPADOUTP,
  output logic [15:0] DOUTBDOUT,
  output logic [1:0]  DOUTPBDOUTP
);
  localparam int Half  = 2;      // bytes of a port
  localparam bit Both  = READ_WIDTH_A == 18 * Half;
  localparam bit Table = Both && WRITE_WIDTH_B == 0;
  localparam int Width = Both ? 2 * Half : (READ_WIDTH_B < 9) ? 1 : READ_WIDTH_B / 9;
  if (WRITE_MODE_A != "READ_FIRST" || WRITE_MODE_B != "READ_FIRST" || DOA_REG != 0 || DOB_REG != 0) begin : g_mode
    $error("RAMB18E2: only read-first without output registers is modelled");
  end
  if (Both ? (!(WRITE_WIDTH_B inside {0, 18 * Half}) || READ_WIDTH_B != 0 || WRITE_WIDTH_A != 0)
           : (READ_WIDTH_A != 0 || WRITE_WIDTH_B != 0 || WRITE_WIDTH_A != READ_WIDTH_B
              || !(READ_WIDTH_B inside {9, 18}))) begin : g_widths
    $error("RAMB18E2: widths %0d, %0d, %0d, %0d are not modelled", READ_WIDTH_A, READ_WIDTH_B, WRITE_WIDTH_A, WRITE_WIDTH_B);
  end
  always @(posedge CLKARDCLK) begin
    if (!CLKBWRCLK && !Table) $fatal(1, "RAMB18E2: two clocks");
  end
  always_comb begin
    if (REGCEAREGCE || REGCEB || !ADDRENA || !ADDRENB || RSTRAMARSTRAM || RSTRAMB || RSTREGARSTREG || RSTREGB || SLEEP)
      $fatal(1, "RAMB18E2: a mode that is not modelled");
  end

  localparam int AddrW = $clog2(2048 / Width);
  logic [Width-1:0] [8:0] read, write;
  logic [Width-1:0]       strobe;
  localparam logic [64*256-1:0] Data = {
    INIT_3F, INIT_3E, INIT_3D, INIT_3C, INIT_3B, INIT_3A, INIT_39, INIT_38,
    INIT_37, INIT_36, INIT_35, INIT_34, INIT_33, INIT_32, INIT_31, INIT_30,
    INIT_2F, INIT_2E, INIT_2D, INIT_2C, INIT_2B, INIT_2A, INIT_29, INIT_28,
    INIT_27, INIT_26, INIT_25, INIT_24, INIT_23, INIT_22, INIT_21, INIT_20,
    INIT_1F, INIT_1E, INIT_1D, INIT_1C, INIT_1B, INIT_1A, INIT_19, INIT_18,
    INIT_17, INIT_16, INIT_15, INIT_14, INIT_13, INIT_12, INIT_11, INIT_10,
    INIT_0F, INIT_0E, INIT_0D, INIT_0C, INIT_0B, INIT_0A, INIT_09, INIT_08,
    INIT_07, INIT_06, INIT_05, INIT_04, INIT_03, INIT_02, INIT_01, INIT_00
  };
  localparam logic [8*256-1:0] Parity = {INITP_07, INITP_06, INITP_05, INITP_04, INITP_03, INITP_02, INITP_01, INITP_00};
  block_ram #(.Bytes(2048), .Width(Width), .Known(Table), .Data(Data), .Parity(Parity)) u_ram (
    .clk_i(CLKARDCLK),
    .read_i(Both ? ENARDEN : ENBWREN), .read_at_i(Both ? ADDRARDADDR[13 -: AddrW] : ADDRBWRADDR[13 -: AddrW]),
    .read_o(read), .enable_i(Both ? ENBWREN : ENARDEN), .write_i(strobe),
    .write_at_i(Both ? ADDRBWRADDR[13 -: AddrW] : ADDRARDADDR[13 -: AddrW]), .write_data_i(write)
  );

  // Byte i of a port: eight data bits and a parity bit.
  always_comb begin
    DOUTADOUT   = '0;
    DOUTPADOUTP = '0;
    DOUTBDOUT   = '0;
    DOUTPBDOUTP = '0;
    for (int i = 0; i < Width; i++) begin
      write[i]  = (Both && i >= Half) ? {DINPBDINP[i % Half], DINBDIN[8 * (i % Half) +: 8]}
                                      : {DINPADINP[i % Half], DINADIN[8 * (i % Half) +: 8]};
      strobe[i] = Both ? WEBWE[i] : WEA[i % 2];
      if (Both && i < Half) {DOUTPADOUTP[i % Half], DOUTADOUT[8 * (i % Half) +: 8]} = read[i];
      else {DOUTPBDOUTP[i % Half], DOUTBDOUT[8 * (i % Half) +: 8]} = read[i];
    end
  end
endmodule
