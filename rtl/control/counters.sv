// SPDX-License-Identifier: Apache-2.0
// The work counters of a job, in the order of castray_reg_pkg::Cnt*. The events of a cycle, one bit
// each (of a lane, of a port, or one alone), are summed, registered, then added: a count is right two
// cycles after its event. A counter is CountW bits wide and reads as 64.
//   low bits     of each counter registers; a carry out of them waits
//   upper bits   of all counters a memory. Each cycle is one counter's turn: its carry is added there
// A counter's turn comes once in Counters cycles, and no second carry comes in as many. The cycle behind
// its turn number_o names it and count_o is its count, as of the turn.
module counters
  import castray_reg_pkg::*;
#(
  parameter int unsigned CountW = 48
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  logic                        clear_i,             // one cycle: all to zero
  input  logic [EventBits-1:0]        events_i [Counters],
  output logic [$clog2(Counters)-1:0] number_o,
  output logic [63:0]                 count_o
);
  localparam int unsigned SumW = $clog2(EventBits + 1);
  localparam int unsigned LowW = $clog2(EventBits * Counters);
  if (CountW <= LowW || CountW > 64) begin : g_check
    $error("counters: CountW must be %0d to 64", LowW + 1);
  end
  if (2 ** $clog2(Counters) != Counters) begin : g_turns
    $error("counters: Counters must be a power of two, as the turns go round");
  end
  typedef logic [SumW-1:0]             sum_t;
  typedef logic [LowW-1:0]             low_t;
  typedef logic [CountW-LowW-1:0]      upper_t;
  typedef logic [$clog2(Counters)-1:0] number_t;

  // ---- Low bits ----
  number_t             turn_q;
  low_t                low [Counters];
  logic [Counters-1:0] carry;
  for (genvar i = 0; i < Counters; i++) begin : g_counter
    sum_t          step_q;
    low_t          low_q;
    logic          carry_q;
    logic [LowW:0] next;
    assign next = (LowW + 1)'(low_q) + (LowW + 1)'(step_q);
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) begin
        step_q <= '0;
        low_q  <= '0;
      end else if (step_q != '0 || events_i[i] != '0) begin
        step_q <= sum_t'($countones(events_i[i]));
        low_q  <= next[LowW-1:0];
      end
    end
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) carry_q <= 1'b0;
      else if (next[LowW]) carry_q <= 1'b1;
      else if (turn_q == number_t'(i)) carry_q <= 1'b0;
    end
    assign low[i]   = low_q;
    assign carry[i] = carry_q;
  end

  // ---- Upper bits, for a round behind a clear zero ----
  upper_t              upper_q [Counters];
  upper_t              upper;
  logic [Counters-1:0] zero_q;   // from bit 0 on: the cycles that are left of that round
  number_t             number_q;
  logic [CountW-1:0]   count_q;
  assign upper    = (zero_q[0] ? '0 : upper_q[turn_q]) + upper_t'(carry[turn_q]);
  assign number_o = number_q;
  assign count_o  = 64'(count_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) zero_q <= '1;
    else zero_q <= zero_q >> 1;
    if (!rst_ni) turn_q <= '0;
    else turn_q <= turn_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    upper_q[turn_q] <= upper;
    number_q        <= turn_q;
    count_q         <= {upper, low[turn_q]};
  end
endmodule
