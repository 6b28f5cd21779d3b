// SPDX-License-Identifier: Apache-2.0
// Assumes that the first cycle is one of reset. Later ones may be, too: a proof holds behind any reset.
module reset_first (
  input logic clk_i,
  input logic rst_ni
);
  logic first_q = 1'b1;
  always_ff @(posedge clk_i) first_q <= 1'b0;
  always_comb if (first_q) begin_in_reset: assume (!rst_ni);
endmodule
