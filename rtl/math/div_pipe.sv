// SPDX-License-Identifier: Apache-2.0
// Guarded division, q = num 2^QFrac / den to the nearest, halves upwards, for num <= den.
//   s1..sn    BitsPerStage quotient bits each, without restoring: where a remainder is negative, its
//             bit is 0 and the next step adds the divisor instead of subtracting it. QFrac + 1 bits, the
//             first is the integer bit, and one more for rounding to the nearest
//   s(n+1)    rounding
// Defined otherwise too: num > den gives 2^QFrac, and a zero divisor 0: all its bits are one, and rounding wraps.
// One division a cycle, n + 1 cycles; all stages move together unless the output is blocked.
// Model: cpp_model/math/div_pipe.hpp, equal bit for bit.
module div_pipe #(
  parameter int unsigned NumW         = 32,
  parameter int unsigned QFrac        = 26,
  parameter int unsigned BitsPerStage = 2,
  parameter type         tag_t        = logic [7:0]
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [NumW-1:0]  in_num_i,
  input  logic [NumW-1:0]  in_den_i,
  input  tag_t             in_tag_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [QFrac:0]   out_q_o,
  output tag_t             out_tag_o
);
  if (NumW < 2 || NumW > 62 || QFrac < 1 || QFrac > 62) begin : g_width
    $error("div_pipe: NumW must be 2 to 62 and QFrac 1 to 62");
  end
  if (BitsPerStage < 1 || BitsPerStage > 8) begin : g_bits
    $error("div_pipe: BitsPerStage must be 1 to 8");
  end

  localparam int unsigned Bits   = QFrac + 2;
  localparam int unsigned Stages = (Bits + BitsPerStage - 1) / BitsPerStage;

  typedef logic [NumW-1:0] op_t;
  typedef logic [Bits-1:0] quo_t;
  // Of a remainder, which lies between -den and den, the bits below its sign: that is the inverse of
  // the quotient's last bit.
  typedef struct packed {
    op_t  rem;
    quo_t quo;
  } step_t;

  // Quotient bits first..first+BitsPerStage-1. The integer bit is that of num - den, each later one that
  // of twice the remainder, less the divisor or more: a subtracter of one bit more for the carry in, whose
  // minuend is a register, so that a bit of it is one LUT. What is left of a num of den or more is nothing.
  function automatic step_t divide(step_t from, op_t den, int unsigned first);
    logic [NumW:0] rem;
    logic          digit, unused;
    op_t           low;
    quo_t          quo;
    low   = from.rem;
    quo   = from.quo;
    digit = quo[0];
    for (int unsigned i = 0; i < BitsPerStage; i++) begin
      if (first + i == 0) begin
        rem   = {1'b0, low} - {1'b0, den};
        digit = !rem[NumW];
        low   = digit ? '0 : rem[NumW-1:0];
        quo   = {quo[Bits-2:0], digit};
      end else if (first + i < Bits) begin
        {rem, unused} = {low, 2'b00} - {{1'b0, den} ^ {(NumW + 1){!digit}}, !digit};
        digit = !rem[NumW];
        low   = rem[NumW-1:0];
        quo   = {quo[Bits-2:0], digit};
      end
    end
    return '{rem: low, quo: quo};
  endfunction

  logic [Stages:0] valid_q, offered;  // what a stage holds, and is offered
  logic            move, work;        // work: some stage takes a division

  assign offered    = {valid_q[Stages-1:0], in_valid_i};
  assign work       = move && offered != '0;
  assign move       = !valid_q[Stages] || out_ready_i;
  assign in_ready_o = move;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (move) valid_q <= offered;
  end

  for (genvar i = 0; i < Stages; i++) begin : g_stage
    step_t from, step_q;
    op_t   den_in;
    tag_t  tag_in, tag_q;
    if (i == 0) begin : g_first
      assign from    = '{rem: in_num_i, quo: '0};
      assign den_in  = in_den_i;
      assign tag_in  = in_tag_i;
    end else begin : g_next
      assign from    = g_stage[i-1].step_q;
      assign den_in  = g_stage[i-1].g_den.den_q;
      assign tag_in  = g_stage[i-1].tag_q;
    end
    always_ff @(posedge clk_i) begin
      if (work) begin
        if (offered[i]) begin
          step_q <= divide(from, den_in, i * BitsPerStage);
          tag_q  <= tag_in;
        end
      end
    end
    if (i < Stages - 1) begin : g_den
      op_t den_q;
      always_ff @(posedge clk_i) begin
        if (work) begin
          if (offered[i]) den_q <= den_in;
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (move && offered[Stages]) begin
      out_q_o   <= (QFrac+1)'((g_stage[Stages-1].step_q.quo + 1'b1) >> 1);
      out_tag_o <= g_stage[Stages-1].tag_q;
    end
  end

  assign out_valid_o = valid_q[Stages];
endmodule
