// SPDX-License-Identifier: Apache-2.0
// prim/free_list: its user gives back only what it holds; then no number has two holders, and a number is
// offered whenever one is free.
// Prove: k=1 N=1
// Prove: k=1 N=3
// Prove: k=1 N=4
// Cover: 24
module free_list_proof #(
  parameter int unsigned N = 4,
  localparam int unsigned IdxW = (N > 1) ? $clog2(N) : 1
) (
  input logic            clk_i,
  input logic            rst_ni,
  input logic            take_i,
  input logic            give_i,
  input logic [IdxW-1:0] number_i
);
  localparam int unsigned Depth = (N > 1) ? N : 2;
  localparam int unsigned PtrW  = $clog2(Depth);
  localparam int unsigned CntW  = $clog2(Depth + 1) + 1;
  typedef logic [CntW-1:0] count_t;
  logic            valid_o;
  logic [IdxW-1:0] number_o;
  free_list #(.N(N)) u_dut (.*);
  reset_first u_reset (.*);

  logic [N-1:0] held_q, held;
  always_comb begin
    held = held_q;
    if (take_i) held[number_o] = 1'b1;
    if (give_i) held[number_i] = 1'b0;
  end
  always_ff @(posedge clk_i) held_q <= rst_ni ? held : '0;

  // Which numbers wait in the queue, how often, and how many are held.
  count_t       holders, used;
  logic [N-1:0] waits, twice, taken;
  logic [PtrW-1:0] at;
  always_comb begin
    holders = '0;
    for (int unsigned i = 0; i < N; i++) holders = holders + count_t'(held_q[i]);
    used  = count_t'(u_dut.u_back.used_q);
    waits = '0;
    for (int unsigned n = 0; n < N; n++) taken[n] = n < 32'(u_dut.fresh_q);
    twice = '0;
    at    = u_dut.u_back.head_q;
    for (int unsigned i = 0; i < Depth; i++) begin
      if (count_t'(i) < used) begin
        for (int unsigned n = 0; n < N; n++) begin
          if (u_dut.u_back.mem_q[at] == IdxW'(n)) begin
            twice[n] = twice[n] || waits[n];
            waits[n] = 1'b1;
          end
        end
      end
      at = (32'(at) == Depth - 1) ? '0 : at + 1'b1;
    end
  end
  function automatic logic [PtrW-1:0] behind(logic [PtrW-1:0] place, count_t more);
    logic [CntW:0] sum;
    sum = (CntW+1)'(place) + (CntW+1)'(more);
    return PtrW'((sum >= (CntW+1)'(Depth)) ? sum - (CntW+1)'(Depth) : sum);
  endfunction

  always_comb begin
    if (rst_ni) begin
      takes_what_is_offered: assume (!take_i || valid_o);
      gives_what_it_holds: assume (!give_i || (32'(number_i) < N && held_q[number_i]));
      if (valid_o) one_holder_each: assert (32'(number_o) < N && !held_q[number_o]);
      none_lost: assert (valid_o == (held_q != '1));
      if (give_i) room_for_what_returns: assert (u_dut.u_back.ready_o);
      inv_fresh: assert (32'(u_dut.fresh_q) <= N && used + holders == count_t'(u_dut.fresh_q));
      inv_places: assert (32'(u_dut.u_back.head_q) < Depth && u_dut.u_back.tail_q == behind(u_dut.u_back.head_q, used));
      inv_where: assert (twice == '0 && waits == (taken & ~held_q) && (held_q & ~taken) == '0);
      c_all_held: cover (held_q == '1);
      c_all_back: cover (held_q == '0 && 32'(u_dut.fresh_q) == N);
    end
  end
endmodule
