// SPDX-License-Identifier: Apache-2.0
// Three row writers side by side, for tiles of 4, 8 and 16 pixels; select_i says which one is under test.
module tile_rows_tb
  import castray_pkg::*;
(
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [1:0]  select_i,

  input  addr_t       base_i,
  input  logic [31:0] stride_i,

  input  logic        tile_valid_i,
  output logic        tile_ready_o,
  input  tile_t       tile_i,

  output logic        read_o,
  output logic [7:0]  slot_o,
  output logic [3:0]  row_o,
  output logic [1:0]  beat_o,
  input  beat_t       beat_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output write_req_t  out_o,
  output logic        done_o
);
  localparam int unsigned Units = 3;

  logic [Units-1:0] tile_ready, read, out_valid, done;
  logic [7:0]       slot [Units];
  logic [3:0]       row  [Units];
  logic [1:0]       beat [Units];
  write_req_t       out  [Units];
  for (genvar i = 0; i < Units; i++) begin : g_unit
    logic selected;
    assign selected = select_i == 2'(i);
    tile_rows #(.TileLog2(i + 2)) u_rows (
      .clk_i, .rst_ni, .base_i, .stride_i,
      .tile_valid_i(tile_valid_i && selected), .tile_ready_o(tile_ready[i]), .tile_i,
      .read_o(read[i]), .slot_o(slot[i]), .row_o(row[i]), .beat_o(beat[i]), .beat_i,
      .out_valid_o(out_valid[i]), .out_ready_i(out_ready_i && selected), .out_o(out[i]), .done_o(done[i])
    );
  end
  assign tile_ready_o = tile_ready[select_i];
  assign read_o       = read[select_i];
  assign slot_o       = slot[select_i];
  assign row_o        = row[select_i];
  assign beat_o       = beat[select_i];
  assign out_valid_o  = out_valid[select_i];
  assign out_o        = out[select_i];
  assign done_o       = done[select_i];
endmodule
