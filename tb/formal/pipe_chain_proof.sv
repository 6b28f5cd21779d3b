// SPDX-License-Identifier: Apache-2.0
// prim/pipe_chain, its payloads held as its users hold them: stage i takes what is before it at load_o[i].
// Prove: k=1 Stages=1
// Prove: k=1 Stages=3
// Prove: k=1 Stages=8
// Cover: 20
module pipe_chain_proof #(
  parameter int unsigned Stages = 3,
  parameter int unsigned Width  = 8,
  localparam type        data_t = logic [Width-1:0]
) (
  input logic  clk_i,
  input logic  rst_ni,
  input logic  choose_i,
  input logic  valid_i,
  input data_t data_i,
  input logic  ready_i
);
  localparam int unsigned CntW = $clog2(Stages + 2);
  logic              ready_o, valid_o;
  logic [Stages-1:0] load_o;
  pipe_chain #(.Stages(Stages)) u_dut (.*);
  reset_first u_reset (.*);

  logic [Stages:0][Width-1:0] data;    // before each stage, and behind the last
  data_t [Stages-1:0] data_q;
  assign data = {data_q, data_i};
  always_ff @(posedge clk_i) for (int unsigned i = 0; i < Stages; i++) if (load_o[i]) data_q[i] <= data[i];
  stream_held #(.data_t(data_t)) u_out (.clk_i, .rst_ni, .valid_i(valid_o), .ready_i, .data_i(data_q[Stages-1]));

  logic [CntW-1:0] inner, ahead;
  logic            follows;
  data_t           item;
  stream_follow #(.data_t(data_t), .Most(Stages)) u_follow (
    .clk_i, .rst_ni, .choose_i, .push_i(valid_i && ready_o), .in_i(data_i),
    .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(data_q[Stages-1]),
    .inside_o(inner), .follows_o(follows), .ahead_o(ahead), .item_o(item)
  );

  // The stage that the followed item is in, and for how many cycles it has been inner.
  logic [CntW-1:0] at_q, age_q;
  logic            moves;
  always_comb begin
    moves = 1'b0;
    for (int unsigned i = 1; i < Stages; i++) if (at_q == CntW'(i - 1)) moves = load_o[i];
  end
  always_ff @(posedge clk_i) begin
    if (!follows) begin
      at_q  <= '0;
      age_q <= '0;
    end else begin
      at_q <= at_q + CntW'(moves);
      if (age_q != CntW'(Stages)) age_q <= age_q + 1'b1;
    end
  end

  logic [CntW-1:0] full, past;   // stages that hold an item; those of them that the followed one comes to
  logic            closed, kept;   // none of these is empty; the followed item is in its stage
  always_comb begin
    full   = '0;
    past   = '0;
    closed = 1'b1;
    kept   = 1'b0;
    for (int unsigned i = 0; i < Stages; i++) begin
      full = full + CntW'(u_dut.valid_q[i]);
      if (CntW'(i) == at_q) kept = u_dut.valid_q[i] && data_q[i] == item;
      if (CntW'(i) > at_q) begin
        past   = past + CntW'(u_dut.valid_q[i]);
        closed = closed && u_dut.valid_q[i];
      end
    end
  end

  always_comb begin
    if (rst_ni) begin
      takes_while_room: assert (ready_o == (inner != CntW'(Stages) || ready_i));
      if (follows && age_q >= CntW'(Stages - 1)) offered_in_time: assert (valid_o);
      loads_only_items: assert ((load_o & ~{u_dut.valid_q, valid_i}) == '0);
      inv_count: assert (full == inner);
      if (follows) begin
        inv_place: assert (at_q < CntW'(Stages) && past == ahead && age_q <= CntW'(Stages));
        inv_item: assert (kept);
        inv_age: assert (age_q <= at_q || closed);
      end
      c_full: cover (inner == CntW'(Stages) && valid_i && !ready_i);
      c_last_leaves: cover (inner == CntW'(1) && follows && valid_o && ready_i && age_q == CntW'(Stages));
    end
  end
endmodule
