// SPDX-License-Identifier: Apache-2.0
// The contract of a stream: an item that is offered and not taken is offered again, unchanged.
// For simulation only: the stream primitives hold one for each stream that they drive, and
// sim/stream_checks.sv binds one to each stream between the units of the core.
module stream_check #(
  parameter type data_t = logic
) (
  input logic  clk_i,
  input logic  rst_ni,

  input logic  valid_i,
  input logic  ready_i,
  input data_t data_i
);
`ifndef SYNTHESIS
  keeps_item: assert property (
    @(posedge clk_i) disable iff (!rst_ni)
    valid_i && !ready_i |=> valid_i && $stable(data_i)
  ) else $error("an untaken item was dropped or changed");
`endif
endmodule
