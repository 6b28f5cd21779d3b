// SPDX-License-Identifier: Apache-2.0
// prim/block_fifo: Depth places and an output register; an item is offered two cycles after it entered if none is
// ahead of it.
// Prove: k=1 Depth=2
// Prove: k=1 Depth=5
// Cover: 40
module block_fifo_proof #(
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
  localparam int unsigned CntW = $clog2(Depth + 3);
  localparam int unsigned PtrW = $clog2(Depth);
  logic  ready_o, valid_o, empty_o;
  data_t data_o;
  block_fifo #(.data_t(data_t), .Depth(Depth)) u_dut (.*);
  reset_first u_reset (.*);
  stream_held #(.data_t(data_t)) u_out (.clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i(data_o));

  logic [CntW-1:0] inner, ahead, used;
  logic            follows;
  data_t           item;
  stream_follow #(.data_t(data_t), .Most(Depth + 1)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(valid_i && ready_o), .in_i(data_i),
    .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(data_o),
    .inside_o(inner), .follows_o(follows), .ahead_o(ahead), .item_o(item)
  );
  assign used = CntW'(u_dut.used_q);

  // The place that is `more` behind another.
  function automatic logic [PtrW-1:0] behind(logic [PtrW-1:0] place, logic [CntW-1:0] more);
    logic [CntW:0] sum;
    sum = (CntW+1)'(place) + (CntW+1)'(more);
    return PtrW'((sum >= (CntW+1)'(Depth)) ? sum - (CntW+1)'(Depth) : sum);
  endfunction

  always_comb begin
    if (rst_ni) begin
      nothing_lost: assert (inner == used + CntW'(valid_o) && (valid_o || inner == '0 || u_dut.fetch));
      empty_says_so: assert (empty_o == (inner == '0));
      takes_while_room: assert (ready_o == (used != CntW'(Depth)));
      inv_used: assert (used <= CntW'(Depth));
      inv_places: assert ((CntW+1)'(u_dut.head_q) < (CntW+1)'(Depth) && u_dut.tail_q == behind(u_dut.head_q, used));
      if (follows && (!valid_o || ahead != '0))
        inv_item: assert (u_dut.mem_q[behind(u_dut.head_q, ahead - CntW'(valid_o))] == item);
      c_full: cover (inner == CntW'(Depth + 1) && valid_i);
      c_last_leaves: cover (follows && ahead == '0 && inner == CntW'(1) && ready_i && valid_o && u_dut.head_q == '0);
    end
  end
endmodule
