// SPDX-License-Identifier: Apache-2.0
// Guarded division, q = num 2^QFrac / den, for num <= den: to the nearest, halves upwards, or, with
// Nearest 0, rounded down.
//   s1..sn    BitsPerStage quotient bits each, restoring, digit by digit: QFrac + 1 bits, the first
//             is the integer bit, and one more for rounding to the nearest
//   s(n+1)    rounding
// Defined otherwise too: a zero divisor gives 0, num > den gives 2^QFrac.
// One division a cycle, n + 1 cycles; all stages move together unless the output is blocked.
// Model: cpp_model/math/div_pipe.hpp, equal bit for bit.
module div_pipe #(
  parameter int unsigned NumW         = 32,
  parameter int unsigned QFrac        = 26,
  parameter int unsigned BitsPerStage = 2,
  parameter bit          Nearest      = 1'b1,
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

  localparam int unsigned Bits   = QFrac + 1 + 32'(Nearest);
  localparam int unsigned Stages = (Bits + BitsPerStage - 1) / BitsPerStage;

  typedef logic [NumW-1:0] op_t;
  typedef logic [Bits-1:0] quo_t;
  typedef struct packed {
    op_t  rem;
    quo_t quo;
  } step_t;

  // Quotient bits first..first+BitsPerStage-1. The integer bit compares the remainder as it is,
  // each later one its double.
  function automatic step_t divide(step_t from, op_t den, int unsigned first);
    logic [NumW:0] rem;
    logic          digit;
    quo_t          quo;
    rem = {1'b0, from.rem};
    quo = from.quo;
    for (int unsigned i = 0; i < BitsPerStage; i++) begin
      if (first + i < Bits) begin
        if (first + i > 0) rem = {rem[NumW-1:0], 1'b0};
        digit = rem >= {1'b0, den};
        quo   = {quo[Bits-2:0], digit};
        if (digit) rem = rem - {1'b0, den};
      end
    end
    return '{rem: rem[NumW-1:0], quo: quo};
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

  // The guard: a zero divisor divides 0 by 1, a numerator that is too large divides 1 by 1.
  op_t num, den;
  assign den = (in_den_i == '0 || in_num_i > in_den_i) ? op_t'(1) : in_den_i;
  assign num = (in_den_i == '0) ? '0 : (in_num_i > in_den_i) ? op_t'(1) : in_num_i;

  for (genvar i = 0; i < Stages; i++) begin : g_stage
    step_t from, step_q;
    op_t   den_in;
    tag_t  tag_in, tag_q;
    if (i == 0) begin : g_first
      assign from   = '{rem: num, quo: '0};
      assign den_in = den;
      assign tag_in = in_tag_i;
    end else begin : g_next
      assign from   = g_stage[i-1].step_q;
      assign den_in = g_stage[i-1].g_den.den_q;
      assign tag_in = g_stage[i-1].tag_q;
    end
    if (i < Stages - 1) begin : g_den
      op_t den_q;
      always_ff @(posedge clk_i) begin
        if (work) begin
          if (offered[i]) begin
            step_q <= divide(from, den_in, i * BitsPerStage);
            tag_q  <= tag_in;
            den_q  <= den_in;
          end
        end
      end
    end else begin : g_last
      always_ff @(posedge clk_i) begin
        if (work) begin
          if (offered[i]) begin
            step_q <= divide(from, den_in, i * BitsPerStage);
            tag_q  <= tag_in;
          end
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (move && offered[Stages]) begin
      out_q_o   <= Nearest ? (QFrac+1)'((g_stage[Stages-1].step_q.quo + 1'b1) >> 1)
                           : (QFrac+1)'(g_stage[Stages-1].step_q.quo);
      out_tag_o <= g_stage[Stages-1].tag_q;
    end
  end

  assign out_valid_o = valid_q[Stages];
endmodule
