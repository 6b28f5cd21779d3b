// SPDX-License-Identifier: Apache-2.0
// Writes the rows of one complete tile after another, each as one burst of the tile's full width:
//   address = base + y stride + 4 (x - x mod Size)    strobes: x to x + width - 1 of the tile
//   multiply, address   one cycle each, once a tile: y stride/64 is 12x26 bits, one DSP
//   read                Size/4 cycles a row, four pixels each from the gather's memory (they come a
//                       cycle later), into one of two buffers
//   send                the row from it, until taken, while the next one is read; with the last row
//                       done_o, and the slot still on slot_o
// A row takes Size/4 cycles, as long as its beats take the port (two rows of a tile of 4 x 4 take three),
// and a tile five more.
module tile_rows
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned TileLog2 = DefaultTileLog2
) (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  addr_t       base_i,
  input  logic [31:0] stride_i,

  input  logic        tile_valid_i,
  output logic        tile_ready_o,
  input  tile_t       tile_i,

  output logic        read_o,        // the beat of a row, beat_i a cycle later
  output logic [7:0]  slot_o,
  output logic [3:0]  row_o,         // of the tile's place in the grid, not of its first row
  output logic [1:0]  beat_o,
  input  beat_t       beat_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output write_req_t  out_o,
  output logic        done_o         // the tile's last row was taken
);
  if (TileLog2 < 2 || TileLog2 > 4) begin : g_tile
    $error("tile_rows: TileLog2 must be 2, 3 or 4");
  end

  localparam int unsigned Size       = 1 << TileLog2;
  localparam int unsigned Beats      = Size * PixelBytes / StrbW;
  localparam int unsigned StrideLog2 = $clog2(BufferAlign);

  typedef enum logic [1:0] { Idle, Multiply, Address, Rows } state_t;
  state_t state_q;
  tile_t  tile_q;

  // The pixels of a row that are the tile's.
  function automatic logic [Size-1:0] columns(pixel_t x, logic [4:0] width);
    logic [TileLog2-1:0] first;
    first = x[TileLog2-1:0];
    for (int unsigned i = 0; i < Size; i++)
      columns[i] = 32'(first) <= i && i < 32'(first) + 32'(width);
  endfunction
  function automatic logic [63:0] strobes(logic [Size-1:0] pixels);
    strobes = '0;
    for (int unsigned i = 0; i < Size; i++) strobes[PixelBytes*i +: PixelBytes] = {PixelBytes{pixels[i]}};
  endfunction

  // ---- Control ----
  logic       taken, last;
  logic [4:0] to_read_q, to_send_q;      // rows left
  assign tile_ready_o = state_q == Idle;
  assign taken        = out_valid_o && out_ready_i;
  assign done_o       = taken && to_send_q == 5'd1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else begin
      unique case (state_q)
        Idle:     if (tile_valid_i) state_q <= Multiply;
        Multiply: state_q <= Address;
        Address:  state_q <= Rows;
        default:  if (done_o) state_q <= Idle;
      endcase
    end
  end

  // ---- Address ----
  typedef logic [PixelW+31-StrideLog2:0] product_t;   // a row's number times its stride
  product_t    product_q;
  addr_t       addr_q;
  logic [3:0]  row_q;
  logic [63:0] strb_q;
  function automatic product_t mul_row(pixel_t y, logic [31:StrideLog2] stride);
    return product_t'(y) * product_t'(stride);
  endfunction
  always_ff @(posedge clk_i) begin
    if (state_q == Idle && tile_valid_i) begin
      tile_q    <= tile_i;
      to_read_q <= tile_i.height;
      to_send_q <= tile_i.height;
      row_q     <= 4'(tile_i.y[TileLog2-1:0]);
    end
    if (last) begin
      to_read_q <= to_read_q - 1'b1;
      row_q     <= row_q + 1'b1;
    end
    if (state_q == Multiply) product_q <= mul_row(tile_q.y, stride_i[31:StrideLog2]);
    if (state_q == Address) begin
      addr_q <= base_i + addr_t'({product_q, {StrideLog2{1'b0}}}) +
                addr_t'({tile_q.x[PixelW-1:TileLog2], {(TileLog2 + $clog2(PixelBytes)){1'b0}}});
      strb_q <= strobes(columns(tile_q.x, tile_q.width));
    end
    if (taken) begin
      addr_q    <= addr_q + addr_t'(stride_i);
      to_send_q <= to_send_q - 1'b1;
    end
  end

  // ---- Rows, in two buffers by turns: one is filled while the other is sent ----
  localparam int unsigned RowW = Beats * DataW;
  logic [RowW-1:0] row_pixels_q [2];
  logic [1:0]      busy_q, full_q;      // a row is read into it; it is here
  logic            fill_q, send_q;      // which buffer
  logic            arrives_q, arrives_last_q, arrives_at_q;
  logic [1:0]      beat_q;
  function automatic logic [RowW-1:0] above(beat_t beat, logic [RowW-1:0] row);
    return (RowW'(beat) << (RowW - DataW)) | (row >> DataW);
  endfunction
  assign read_o = state_q == Rows && to_read_q != '0 && (beat_q != '0 || !busy_q[fill_q]);
  assign last   = read_o && beat_q == 2'(Beats - 1);
  assign slot_o = tile_q.slot;
  assign row_o  = row_q;
  assign beat_o = beat_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q    <= '0;
      full_q    <= '0;
      fill_q    <= 1'b0;
      send_q    <= 1'b0;
      beat_q    <= '0;
      arrives_q <= 1'b0;
    end else begin
      arrives_q <= read_o;
      if (read_o) beat_q <= last ? '0 : beat_q + 1'b1;
      if (last) fill_q <= !fill_q;
      if (taken) send_q <= !send_q;
      if (taken) busy_q[send_q] <= 1'b0;
      if (read_o) busy_q[fill_q] <= 1'b1;
      if (taken) full_q[send_q] <= 1'b0;
      if (arrives_q && arrives_last_q) full_q[arrives_at_q] <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    arrives_last_q <= last;
    arrives_at_q   <= fill_q;
    if (arrives_q) row_pixels_q[arrives_at_q] <= above(beat_i, row_pixels_q[arrives_at_q]);
  end

  // ---- Send ----
  assign out_valid_o = full_q[send_q];
  assign out_o = '{addr: addr_q, beats: 3'(Beats), strb: strb_q, data: 512'(row_pixels_q[send_q])};
endmodule
