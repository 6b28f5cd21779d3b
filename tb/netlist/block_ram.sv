// SPDX-License-Identifier: Apache-2.0
// The memory in RAMB18E2 and RAMB36E2: one port writes bytes of nine bits, one reads; a read in the
// same cycle sees what was there before. Bytes / Width words of Width bytes. Data and Parity: what it
// holds at first, where Known.
module block_ram #(
  parameter int Bytes = 2048,
  parameter int Width = 2,
  parameter bit Known = 1'b0,
  parameter logic [8*Bytes-1:0] Data   = '0,
  parameter logic [Bytes-1:0]   Parity = '0,
  localparam int AddrW = $clog2(Bytes / Width)
) (
  input  logic                        clk_i,
  input  logic                        read_i,
  input  logic [AddrW-1:0]            read_at_i,
  output logic [Width-1:0] [8:0]      read_o,
  input  logic                        enable_i,
  input  logic [Width-1:0]            write_i,
  input  logic [AddrW-1:0]            write_at_i,
  input  logic [Width-1:0] [8:0]      write_data_i
);
  logic [Width-1:0] [8:0] mem_q [Bytes / Width];
  initial begin
    for (int i = 0; i < Bytes; i++) if (Known) mem_q[i / Width][i % Width] = {Parity[i], Data[8*i +: 8]};
  end
  always_ff @(posedge clk_i) begin
    if (read_i) read_o <= mem_q[read_at_i];
    for (int i = 0; i < Width; i++) if (enable_i && write_i[i]) mem_q[write_at_i][i] <= write_data_i[i];
  end
endmodule
