// SPDX-License-Identifier: Apache-2.0
// prim/stream_fork: every output gets each item once, and the item is taken when all have it.
// Prove: k=1 N=2
// Prove: k=1 N=5
// Cover: 12
module stream_fork_proof #(
  parameter int unsigned N = 2
) (
  input logic         clk_i,
  input logic         rst_ni,
  input logic         valid_i,
  input logic [N-1:0] ready_i
);
  logic         ready_o;
  logic [N-1:0] valid_o;
  stream_fork #(.N(N)) u_dut (.*);
  reset_first u_reset (.*);
  stream_held #(.Assumed(1'b1)) u_in (.clk_i, .rst_ni, .valid_i, .ready_i(ready_o), .data_i(1'b0));
  for (genvar i = 0; i < N; i++) begin : g_out
    stream_held u_held (.clk_i, .rst_ni, .valid_i(valid_o[i]), .ready_i(ready_i[i]), .data_i(1'b0));
  end

  logic [N-1:0] got_q, gets;   // outputs that have the item offered now; those that get it in this cycle
  assign gets = valid_o & ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) got_q <= '0;
    else if (valid_i) got_q <= ready_o ? '0 : got_q | gets;
  end

  always_comb begin
    if (rst_ni) begin
      nothing_invented: assert (valid_i || valid_o == '0);
      never_twice: assert ((gets & got_q) == '0);
      if (valid_i) nothing_lost: assert ((got_q | valid_o) == '1);
      if (valid_i) taken_when_all_have_it: assert (ready_o == ((got_q | gets) == '1));
      inv_has: assert (u_dut.has_q == got_q);
      if (!valid_i) inv_between: assert (got_q == '0);
      c_one_by_one: cover (valid_i && ready_o && got_q[N-1:1] == '1 && !got_q[0]);
    end
  end
endmodule
