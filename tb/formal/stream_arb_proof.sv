// SPDX-License-Identifier: Apache-2.0
// prim/stream_arb: what is given is one input's item, taken from that input alone; and it is fair: while an
// input waits, each other is served once at most, so N - 1 items go before its own.
// Prove: k=1 N=3
// Prove: k=1 N=5
// Cover: 12
// Fast
module stream_arb_proof #(
  parameter int unsigned N     = 5,
  parameter int unsigned Width = 8,
  localparam type        data_t = logic [Width-1:0],
  localparam int unsigned IdxW = (N > 1) ? $clog2(N) : 1
) (
  input logic                    clk_i,
  input logic                    rst_ni,
  input logic [N-1:0]            valid_i,
  input logic [N-1:0][Width-1:0] data_i,
  input logic                    ready_i
);
  localparam int unsigned CntW = $clog2(2 * N + 1);
  typedef logic [CntW-1:0] count_t;
  logic [N-1:0]    ready_o;
  data_t           data [N];
  logic            valid_o;
  data_t           data_o;
  logic [IdxW-1:0] index_o;
  for (genvar i = 0; i < N; i++) begin : g_in
    assign data[i] = data_i[i];
    stream_held #(.data_t(data_t), .Assumed(1'b1)) u_held (
      .clk_i, .rst_ni, .valid_i(valid_i[i]), .ready_i(ready_o[i]), .data_i(data_i[i])
    );
  end
  stream_arb #(.data_t(data_t), .N(N)) u_dut (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i(data), .valid_o, .ready_i, .data_o, .index_o
  );
  reset_first u_reset (.*);
  typedef struct packed {
    logic [IdxW-1:0] index;
    data_t           data;
  } out_t;
  stream_held #(.data_t(out_t)) u_out (
    .clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i('{index: index_o, data: data_o})
  );

  logic [N-1:0] taken, later;
  assign taken = valid_i & ready_o;
  assign later = ~u_dut.early_q;
  always_comb begin
    if (rst_ni) begin
      nothing_lost: assert (valid_o == (valid_i != '0));
      if (valid_o) begin
        nothing_invented: assert (32'(index_o) < N && valid_i[index_o]);
        nothing_changed: assert (data_o == data_i[index_o]);
        from_one_input: assert (taken == (ready_i ? N'(1) << index_o : '0));
      end
      inv_early: assert ((later & (later + 1'b1)) == '0);   // from some input on
    end
  end

  // Items given while input i waits; and how many inputs come before its turn.
  for (genvar i = 0; i < N; i++) begin : g_fair
    count_t before_q, turn;
    assign turn = count_t'(i) - count_t'($countones(later)) + (later[i] ? count_t'(N) : '0);
    always_ff @(posedge clk_i) begin
      if (!rst_ni || !valid_i[i] || taken[i]) before_q <= '0;
      else if (valid_o && ready_i) before_q <= before_q + 1'b1;
    end
    always_comb begin
      if (rst_ni) begin
        if (valid_i[i]) fair: assert (before_q <= count_t'(N - 1));
        if (valid_i[i]) inv_turn: assert (before_q + turn <= count_t'(N - 1));
        else inv_none: assert (before_q == '0);
      end
    end
  end
  always_comb begin
    if (rst_ni && taken[0]) c_waits_longest: cover (g_fair[0].before_q == count_t'(N - 1));
  end
endmodule
