// SPDX-License-Identifier: Apache-2.0
// One over a number whose top bit is set, to RecipW bits: with den cut to DspAW - 1 bits and
// q = floor(2^(bits+RecipW-1) / den), which is at least 2^(RecipW-1),
//   guess = min(q or q + 1, 2^RecipW - 1)
//   s1      a line of the table                   den's Index bits below the top one
//   s2, s3  its fall times den's bits below those
//   s4      (start - fall) / 4
// The table holds a chord above the curve 1/x over each of 2^Index parts of [1, 2), in quarters, its ends rounded up. A
// chord is at most h^2/8 max|f''| = 2^-(2 Index + 2) above the curve, so that with an end's rounding and what is dropped of
// the product the guess before its cut exceeds the exact quotient by 2^(RecipW-2 Index-2) + 1/2, less than one.
// One a cycle, four cycles, never stalls. en_i[k] says that stage k + 1 takes an item in this cycle. A multiplier of
// 27x18 and a memory of 2^Index words. Method: piecewise linear interpolation (Muller, Elementary Functions, 2006).
// Model: a step of div_floor, cpp_model/math/div_pipe.hpp.
module recip_guess
  import castray_cfg_pkg::*;
#(
  parameter int unsigned DenW = 26
) (
  input  logic              clk_i,

  input  logic [3:0]        en_i,
  input  logic [DenW-1:0]   den_i,
  output logic [RecipW-1:0] guess_o
);
  localparam int unsigned Index = (RecipW + 1) / 2;
  localparam int unsigned Below = DenW - 1 - Index;
  localparam int unsigned LowW  = (Below > DspAW - 2 - Index) ? DspAW - 2 - Index : Below;
  if (DenW < Index + 2 || RecipW > DspBW - 1) begin : g_width
    $error("recip_guess: DenW must be at least %0d, RecipW at most %0d", Index + 2, DspBW - 1);
  end
  typedef logic [RecipW+2:0]       start_t;   // with two fraction bits
  typedef logic [RecipW-Index+2:0] fall_t;
  typedef struct packed {
    start_t start;
    fall_t  fall;
  } line_t;
  typedef logic [LowW-1:0]               low_t;
  typedef logic [LowW+$bits(fall_t)-1:0] product_t;

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

  line_t           line1_q, line2_q;
  low_t            low1_q, low2_q;
  start_t          start3_q;
  product_t        product_q;
  logic [RecipW:0] guess;
  assign guess = (RecipW+1)'((start3_q - start_t'(product_q >> LowW)) >> 2);

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      line1_q <= table_q[den_i[DenW-2 -: Index]];
      low1_q  <= den_i[DenW-2-Index -: LowW];
    end
    if (en_i[1]) begin
      line2_q <= line1_q;
      low2_q  <= low1_q;
    end
    if (en_i[2]) begin
      product_q <= line2_q.fall * low2_q;
      start3_q  <= line2_q.start;
    end
    if (en_i[3]) guess_o <= guess[RecipW] ? '1 : guess[RecipW-1:0];
  end
endmodule
