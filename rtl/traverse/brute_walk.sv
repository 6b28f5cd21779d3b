// SPDX-License-Identifier: Apache-2.0
// Brute force: every ray against every primitive. The lanes fill their contexts with rays, then
// each primitive is held still while the contexts of all lanes pass by it, one a cycle and lane;
// then the lanes give out their hits. One fetched primitive serves every ray in flight, so no
// lane needs a copy of the primitives.
//   Fill   lanes take rays, until all are full or no more can come
//   Run    for each primitive, for each context: one test in every lane
//   Drain  the last tests and divisions finish
//   Emit   lanes give their hits
// A primitive with its n tests takes n cycles; a batch adds the pipes' length and Emit.
// Model: cpp_model/traverse/lane.hpp (the loop over primitives), where the order of tests does not matter.
module brute_walk
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Lanes = DefaultLanes
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  // Rays to come.
  input  logic             exhausted_i,
  input  logic             starved_i,  // none can come before hits have left: tiles wait for them
  // Contexts in use of the first lane, which has the most, and the state of all lanes.
  input  logic [CtxW:0]    used_i,
  input  logic [Lanes-1:0] full_i,
  input  logic [Lanes-1:0] quiet_i,    // no test or division under way
  input  logic [Lanes-1:0] empty_i,    // no context in use
  output logic             fill_o,
  output logic             emit_o,

  // The primitive buffer, once a batch.
  output logic             reader_start_o,
  input  logic             reader_done_i,
  input  logic             prim_valid_i,
  output logic             prim_ready_o,
  input  prim_slot_t       prim_i,

  // The test broadcast to all lanes.
  output logic             test_valid_o,
  input  logic [Lanes-1:0] test_ready_i,
  output ctx_t             test_ctx_o,
  output prim_slot_t       test_prim_o,

  output logic             idle_o,
  output logic             batch_o,        // counter events
  output logic             test_stall_o,
  output logic             fetch_stall_o
);
  typedef enum logic [1:0] {Fill, Run, Drain, Emit} phase_t;
  phase_t     phase_q;
  logic       held_q;      // a primitive is held
  prim_slot_t prim_q;
  ctx_t       ctx_q;
  logic       step, last;

  assign fill_o = phase_q == Fill;
  assign emit_o = phase_q == Emit;
  assign idle_o = phase_q == Fill && exhausted_i && &empty_i;

  assign test_valid_o = held_q;
  assign test_ctx_o   = ctx_q;
  assign test_prim_o  = prim_q;
  assign step         = held_q && &test_ready_i;
  assign last         = {1'b0, ctx_q} + 1'b1 == used_i;
  assign prim_ready_o = phase_q == Run && (!held_q || (step && last));

  logic start;
  assign start          = phase_q == Fill && !(&empty_i) && (&full_i || exhausted_i || starved_i);
  assign reader_start_o = start;
  assign batch_o        = start;
  assign test_stall_o   = held_q && !step;
  assign fetch_stall_o  = phase_q == Run && !held_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      phase_q <= Fill;
      held_q  <= 1'b0;
      ctx_q   <= '0;
    end else begin
      unique case (phase_q)
        Fill:    if (start) phase_q <= Run;
        Run:     if (reader_done_i && !held_q) phase_q <= Drain;
        Drain:   if (&quiet_i) phase_q <= Emit;
        default: if (&empty_i) phase_q <= Fill;
      endcase
      if (prim_ready_o) held_q <= prim_valid_i;
      if (step) ctx_q <= last ? '0 : ctx_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (prim_ready_o && prim_valid_i) prim_q <= prim_i;
  end
endmodule
