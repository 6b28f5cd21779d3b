// SPDX-License-Identifier: Apache-2.0
// One component of a pixel's direction, without handshake: stage i moves at load_i[i].
//   s0  products of a and b with the low 26 and the high 18 bits of the steps (27x18 each)
//   s1  low sum, high sum
//   s2  dir = ahead + a right + b up                       exact, Q3.42
// Model: cpp_model/camera/ray_gen.hpp, equal bit for bit.
module ray_component
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic                clk_i,
  input  logic [2:0]          load_i,

  input  offset_t   a_i,
  input  offset_t   b_i,
  input  dir_step_t           ahead_i,
  input  dir_step_t           right_i,
  input  dir_step_t           up_i,

  output dir_comp_t           dir_o
);
  localparam int unsigned StepW = $bits(dir_step_t);
  localparam int unsigned LowW  = DspAW - 1;       // unsigned, with a zero above
  localparam int unsigned HighW = StepW - LowW;
  if (HighW > DspAW) begin : g_check
    $error("ray_component: a step must have at most %0d bits", LowW + DspAW);
  end

  typedef logic signed [LowW+13:0]      low_t;
  typedef logic signed [HighW+12:0]     high_t;
  typedef logic signed [LowW+14:0]      low_sum_t;
  typedef logic signed [StepW-LowW+13:0] high_sum_t;

  function automatic low_t mul_low(offset_t k, dir_step_t step);
    logic signed [LowW:0] low;
    low = {1'b0, step[LowW-1:0]};
    return low_t'(k) * low_t'(low);
  endfunction
  function automatic high_t mul_high(offset_t k, dir_step_t step);
    logic signed [HighW-1:0] high;
    high = step[StepW-1:LowW];
    return high_t'(k) * high_t'(high);
  endfunction
  function automatic low_sum_t sum_low(low_t p, low_t q, dir_step_t step);
    return low_sum_t'(p) + low_sum_t'(q) + low_sum_t'({1'b0, step[LowW-1:0]});
  endfunction
  function automatic high_sum_t sum_high(high_t p, high_t q, dir_step_t step);
    logic signed [HighW-1:0] high;
    high = step[StepW-1:LowW];
    return high_sum_t'(p) + high_sum_t'(q) + high_sum_t'(high);
  endfunction
  function automatic dir_comp_t join_sums(low_sum_t low, high_sum_t high);
    return dir_comp_t'({high, {LowW{1'b0}}}) + dir_comp_t'(low);
  endfunction

  low_t      right_low_q, up_low_q;
  high_t     right_high_q, up_high_q;
  low_sum_t  low_q;
  high_sum_t high_q;
  dir_comp_t dir_q;

  always_ff @(posedge clk_i) begin
    if (load_i[0]) begin
      right_low_q  <= mul_low(a_i, right_i);
      right_high_q <= mul_high(a_i, right_i);
      up_low_q     <= mul_low(b_i, up_i);
      up_high_q    <= mul_high(b_i, up_i);
    end
    if (load_i[1]) begin
      low_q  <= sum_low(right_low_q, up_low_q, ahead_i);
      high_q <= sum_high(right_high_q, up_high_q, ahead_i);
    end
    if (load_i[2]) dir_q <= join_sums(low_q, high_q);
  end

  assign dir_o = dir_q;
endmodule
