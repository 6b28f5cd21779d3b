// SPDX-License-Identifier: Apache-2.0
// Square root of a normalised radicand by hyperbolic CORDIC in vectoring mode (Walther, "A unified
// algorithm for elementary functions", 1971): a fixed number of shifts and adds, no multiplier.
// rad, 26 bits, in [2^24, 2^26); root = sqrt(rad) in Q13.5. A rad below 2^24 gives 0.
//   s1          x = rad + C    y = rad - C                           exact
//   s2..s12     x -= y >> i    y -= x >> i    where y < 0: +=        >> rounds down
//               i = 1, 2, 3, 4, 4, 5, 6, 7, 8, 9, 10: 4 is repeated, or the steps do not converge
//   s13         root = round(x / 2^8), halves upwards, at most 2^18 - 1
// The steps turn (x, y) to y = 0 and leave x = K sqrt(x^2 - y^2) = 2 K sqrt(C rad) with
// K^2 = the product of 1 - 4^-i. C = 2^24 / K^2 makes that 2^13 sqrt(rad): no product at the end.
// |atanh(y / x)| = |ln(rad / C)| / 2 is below 0.51; the steps reach 1.12. What is left of the angle
// is below 2^-10 and adds at most 2^-21 of the root, an eighth of the last place; roundings below
// 2^8 add less than that. The root is within 3/4 of the last place, where it saturates within 1.
// One root a cycle, 13 cycles; all stages move together unless the output is blocked.
// Model: cpp_model/math/cordic_sqrt.hpp, equal bit for bit; its test covers every radicand.
module cordic_sqrt
  import castray_cfg_pkg::*;
#(
  parameter type tag_t = logic [7:0],
  localparam int unsigned RadW  = RootRadW,
  localparam int unsigned RootW = RadW / 2 + RootFrac
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [RadW-1:0]  in_rad_i,
  input  tag_t             in_tag_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [RootW-1:0] out_root_o,
  output tag_t             out_tag_o
);
  if (RadW != 26 || RootFrac != 5) begin : g_check
    $error("cordic_sqrt: its steps are counted for RootRadW 26 and RootFrac 5");
  end

  localparam int unsigned Steps = CordicSteps;
  localparam int unsigned Drop  = RadW - RootW;    // fraction bits of x that the root has not
  typedef logic signed [RadW+1:0] reach_t;
  localparam reach_t Start = reach_t'(CordicStart);

  typedef struct packed {
    reach_t x;   // below 1.4 * 2^26, never negative
    reach_t y;
  } turn_t;

  // A radicand that is not normalised starts, and so stays, at x = y = 0.
  function automatic turn_t first(logic [RadW-1:0] rad);
    if (rad[RadW-1 -: 2] == '0) return '0;
    first.x = {2'b0, rad} + Start;
    first.y = {2'b0, rad} - Start;
  endfunction

  // a - b, or a + b where add: one subtracter, of one bit more for the carry in.
  function automatic reach_t minus(reach_t a, reach_t b, logic add);
    logic signed [$bits(reach_t):0] sum;
    sum = {a, 1'b0} - {b ^ {$bits(reach_t){add}}, add};
    return sum[$bits(reach_t):1];
  endfunction

  function automatic turn_t step(turn_t from, int unsigned shift);
    reach_t dx, dy;
    dx = from.y >>> shift;
    dy = from.x >>> shift;
    step.x = minus(from.x, dx, from.y < 0);
    step.y = minus(from.y, dy, from.y < 0);
  endfunction

  function automatic logic [RootW-1:0] rounded(reach_t x);
    logic [RadW+1-Drop:0] root;
    root = (RadW+2-Drop)'((x + reach_t'(1 << (Drop - 1))) >> Drop);
    return (root[RadW+1-Drop:RootW] != '0) ? '1 : root[RootW-1:0];
  endfunction

  logic [Steps+1:0] valid_q;
  logic             move, work;   // work: some stage takes a root

  assign move       = !valid_q[Steps+1] || out_ready_i;
  assign work       = move && valid_q[Steps:0] != '0;
  assign in_ready_o = move;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (move) valid_q <= {valid_q[Steps:0], in_valid_i};
  end

  for (genvar k = 0; k <= Steps; k++) begin : g_turn
    turn_t turn_q;
    tag_t  tag_q;
    if (k == 0) begin : g_first
      always_ff @(posedge clk_i) begin
        if (move && in_valid_i) begin
          turn_q <= first(in_rad_i);
          tag_q  <= in_tag_i;
        end
      end
    end else begin : g_step
      always_ff @(posedge clk_i) begin
        if (work) begin
          if (valid_q[k-1]) begin
            turn_q <= step(g_turn[k-1].turn_q, (k <= CordicRepeat) ? k : k - 1);
            tag_q  <= g_turn[k-1].tag_q;
          end
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (move && valid_q[Steps]) begin
      out_root_o <= rounded(g_turn[Steps].turn_q.x);
      out_tag_o  <= g_turn[Steps].tag_q;
    end
  end

  assign out_valid_o = valid_q[Steps+1];
endmodule
