// SPDX-License-Identifier: Apache-2.0
// The work counters of a job, in the order of castray_reg_pkg::Cnt*. Events are summed over the
// lanes, registered, then added: a count is right two cycles after its event.
// A counter is CountW bits wide and reads as 64.
module counters
  import castray_cfg_pkg::*;
  import castray_reg_pkg::*;
#(
  parameter int unsigned Lanes  = DefaultLanes,
  parameter int unsigned CountW = 48
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             clear_i,        // one cycle: all to zero
  input  logic             running_i,      // cycles are counted while high

  input  logic [Lanes-1:0] test_i,
  input  logic [Lanes-1:0] ray_i,
  input  logic [Lanes-1:0] hit_i,
  input  logic [Lanes-1:0] candidate_i,
  input  logic             batch_i,
  input  logic             test_stall_i,
  input  logic             fetch_stall_i,
  input  logic             attr_hit_i,
  input  logic             attr_miss_i,
  input  logic             read_beat_i,
  input  logic             write_beat_i,

  output logic [63:0]      counts_o [Counters]
);
  if (CountW < 8 || CountW > 64) begin : g_check
    $error("counters: CountW must be 8 to 64");
  end

  localparam int unsigned SumW = $clog2(Lanes + 1);
  typedef logic [SumW-1:0] sum_t;

  function automatic sum_t ones(logic [Lanes-1:0] events);
    ones = '0;
    for (int unsigned i = 0; i < Lanes; i++) ones += sum_t'(events[i]);
  endfunction

  sum_t              step_q  [Counters];
  logic [CountW-1:0] count_q [Counters];

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      for (int unsigned i = 0; i < Counters; i++) step_q[i] <= '0;
    end else begin
      step_q[CntCycles]      <= sum_t'(running_i);
      step_q[CntTests]       <= ones(test_i);
      step_q[CntRays]        <= ones(ray_i);
      step_q[CntHits]        <= ones(hit_i);
      step_q[CntCandidates]  <= ones(candidate_i);
      step_q[CntBatches]     <= sum_t'(batch_i);
      step_q[CntTestStalls]  <= sum_t'(test_stall_i);
      step_q[CntFetchStalls] <= sum_t'(fetch_stall_i);
      step_q[CntAttrHits]    <= sum_t'(attr_hit_i);
      step_q[CntAttrMisses]  <= sum_t'(attr_miss_i);
      step_q[CntReadBeats]   <= sum_t'(read_beat_i);
      step_q[CntWriteBeats]  <= sum_t'(write_beat_i);
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
