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

  for (genvar i = 0; i < Counters; i++) begin : g_counter
    sum_t              step_q;
    logic [CountW-1:0] count_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_i) begin
        step_q  <= '0;
        count_q <= '0;
      end else if (step_q != '0 || events_i[i] != '0) begin
        step_q  <= sum_t'($countones(events_i[i]));
        count_q <= count_q + CountW'(step_q);
      end
    end
    assign counts_o[i] = 64'(count_q);
  end
endmodule
