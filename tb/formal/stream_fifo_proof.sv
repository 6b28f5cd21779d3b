// SPDX-License-Identifier: Apache-2.0
// prim/stream_fifo: Depth places; an item is offered the cycle after it entered if none is ahead of it.
// Prove: k=1 Depth=2
// Prove: k=1 Depth=5
// Prove: k=1 Depth=16
// Cover: 40
// Fast
module stream_fifo_proof #(
  parameter int unsigned Depth = 5,
  parameter int unsigned Width = 8,
  localparam type        data_t = logic [Width-1:0]
) (
  input logic  clk_i,
  input logic  rst_ni,
  input logic  choose_i,
  input logic  valid_i,
  input data_t data_i,
  input logic  ready_i
);
  localparam int unsigned CntW = $clog2(Depth + 2);
  localparam int unsigned PtrW = $clog2(Depth);
  logic  ready_o, valid_o;
  data_t data_o;
  logic [$clog2(Depth+1)-1:0] used_o;
  stream_fifo #(.data_t(data_t), .Depth(Depth)) u_dut (.*);
  reset_first u_reset (.*);
  stream_held #(.data_t(data_t)) u_out (.clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i(data_o));

  logic [CntW-1:0] inner, ahead;
  logic            follows;
  data_t           item;
  stream_follow #(.data_t(data_t), .Most(Depth)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(valid_i && ready_o), .in_i(data_i),
    .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(data_o),
    .inside_o(inner), .follows_o(follows), .ahead_o(ahead), .item_o(item)
  );

  // The place that is `more` behind another.
  function automatic logic [PtrW-1:0] behind(logic [PtrW-1:0] place, logic [CntW-1:0] more);
    logic [CntW:0] sum;
    sum = (CntW+1)'(place) + (CntW+1)'(more);
    return PtrW'((sum >= (CntW+1)'(Depth)) ? sum - (CntW+1)'(Depth) : sum);
  endfunction

  always_comb begin
    if (rst_ni) begin
      nothing_lost: assert (valid_o == (inner != '0));
      takes_while_room: assert (ready_o == (inner != CntW'(Depth)));
      counts: assert (CntW'(used_o) == inner);
      inv_places: assert ((CntW+1)'(u_dut.head_q) < (CntW+1)'(Depth) && u_dut.tail_q == behind(u_dut.head_q, inner));
      if (follows) inv_item: assert (u_dut.mem_q[behind(u_dut.head_q, ahead)] == item);
      c_full: cover (inner == CntW'(Depth) && valid_i);
      c_last_leaves: cover (follows && ahead == '0 && inner == CntW'(1) && ready_i && u_dut.head_q == PtrW'(Depth - 1));
    end
  end
endmodule
