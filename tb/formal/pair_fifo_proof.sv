// SPDX-License-Identifier: Apache-2.0
// prim/pair_fifo: each of its inputs is a queue of its own. An item's top bit says by which input it came, which
// the unit does not look at; so items of one input can be told at the output.
// Prove: k=1 Depth=2
// Prove: k=1 Depth=3
// Cover: 24
module pair_fifo_proof #(
  parameter int unsigned Depth = 3,
  parameter int unsigned Width = 5,
  localparam type        data_t = logic [Width-1:0]
) (
  input logic                  clk_i,
  input logic                  rst_ni,
  input logic [1:0]            choose_i,
  input logic [1:0]            valid_i,
  input logic [1:0][Width-2:0] data_i,
  input logic                  ready_i
);
  localparam int unsigned CntW = $clog2(Depth + 2);
  localparam int unsigned PtrW = $clog2(Depth);
  logic [1:0] ready_o;
  logic       valid_o;
  data_t      data [2], data_o;
  assign data = '{{1'b0, data_i[0]}, {1'b1, data_i[1]}};
  pair_fifo #(.data_t(data_t), .Depth(Depth)) u_dut (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i(data), .valid_o, .ready_i, .data_o
  );
  reset_first u_reset (.*);
  stream_held #(.data_t(data_t)) u_out (.clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i(data_o));

  function automatic logic [PtrW-1:0] behind(logic [PtrW-1:0] place, logic [CntW-1:0] more);
    logic [CntW:0] sum;
    sum = (CntW+1)'(place) + (CntW+1)'(more);
    return PtrW'((sum >= (CntW+1)'(Depth)) ? sum - (CntW+1)'(Depth) : sum);
  endfunction

  logic [1:0][CntW-1:0] inner;
  logic                 out_side;
  assign out_side = data_o[Width-1];
  for (genvar i = 0; i < 2; i++) begin : g_side
    logic [CntW-1:0] ahead;
    logic            follows;
    data_t           item;
    stream_follow #(.data_t(data_t), .Most(Depth)) u_follow (
      .clk_i, .rst_ni, .choose_i(choose_i[i]), .push_i(valid_i[i] && ready_o[i]), .in_i(data[i]),
      .out_valid_i(valid_o && out_side == 1'(i)), .out_ready_i(ready_i), .out_i(data_o),
      .inside_o(inner[i]), .follows_o(follows), .ahead_o(ahead), .item_o(item)
    );
    // Items of the other side that left while the one in front of this side waits.
    logic [1:0] before_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni || inner[i] == '0 || (valid_o && ready_i && out_side == 1'(i))) before_q <= '0;
      else if (valid_o && ready_i && before_q != '1) before_q <= before_q + 1'b1;
    end

    logic [PtrW-1:0] head;
    logic            own;   // all items in the queue are of this side
    assign head = u_dut.g_fifo[i].u_fifo.head_q;
    always_comb begin
      own = 1'b1;
      for (int unsigned n = 0; n < Depth; n++)
        if (CntW'(n) < inner[i] && u_dut.g_fifo[i].u_fifo.mem_q[behind(head, CntW'(n))][Width-1] != 1'(i)) own = 1'b0;
    end
    always_comb begin
      if (rst_ni) begin
        takes_while_room: assert (ready_o[i] == (inner[i] != CntW'(Depth)));
        fair: assert (before_q <= 2'd1);
        inv_used: assert (CntW'(u_dut.g_fifo[i].u_fifo.used_q) == inner[i]);
        inv_places: assert ((CntW+1)'(head) < (CntW+1)'(Depth) && u_dut.g_fifo[i].u_fifo.tail_q == behind(head, inner[i]));
        inv_own: assert (own);
        if (follows) inv_item: assert (u_dut.g_fifo[i].u_fifo.mem_q[behind(head, ahead)] == item);
        if (before_q != '0) inv_turn: assert ((u_dut.u_arb.early_q == 2'b10) == (i == 1) && inner[i] != '0);
        c_last_leaves: cover (follows && ahead == '0 && inner[i] == CntW'(1) && valid_o && ready_i &&
                              out_side == 1'(i) && head == PtrW'(Depth - 1));
      end
    end
  end

  always_comb begin
    if (rst_ni) begin
      nothing_lost: assert (valid_o == (inner != '0));
      inv_early: assert (u_dut.u_arb.early_q != 2'b01);
      c_full: cover (ready_o == '0 && valid_i == '1);
    end
  end
endmodule
