// SPDX-License-Identifier: Apache-2.0
// The work counters of a job, in the order of castray_reg_pkg::Cnt*. The events of a cycle, one bit
// each (of a lane, of a port, or one alone), are summed, registered, then added: a count is right two
// cycles after its event. A counter is CountW bits wide and reads as 64.
module counters
  import castray_reg_pkg::*;
#(
  parameter int unsigned CountW = 48
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  logic                  clear_i,             // one cycle: all to zero
  input  logic [EventBits-1:0]  events_i [Counters],
  output logic [63:0]           counts_o [Counters]
);
  if (CountW < 8 || CountW > 64) begin : g_check
    $error("counters: CountW must be 8 to 64");
  end

  localparam int unsigned SumW = $clog2(EventBits + 1);
  typedef logic [SumW-1:0] sum_t;

  function automatic sum_t ones(logic [EventBits-1:0] events);
    ones = '0;
    for (int unsigned i = 0; i < EventBits; i++) ones += sum_t'(events[i]);
  endfunction

  sum_t              step_q  [Counters];
  logic [CountW-1:0] count_q [Counters];

  for (genvar i = 0; i < Counters; i++) begin : g_step
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) step_q[i] <= '0;
      else if (step_q[i] != '0 || events_i[i] != '0) step_q[i] <= ones(events_i[i]);
    end
  end

  for (genvar i = 0; i < Counters; i++) begin : g_count
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) count_q[i] <= '0;
      else if (step_q[i] != '0) count_q[i] <= count_q[i] + CountW'(step_q[i]);
    end
    assign counts_o[i] = 64'(count_q[i]);
  end
endmodule
