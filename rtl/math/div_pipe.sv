// SPDX-License-Identifier: Apache-2.0
// Guarded division to the nearest: q = num 2^QFrac / den, halves upwards, for num <= den.
//   s1..sn    BitsPerStage quotient bits each, restoring, digit by digit: QFrac + 2 bits, the
//             first is the integer bit, the last is for rounding
//   s(n+1)    rounding
// Defined otherwise too: a zero divisor gives 0, num > den gives 2^QFrac.
// One division a cycle, n + 1 cycles; all stages move together unless the output is blocked.
// Model: cpp_model/math/divide.hpp, equal bit for bit.
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
  typedef struct packed {
    op_t  rem;
    quo_t quo;
  } step_t;

  // Quotient bits first..first+BitsPerStage-1. The integer bit compares the remainder as it is,
  // each later one its double.
  function automatic step_t divide(op_t rem, quo_t quo, op_t den, int unsigned first);
    logic [NumW:0] r;
    r = {1'b0, rem};
    divide.quo = quo;
    for (int unsigned i = first; i < first + BitsPerStage && i < Bits; i++) begin
      if (i > 0) r = {r[NumW-1:0], 1'b0};
      divide.quo = {divide.quo[Bits-2:0], r >= {1'b0, den}};
      if (r >= {1'b0, den}) r = r - {1'b0, den};
    end
    divide.rem = r[NumW-1:0];
  endfunction

  logic [Stages:0] valid_q;
  op_t             den_q [Stages];
  step_t           step_q [Stages];
  tag_t            tag_q [Stages];
  logic            move;

  assign move       = !valid_q[Stages] || out_ready_i;
  assign in_ready_o = move;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (move) valid_q <= {valid_q[Stages-1:0], in_valid_i};
  end

  // The guard: a zero divisor divides 0 by 1, a numerator that is too large divides 1 by 1.
  op_t num, den;
  assign den = (in_den_i == '0 || in_num_i > in_den_i) ? op_t'(1) : in_den_i;
  assign num = (in_den_i == '0) ? '0 : (in_num_i > in_den_i) ? op_t'(1) : in_num_i;

  always_ff @(posedge clk_i) begin
    if (move && in_valid_i) begin
      step_q[0] <= divide(num, '0, den, 0);
      den_q[0]  <= den;
      tag_q[0]  <= in_tag_i;
    end
  end
  for (genvar i = 1; i < Stages; i++) begin : g_stage
    always_ff @(posedge clk_i) begin
      if (move && valid_q[i-1]) begin
        step_q[i] <= divide(step_q[i-1].rem, step_q[i-1].quo, den_q[i-1], i * BitsPerStage);
        den_q[i]  <= den_q[i-1];
        tag_q[i]  <= tag_q[i-1];
      end
    end
  end

  logic [QFrac:0] q_q;
  tag_t           q_tag_q;
  always_ff @(posedge clk_i) begin
    if (move && valid_q[Stages-1]) begin
      q_q     <= (QFrac+1)'((step_q[Stages-1].quo + 1'b1) >> 1);
      q_tag_q <= tag_q[Stages-1];
    end
  end

  assign out_valid_o = valid_q[Stages];
  assign out_q_o     = q_q;
  assign out_tag_o   = q_tag_q;
endmodule
