// SPDX-License-Identifier: Apache-2.0
// One over a number whose top bit is set: q = min(floor(2^(DenW+RecipW-1) / den), 2^RecipW - 1).
//   s1      a line of the table              of den's Index bits below the top one
//   s2, s3  its fall times the bits below
//   s4      z = (start - fall) / 4           q or q + 1, as is shown below
//   s5      p = z den
//   s6      q = z, or z - 1 where p reaches 2^(DenW+RecipW-1)
// The table holds a chord above the curve 1/x over each of 2^Index parts of [1, 2), in quarters, its ends rounded up. A
// chord is at most h^2/8 max|f''| = 2^-(2 Index + 2) above the curve, so that with an end's rounding and what is dropped
// of the product z before its cut exceeds the exact quotient by 2^(RecipW-2 Index-2) + 1/2, less than one.
// Where z is 2^RecipW, q is 2^RecipW - 1: its low bits, which are zero, less one.
// One a cycle, six cycles, never stalls. en_i[k] says that stage k + 1 takes an item in this cycle. Two multipliers
// of 27x18 and a memory of 2^Index words. Method: piecewise linear interpolation with one correction by the
// remainder (Muller, Elementary Functions, 2006, chapters 4 and 5).
// Model: div_floor of cpp_model/math/div_pipe.hpp, equal bit for bit.
module reciprocal
  import castray_cfg_pkg::*;
#(
  parameter int unsigned DenW = 26
) (
  input  logic              clk_i,

  input  logic [5:0]        en_i,
  input  logic [DenW-1:0]   den_i,
  output logic [RecipW-1:0] q_o
);
  localparam int unsigned Index = (RecipW + 1) / 2;
  localparam int unsigned LowW  = DenW - 1 - Index;   // bits of den below the table's
  if (DenW < Index + 2 || DenW > DspAW - 1 || RecipW > DspBW - 1) begin : g_width
    $error("reciprocal: DenW must be Index + 2 to %0d and RecipW at most %0d", DspAW - 1, DspBW - 1);
  end
  typedef logic [RecipW+2:0] start_t;   // with two fraction bits
  typedef logic [RecipW-Index+2:0] fall_t;
  typedef struct packed {
    start_t start;
    fall_t  fall;
  } line_t;

  // 2^(RecipW+2) / (1 + i / 2^Index), rounded up.
  function automatic start_t node(int unsigned i);
    longint unsigned den;
    den = (longint'(1) << Index) + longint'(i);
    return start_t'(((longint'(1) << (RecipW + 2 + Index)) + den - 1) / den);
  endfunction

  (* rom_style = "block" *) line_t table_q [1 << Index];
  initial begin
    for (int unsigned i = 0; i < 1 << Index; i++) table_q[i] = '{start: node(i), fall: fall_t'(node(i) - node(i + 1))};
  end

  typedef logic [LowW-1:0]                low_t;
  typedef logic [LowW+$bits(fall_t)-1:0]  product_t;
  typedef logic [DenW+RecipW-1:0]         check_t;
  logic [DenW-1:0] den_q [4];
  line_t           line_q, line2_q;
  start_t          start3_q;
  product_t        product_q;
  logic [RecipW:0] z_q, z5_q;
  logic            over_q;
  check_t          check;
  assign check = z_q[RecipW-1:0] * den_q[3];

  always_ff @(posedge clk_i) begin
    if (en_i[0]) line_q <= table_q[den_i[DenW-2 -: Index]];
    if (en_i[0]) den_q[0] <= den_i;
    for (int unsigned i = 1; i < 4; i++) if (en_i[i]) den_q[i] <= den_q[i-1];
    if (en_i[1]) line2_q <= line_q;
    if (en_i[2]) begin
      product_q <= line2_q.fall * den_q[1][LowW-1:0];
      start3_q  <= line2_q.start;
    end
    if (en_i[3]) z_q <= (RecipW+1)'((start3_q - start_t'(product_q >> LowW)) >> 2);
    if (en_i[4]) begin
      z5_q   <= z_q;
      over_q <= z_q[RecipW] || check[DenW+RecipW-1];
    end
    if (en_i[5]) q_o <= z5_q[RecipW-1:0] - RecipW'(over_q);
  end
endmodule
