// SPDX-License-Identifier: Apache-2.0
// p = a0 b0 + a1 b1 + a2 b2 + Round, signed, exact, without handshake: stage i moves at load_i[i].
// Three DSPs in a chain, each taking its operands a stage later than the one before:
//        product 0   product 1   product 2
//   s0   A, B        -           -
//   s1   M           A, B        -
//   s2   P = M+Round M           A, B
//   s3               P = P0 + M  M
//   s4                           P = P1 + M
// Model: int64 arithmetic.
module dot3
  import castray_cfg_pkg::*;
#(
  parameter int unsigned AW    = DspAW,   // at most a DSP each
  parameter int unsigned BW    = DspBW,
  parameter int unsigned Round = 0,       // added to the sum: a half, where the parent rounds
  localparam int unsigned PW   = AW + BW + 2
) (
  input  logic                 clk_i,

  input  logic [4:0]           load_i,
  input  logic signed [AW-1:0] a0_i,
  input  logic signed [BW-1:0] b0_i,
  input  logic signed [AW-1:0] a1_i,
  input  logic signed [BW-1:0] b1_i,
  input  logic signed [AW-1:0] a2_i,
  input  logic signed [BW-1:0] b2_i,
  output logic signed [PW-1:0] p_o
);
  if (AW > DspAW || BW > DspBW) begin : g_check
    $error("dot3: a DSP multiplies at most %0d by %0d bits", DspAW, DspBW);
  end

  typedef logic signed [AW-1:0]    a_t;
  typedef logic signed [BW-1:0]    b_t;
  typedef logic signed [AW+BW-1:0] product_t;
  typedef logic signed [PW-1:0]    sum_t;

  a_t       a0_q, a1_wait_q, a1_q, a2_wait0_q, a2_wait1_q, a2_q;
  b_t       b0_q, b1_wait_q, b1_q, b2_wait0_q, b2_wait1_q, b2_q;
  product_t m0_q, m1_q, m2_q;
  sum_t     p0_q, p1_q, p2_q;

  always_ff @(posedge clk_i) begin
    if (load_i[0]) begin
      a0_q       <= a0_i;
      b0_q       <= b0_i;
      a1_wait_q  <= a1_i;
      b1_wait_q  <= b1_i;
      a2_wait0_q <= a2_i;
      b2_wait0_q <= b2_i;
    end
    if (load_i[1]) begin
      m0_q       <= product_t'(a0_q) * product_t'(b0_q);
      a1_q       <= a1_wait_q;
      b1_q       <= b1_wait_q;
      a2_wait1_q <= a2_wait0_q;
      b2_wait1_q <= b2_wait0_q;
    end
    if (load_i[2]) begin
      p0_q <= sum_t'(m0_q) + sum_t'(Round);
      m1_q <= product_t'(a1_q) * product_t'(b1_q);
      a2_q <= a2_wait1_q;
      b2_q <= b2_wait1_q;
    end
    if (load_i[3]) begin
      p1_q <= p0_q + sum_t'(m1_q);
      m2_q <= product_t'(a2_q) * product_t'(b2_q);
    end
    if (load_i[4]) p2_q <= p1_q + sum_t'(m2_q);
  end

  assign p_o = p2_q;
endmodule
