// SPDX-License-Identifier: Apache-2.0
// Integer square root, rounded down: root = the largest r with r^2 <= rad.
// Digit by digit, without restoring: each root bit takes two bits of the radicand, from the top.
//   rem' = 4 rem + next two bits - (4 root + 1)      where the bit before is 1, and for the first one
//                                + (4 root + 3)      where it is 0: rem is then negative
//   bit  = rem' >= 0
// Two root bits a stage. One root a cycle, RadW / 4 cycles, never stalls.
// Model: cpp_model/math/root_pipe.hpp, equal bit for bit.
module root_pipe #(
  parameter int unsigned RadW  = 56,
  localparam int unsigned RootW = RadW / 2
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  input  logic [RadW-1:0]  in_rad_i,

  output logic             out_valid_o,
  output logic [RootW-1:0] out_root_o
);
  if (RadW < 8 || RadW > 60 || RadW % 4 != 0) begin : g_width
    $error("root_pipe: RadW must be a multiple of 4 from 8 to 60");
  end

  localparam int unsigned Stages = RootW / 2;
  logic [Stages:0] valid;
  logic [Stages:1] valid_q;
  assign valid       = {valid_q, in_valid_i};
  assign out_valid_o = valid_q[Stages];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= valid[Stages-1:0];
  end

  // Block k gives the root's first k + 1 bits. A remainder lies from -(2 root + 1) to 2 root: rem is what is
  // below its sign, which is the inverse of the root's last bit.
  for (genvar k = 0; k < RootW; k++) begin : g_bit
    logic [RadW-1:0] rad;                  // what is not used yet, at the top
    logic [k+2:0]    sum;
    logic [k:0]      root_d, root;
    logic [k+1:0]    rem;
    if (k == 0) begin : g_first
      assign rad    = in_rad_i;
      assign sum    = {1'b0, rad[RadW-1 -: 2]} - 3'd1;
      assign root_d = !sum[k+2];
    end else begin : g_next
      logic up;
      assign up     = g_bit[k-1].root[0];
      assign sum    = {g_bit[k-1].rem, rad[RadW-1 -: 2]} - {!up, g_bit[k-1].root ^ {k{!up}}, 2'b01};
      assign root_d = {g_bit[k-1].root, !sum[k+2]};
      if (k % 2 == 0) begin : g_rad
        logic [RadW-1:0] rad_q;
        always_ff @(posedge clk_i) if (valid[k/2-1]) rad_q <= g_bit[k-1].rad << 2;
        assign rad = rad_q;
      end else begin : g_rad
        assign rad = g_bit[k-1].rad << 2;
      end
    end
    if (k % 2 == 1) begin : g_last
      logic [k:0]   root_q;
      logic [k+1:0] rem_q;
      always_ff @(posedge clk_i) begin
        if (valid[k/2]) begin
          root_q <= root_d;
          rem_q  <= sum[k+1:0];
        end
      end
      assign root = root_q;
      assign rem  = rem_q;
    end else begin : g_same
      assign root = root_d;
      assign rem  = sum[k+1:0];
    end
  end
  assign out_root_o = g_bit[RootW-1].root;

  logic unused_rest;   // of the last remainder
  assign unused_rest = ^g_bit[RootW-1].rem;
endmodule
