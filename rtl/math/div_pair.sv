// SPDX-License-Identifier: Apache-2.0
// Two divisions by one divisor whose top bit is set, q = num 2^QFrac / den to the nearest, halves upwards, for
// num <= den. By products, where math/div_pipe subtracts:
//   s1-s4    r, near 2^(DenW+16) / den: c = r den - 2^(DenW+16) is small, |c| <= 2^DenW     recip_guess
//   s5, s6   t = num r, and c                                                     exact
//   s7       g = t c, of the upper bits of both
//   s8       x = t - 2^-(DenW+16) g, cut: q or one less, q' below
//   s9, s10  v = (2 q' + 1) den, its lower DenW + 2 bits
//   s11      past: num 2^(QFrac+1) >= v, so that q' + 1/2 is not above the quotient
//   s12      q = q' + past
// num / den = 2^-(DenW+16) t (1 + e + e^2 ..) with e = -2^-(DenW+16) c, at most 2^-16: without e^2, and with the bits that are
// dropped, x is off by less than half of q's last bit, and so q' + 1/2 is the one number at which q may change.
// A divisor whose top bit is clear gives 0, and num > den some number.
// One pair a cycle, twelve cycles, never stalls. en_i[k] says that stage k + 1 takes an item in this cycle.
// Ten multipliers of 27x18 for a DenW of 26 or less, 13 for one of 32; a memory of 2^9 words.
// Method: Newton's step on a table's reciprocal (Flynn, 1970), the remainder's sign for the last bit (Markstein, 1990).
// Model: div_nearest of cpp_model/math/div_pipe.hpp, equal bit for bit.
module div_pair
  import castray_cfg_pkg::*;
#(
  parameter int unsigned DenW  = 26,
  parameter int unsigned QFrac = 24
) (
  input  logic                   clk_i,

  input  logic [11:0]           en_i,
  input  logic [1:0] [DenW-1:0] num_i,
  input  logic [DenW-1:0]       den_i,
  output logic [1:0] [QFrac:0]  q_o
);
  if (QFrac < 12 || QFrac > 26 || DenW < QFrac + 2 || DenW > 45) begin : g_width
    $error("div_pair: QFrac must be 12 to 26, DenW QFrac + 2 to 45");
  end
  localparam int unsigned GuessW  = RecipW;                     // bits of r
  localparam int unsigned Shift   = DenW + GuessW - 1 - QFrac;  // x and t count in 2^-Shift of q's last bit
  localparam int unsigned Spare   = 3;                          // bits of x below q's last
  localparam int unsigned GDrop   = (DspAW - 1) + DspBW - 3 + (GuessW - 1) - QFrac - Spare;   // bits of g below those
  localparam int unsigned CheckW  = DenW + 2;
  localparam int unsigned HeadW   = CheckW - QFrac - 1;         // bits of v that num 2^(QFrac+1) reaches
  localparam int unsigned MiddleW = (QFrac + 2 > DspBW) ? QFrac + 2 : DspBW;   // mul_low takes no fewer
  typedef logic [DenW-1:0]        op_t;
  typedef logic [DenW+GuessW-1:0] product_t;
  typedef logic [CheckW-1:0]      check_t;
  typedef logic [QFrac:0]         quotient_t;

  // Unsigned by signed.
  function automatic logic signed [DspAW+DspBW-1:0] times(logic [DspAW-2:0] a, logic signed [DspBW-1:0] b);
    logic signed [DspAW-1:0] positive;
    positive = {1'b0, a};
    return positive * b;
  endfunction

  logic [GuessW-1:0] guess;
  op_t               den_q [10];
  op_t               num_q [2] [10];
  logic              none_q;

  recip_guess #(.DenW(DenW)) u_guess (.clk_i, .en_i(en_i[3:0]), .den_i, .guess_o(guess));

  always_ff @(posedge clk_i) begin
    if (en_i[0]) den_q[0] <= den_i;
    for (int unsigned i = 1; i < 10; i++) if (en_i[i]) den_q[i] <= den_q[i-1];
    if (en_i[10]) none_q <= !den_q[9][DenW-1];
  end

  // ---- How far r is off: the product's lower bits as a signed number ----
  product_t                den_guess;
  logic [CheckW+DspBW-1:0] off;
  logic signed [DspBW-1:0] off6;
  mul_guess #(.W(DenW)) u_off (.clk_i, .en_i(en_i[5:4]), .a_i(den_q[3]), .guess_i(guess), .p_o(den_guess));
  assign off  = {den_guess[CheckW-1:0], DspBW'(0)};
  assign off6 = off[CheckW+DspBW-1 -: DspBW];

  for (genvar i = 0; i < 2; i++) begin : g_quotient
    always_ff @(posedge clk_i) begin
      if (en_i[0]) num_q[i][0] <= num_i[i];
      for (int unsigned k = 1; k < 10; k++) if (en_i[k]) num_q[i][k] <= num_q[i][k-1];
    end

    // ---- The estimate ----
    product_t                      t, t7_q;
    logic [DenW+GuessW+DspAW-2:0]  wide;
    logic signed [DspAW+DspBW-1:0] g_q;
    logic [QFrac+Spare:0]          x;
    quotient_t                     q8_q, q9_q, q10_q, q11_q;
    mul_guess #(.W(DenW)) u_t (.clk_i, .en_i(en_i[5:4]), .a_i(num_q[i][3]), .guess_i(guess), .p_o(t));
    assign wide = {t, (DspAW-1)'(0)};
    assign x    = (QFrac+Spare+1)'(t7_q >> (Shift - Spare)) - (QFrac+Spare+1)'(g_q >>> GDrop);

    // ---- The middle between it and the next ----
    logic [MiddleW-1:0] middle;
    check_t             v_q;
    quotient_t          tail;
    logic [HeadW-1:0]   head, gap;
    logic               past_q;
    assign middle = MiddleW'({q8_q, 1'b1});
    mul_low #(.AW(MiddleW), .BW(DenW), .OutW(CheckW)) u_check (
      .clk_i, .en_i(en_i[9:8]), .a_i(middle), .b_i(den_q[7]), .p_o(v_q)
    );
    assign {head, tail} = v_q;
    assign gap = num_q[i][9][HeadW-1:0] - head - HeadW'(tail != '0);

    always_ff @(posedge clk_i) begin
      if (en_i[6]) begin
        t7_q <= t;
        g_q  <= times(wide[DenW+GuessW+DspAW-2 -: DspAW-1], off6);
      end
      if (en_i[7]) q8_q <= x[QFrac+Spare:Spare];
      if (en_i[8]) q9_q <= q8_q;
      if (en_i[9]) q10_q <= q9_q;
      if (en_i[10]) begin
        q11_q  <= q10_q;
        past_q <= !gap[HeadW-1];
      end
      if (en_i[11]) begin
        if (none_q) q_o[i] <= '0;
        else q_o[i] <= q11_q + quotient_t'(past_q);
      end
    end
  end
endmodule
