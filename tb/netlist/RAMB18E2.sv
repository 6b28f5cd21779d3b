// SPDX-License-Identifier: Apache-2.0
// The RAMB18E2 in the two ways that synthesis uses it here, both with one clock, read first, without output
// registers, resets and initial contents:
//   both halves   36 bits: A reads, its data's upper half on B's pins; B writes likewise
//   two ports     A writes and B reads, 9 bits or 18 of them
// Everything else stops: another parameter at elaboration, another mode when it is seen.
module RAMB18E2 #(
  parameter     WRITE_MODE_A = "NO_CHANGE", WRITE_MODE_B = "NO_CHANGE",
  parameter int READ_WIDTH_A = 0, READ_WIDTH_B = 0, WRITE_WIDTH_A = 0, WRITE_WIDTH_B = 0, DOA_REG = 1, DOB_REG = 1
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
  localparam int Width = Both ? 2 * Half : (READ_WIDTH_B < 9) ? 1 : READ_WIDTH_B / 9;
  if (WRITE_MODE_A != "READ_FIRST" || WRITE_MODE_B != "READ_FIRST" || DOA_REG != 0 || DOB_REG != 0) begin : g_mode
    $error("RAMB18E2: only read-first without output registers is modelled");
  end
  if (Both ? (WRITE_WIDTH_B != 18 * Half || READ_WIDTH_B != 0 || WRITE_WIDTH_A != 0)
           : (READ_WIDTH_A != 0 || WRITE_WIDTH_B != 0 || WRITE_WIDTH_A != READ_WIDTH_B
              || !(READ_WIDTH_B inside {9, 18}))) begin : g_widths
    $error("RAMB18E2: widths %0d, %0d, %0d, %0d are not modelled", READ_WIDTH_A, READ_WIDTH_B, WRITE_WIDTH_A, WRITE_WIDTH_B);
  end
  always @(posedge CLKARDCLK) begin
    if (!CLKBWRCLK) $fatal(1, "RAMB18E2: two clocks");
  end
  always_comb begin
    if (REGCEAREGCE || REGCEB || !ADDRENA || !ADDRENB || RSTRAMARSTRAM || RSTRAMB || RSTREGARSTREG || RSTREGB || SLEEP)
      $fatal(1, "RAMB18E2: a mode that is not modelled");
  end

  localparam int AddrW = $clog2(2048 / Width);
  logic [Width-1:0] [8:0] read, write;
  logic [Width-1:0]       strobe;
  block_ram #(.Bytes(2048), .Width(Width)) u_ram (
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
