// SPDX-License-Identifier: Apache-2.0
// The contract of a stream, rtl/prim/stream_check.sv, for a prover: an item that is offered and not
// taken is offered again, unchanged. Assumed of what drives the unit, asserted of the unit.
module stream_held #(
  parameter type data_t = logic,
  parameter bit  Assumed = 1'b0
) (
  input logic  clk_i,
  input logic  rst_ni,

  input logic  valid_i,
  input logic  ready_i,
  input data_t data_i
);
  logic  waits_q;   // an item was left waiting
  data_t data_q;
  always_ff @(posedge clk_i) begin
    waits_q <= rst_ni && valid_i && !ready_i;
    data_q  <= data_i;
  end

  logic kept;
  assign kept = valid_i && data_i == data_q;
  if (Assumed) begin : g_assume
    always_comb if (rst_ni && waits_q) held: assume (kept);
  end else begin : g_assert
    always_comb if (rst_ni && waits_q) stable_while_waiting: assert (kept);
  end
endmodule
