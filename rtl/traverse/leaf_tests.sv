// SPDX-License-Identifier: Apache-2.0
// The tests of leaves. A leaf is a line of two slots, whose primitives are tested one after the
// other; an empty slot, and the primitive that the ray ignores, are no test. A number that is not
// below primitives_i is ErrPrimitive, and its context gets nothing.
//   line  -> test    one a cycle, from a register
//   over_i           tests end in any order, one of those that were missed and one of the others
//                    in a cycle; the latter wait in a queue where both come
//   leaf_o           the last test of a context's leaf is over, or it had none
// A context has one leaf under way. A leaf without a test waits for a cycle in which no test ends.
// Model: cpp_model/traverse/leaf_tests.hpp, equal bit for bit.
module leaf_tests
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [31:0] primitives_i,    // numbers are below it

  input  logic        line_valid_i,
  output logic        line_ready_o,
  input  ctx_t        line_ctx_i,
  input  line_data_t  line_i,
  input  prim_t       ignore_i,        // of line_ctx_i's ray

  output logic        test_valid_o,
  input  logic        test_ready_i,
  output ctx_t        test_ctx_o,
  output prim_slot_t  test_prim_o,

  input  logic [1:0]  over_i,          // 0: missed, 1: divided
  input  ctx_t        over_ctx_i [2],

  output logic        leaf_valid_o,
  output ctx_t        leaf_ctx_o,
  output error_t      fault_o
);
  localparam int unsigned IdxW = (Contexts > 1) ? $clog2(Contexts) : 1;

  // ---- From a line to its tests ----
  typedef struct packed {
    ctx_t       ctx;
    prim_slot_t prim;
  } test_t;
  prim_slot_t slot0, slot1;
  logic [1:0] some, illegal, test;
  logic       wrong, none, both, second_q, issue, issued;

  assign {slot1, slot0} = line_i;
  always_comb begin
    some    = '0;
    illegal = '0;
    test    = '0;
    if (line_valid_i) begin
      some    = {slot1.number != NoPrim, slot0.number != NoPrim};
      illegal = some & {32'(slot1.number) >= primitives_i, 32'(slot0.number) >= primitives_i};
      test    = some & {slot1.number != ignore_i, slot0.number != ignore_i};
    end
  end
  assign wrong   = line_valid_i && illegal != '0;
  assign none    = line_valid_i && illegal == '0 && test == '0;
  assign both    = &test;
  assign fault_o = wrong ? ErrPrimitive : ErrNone;

  pipe_stage #(.data_t(test_t)) u_test (
    .clk_i, .rst_ni,
    .valid_i(issue), .ready_o(issued),
    .data_i('{ctx: line_ctx_i, prim: (second_q || !test[0]) ? slot1 : slot0}),
    .valid_o(test_valid_o), .ready_i(test_ready_i), .data_o({test_ctx_o, test_prim_o})
  );
  assign issue = line_valid_i && illegal == '0 && test != '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (issue && issued) second_q <= both && !second_q;
  end

  // ---- One end a cycle ----
  logic divided_valid, none_over, over, pair, half;
  ctx_t divided_ctx, over_ctx;

  stream_fifo #(.data_t(ctx_t), .Depth(2 * Contexts)) u_divided (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(&over_i), .ready_o(), .data_i(over_ctx_i[1]),
    .valid_o(divided_valid), .ready_i(over_i == '0), .data_o(divided_ctx)
  );
  assign over         = over_i != '0 || divided_valid;
  assign none_over    = none && !over;
  assign over_ctx     = over_i[0] ? over_ctx_i[0] : over_i[1] ? over_ctx_i[1] : divided_ctx;
  assign line_ready_o = wrong || none_over || (issue && issued && (!both || second_q));

  // pair_q: the leaf has two tests. half_q: one of the two is over.
  logic [Contexts-1:0] half_q;
  logic                pair_q [Contexts];
  assign pair = pair_q[IdxW'(over_ctx)];
  assign half = half_q[IdxW'(over_ctx)];

  always_ff @(posedge clk_i) begin
    if (issue && issued) pair_q[IdxW'(line_ctx_i)] <= both;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) half_q <= '0;
    else if (over && pair) half_q <= half_q ^ (Contexts'(1) << IdxW'(over_ctx));
  end

  assign leaf_valid_o = over ? !pair || half : none_over;
  assign leaf_ctx_o   = over ? over_ctx : line_ctx_i;
endmodule
