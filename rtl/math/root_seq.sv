// SPDX-License-Identifier: Apache-2.0
// Integer square root, rounded down: root = the largest r with r^2 <= rad.
// Digit by digit, restoring: each root bit takes two bits of the radicand, from the top.
//   rem' = 4 rem + next two bits      trial = 4 root + 1      bit = rem' >= trial
// Two root bits a cycle: a root every RadW / 4 + 1 cycles, one at a time; the result waits until it
// is taken, and the next radicand may enter in that very cycle.
// Model: cpp_model/math/root_seq.hpp, equal bit for bit.
module root_seq #(
  parameter int unsigned RadW  = 56,
  localparam int unsigned RootW = RadW / 2
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [RadW-1:0]  in_rad_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [RootW-1:0] out_root_o
);
  if (RadW < 8 || RadW > 60 || RadW % 4 != 0) begin : g_width
    $error("root_seq: RadW must be a multiple of 4 from 8 to 60");
  end

  localparam int unsigned Steps  = RootW / 2;
  localparam int unsigned CountW = $clog2(Steps);

  // rem <= 2 root always holds between bits, so it has one bit more than the root.
  typedef struct packed {
    logic [RootW:0]   rem;
    logic [RootW-1:0] root;
  } step_t;

  function automatic step_t two_bits(step_t now, logic [3:0] next);
    logic [RootW+2:0] rem, trial;
    two_bits = now;
    for (int unsigned i = 0; i < 2; i++) begin
      rem   = {two_bits.rem, next[3-2*i -: 2]};
      trial = {1'b0, two_bits.root, 2'b01};
      two_bits.root = {two_bits.root[RootW-2:0], rem >= trial};
      if (rem >= trial) rem = rem - trial;
      two_bits.rem = rem[RootW:0];
    end
  endfunction

  logic              busy_q, done_q, take;
  logic [CountW-1:0] left_q;   // steps after this one
  logic [RadW-1:0]   rad_q;    // the bits not yet used, at the top
  step_t             step_q;

  assign in_ready_o  = !busy_q && (!done_q || out_ready_i);
  assign out_valid_o = done_q;
  assign out_root_o  = step_q.root;
  assign take        = in_valid_i && in_ready_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      done_q <= 1'b0;
    end else begin
      if (take) busy_q <= 1'b1;
      else if (left_q == '0) busy_q <= 1'b0;
      if (busy_q && left_q == '0) done_q <= 1'b1;
      else if (out_ready_i) done_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      left_q <= CountW'(Steps - 1);
      rad_q  <= in_rad_i;
      step_q <= '0;
    end else if (busy_q) begin
      left_q <= left_q - 1'b1;
      rad_q  <= rad_q << 4;
      step_q <= two_bits(step_q, rad_q[RadW-1 -: 4]);
    end
  end
endmodule
