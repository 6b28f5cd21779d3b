// SPDX-License-Identifier: Apache-2.0
// Several gathers side by side; select_i says which one is under test.
module tile_gather_tb
  import castray_pkg::*;
(
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [1:0]  select_i,

  input  addr_t       base_i,
  input  logic [31:0] stride_i,
  output logic        idle_o,

  input  logic        tile_valid_i,
  output logic        tile_ready_o,
  input  tile_t       tile_i,
  output logic [7:0]  tile_slot_o,

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  shaded_t     in_i,

  input  logic        fill_valid_i,
  output logic        fill_ready_o,
  input  logic [7:0]  fill_slot_i,
  input  logic [31:0] fill_colour_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output write_req_t  out_o
);
  localparam int unsigned Units = 4;
  localparam int unsigned TileLog2 [Units] = '{2, 3, 4, 3};
  localparam int unsigned Slots    [Units] = '{16, 16, 3, 1};

  logic [Units-1:0] idle, tile_ready, in_ready, fill_ready, out_valid;
  write_req_t       out [Units];
  logic [7:0]       tile_slot [Units];
  for (genvar i = 0; i < Units; i++) begin : g_unit
    logic selected;
    assign selected = select_i == 2'(i);
    tile_gather #(.TileLog2(TileLog2[i]), .Slots(Slots[i])) u_gather (
      .clk_i, .rst_ni, .base_i, .stride_i, .idle_o(idle[i]),
      .tile_valid_i(tile_valid_i && selected), .tile_ready_o(tile_ready[i]), .tile_i, .tile_slot_o(tile_slot[i]),
      .in_valid_i(in_valid_i && selected), .in_ready_o(in_ready[i]), .in_i,
      .fill_valid_i(fill_valid_i && selected), .fill_ready_o(fill_ready[i]), .fill_slot_i, .fill_colour_i,
      .out_valid_o(out_valid[i]), .out_ready_i(out_ready_i && selected), .out_o(out[i])
    );
  end
  assign idle_o       = idle[select_i];
  assign tile_ready_o = tile_ready[select_i];
  assign tile_slot_o  = tile_slot[select_i];
  assign in_ready_o   = in_ready[select_i];
  assign fill_ready_o = fill_ready[select_i];
  assign out_valid_o  = out_valid[select_i];
  assign out_o        = out[select_i];
endmodule
