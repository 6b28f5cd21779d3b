// SPDX-License-Identifier: Apache-2.0
// A memory of Beats x 16 bytes behind AXI4, filled from a file: one read burst and one write burst at a time, a beat a cycle.
module chip_memory #(
  parameter int unsigned Beats = 2048,
  parameter              Image = "image.hex",
  localparam int unsigned BeatW = $clog2(Beats)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic [BeatW-1:0] look_i,
  output logic [127:0]     look_o,

  input  logic             arvalid_i,
  output logic             arready_o,
  input  logic [39:0]      araddr_i,
  input  logic [3:0]       arid_i,
  input  logic [7:0]       arlen_i,
  output logic             rvalid_o,
  input  logic             rready_i,
  output logic [127:0]     rdata_o,
  output logic [3:0]       rid_o,
  output logic             rlast_o,

  input  logic             awvalid_i,
  output logic             awready_o,
  input  logic [39:0]      awaddr_i,
  input  logic [3:0]       awid_i,
  input  logic [7:0]       awlen_i,
  input  logic             wvalid_i,
  output logic             wready_o,
  input  logic [127:0]     wdata_i,
  input  logic [15:0]      wstrb_i,
  input  logic             wlast_i,
  output logic             bvalid_o,
  input  logic             bready_i,
  output logic [3:0]       bid_o
);
  logic [127:0] memory [Beats];
  initial $readmemh(Image, memory);
  assign look_o = memory[look_i];

  // ---- Reads ----
  logic             reading_q;
  logic [BeatW-1:0] read_q;
  logic [7:0]       left_q;
  assign arready_o = !reading_q;
  assign rvalid_o  = reading_q;
  assign rdata_o   = memory[read_q];
  assign rlast_o   = left_q == '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      reading_q <= 1'b0;
    end else if (!reading_q) begin
      reading_q <= arvalid_i;
      {read_q, rid_o, left_q} <= {araddr_i[4 +: BeatW], arid_i, arlen_i};
    end else if (rready_i) begin
      read_q    <= read_q + 1'b1;
      left_q    <= left_q - 8'd1;
      reading_q <= !rlast_o;
    end
  end

  // ---- Writes ----
  logic             writing_q, answer_q;
  logic [BeatW-1:0] write_q;
  assign awready_o = !writing_q && !answer_q;
  assign wready_o  = writing_q;
  assign bvalid_o  = answer_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {writing_q, answer_q} <= '0;
    end else if (writing_q) begin
      if (wvalid_i) begin
        for (int i = 0; i < 16; ++i) if (wstrb_i[i]) memory[write_q][8*i +: 8] <= wdata_i[8*i +: 8];
        write_q   <= write_q + 1'b1;
        writing_q <= !wlast_i;
        answer_q  <= wlast_i;
      end
    end else if (answer_q) begin
      answer_q <= !bready_i;
    end else begin
      writing_q <= awvalid_i;
      {write_q, bid_o} <= {awaddr_i[4 +: BeatW], awid_i};
    end
  end

  // Nothing outside the memory is asked for.
  always_ff @(posedge clk_i) begin
    if (rst_ni && (arvalid_i && araddr_i + 16 * 40'(arlen_i) >= 40'(16 * Beats) || awvalid_i && awaddr_i + 16 * 40'(awlen_i) >= 40'(16 * Beats)))
      $fatal(1, "a burst leaves the memory");
  end
endmodule
