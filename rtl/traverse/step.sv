// SPDX-License-Identifier: Apache-2.0
// Where each context of the hierarchy goes next. A context has one thing under way: a node, a leaf
// or a decision here. So whatever comes is taken, and nothing can overflow. A decision:
//   children found     to the nearest; the others are left behind, near to far, as a frame on the
//                      context's stack
//   none (a node whose boxes are all missed, a leaf, a ray that starts nowhere)
//                      to the top frame's first entry, which leaves the frame. If it lies beyond
//                      the reach, so do those behind it: the frame is dropped, and the context
//                      decides again
//   empty stack, or stop_i     the context is done
// A level of the hierarchy leaves at most one frame, so a stack of StackDepth frames is enough for
// as many levels; one more is ErrStack, one node more than limit_i is ErrSteps. Such a context ends
// without done.
//   s0  chosen: children of a node, else who decides again, else a leaf, else a new ray
//   s1  decided: at reach_i and stop_i of ask_ctx_o
//   s2  noted: who decides again, the size of the stack, and fault_o
// One decision a cycle; an output belongs into a queue, where it is seen two cycles after its cause, and what
// follows from it comes a cycle later or more.
// Model: cpp_model/traverse/step.hpp, equal bit for bit.
module step
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts   = DefaultContexts,
  parameter int unsigned StackDepth = StackFrames
) (
  input  logic    clk_i,
  input  logic    rst_ni,
  input  steps_t  limit_i,

  input  logic    start_valid_i,   // a new ray
  output logic    start_ready_o,
  input  ctx_t    start_ctx_i,
  input  start_t  start_i,

  input  logic    node_valid_i,    // a node's children
  input  ctx_t    node_ctx_i,
  input  visits_t node_i,

  input  logic    leaf_valid_i,    // the tests of a leaf are over
  input  ctx_t    leaf_ctx_i,

  output ctx_t    ask_ctx_o,
  input  dist_t   reach_i,         // entries beyond its nearest hit are not visited
  input  logic    stop_i,          // it has a hit, and any will do

  output ctx_t    out_ctx_o,
  output logic    node_valid_o,    // to a node, in memory or of a tile
  output logic    leaf_valid_o,    // to a leaf
  output ref_t    out_ref_o,
  output logic    done_valid_o,
  output error_t  fault_o,

  input  ctx_t    count_ctx_i,
  output steps_t  count_o          // nodes that it visited and that are over
);
  localparam int unsigned IdxW       = (Contexts > 1) ? $clog2(Contexts) : 1;
  localparam int unsigned QueueDepth = (Contexts > 1) ? Contexts : 2;
  localparam ref_t   Nowhere   = '{kind: RefNone, index: '0};

  // ---- Who waits for a decision: leaves that are not decided at once, and contexts whose frame was dropped ----
  logic again_q, again_valid, again_ready, leaf_valid, leaf_ready, leaf_now;
  ctx_t again_ctx_q, again_ctx, leaf_ctx;

  stream_fifo #(.data_t(ctx_t), .Depth(QueueDepth)) u_again (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(again_q), .ready_o(), .data_i(again_ctx_q),
    .valid_o(again_valid), .ready_i(again_ready), .data_o(again_ctx)
  );
  stream_fifo #(.data_t(ctx_t), .Depth(QueueDepth)) u_leaves (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(leaf_valid_i && !leaf_now), .ready_o(), .data_i(leaf_ctx_i),
    .valid_o(leaf_valid), .ready_i(leaf_ready), .data_o(leaf_ctx)
  );

  // ---- s0 ----
  typedef struct packed {
    ctx_t ctx;
    logic fresh;      // a new ray
    logic node;       // comes from a node
  } choice_t;
  choice_t s0, s1_q;
  visits_t visits_q;  // of s1
  logic    s0_valid, s1_valid_q;

  assign again_ready   = !node_valid_i;
  assign leaf_ready    = again_ready && !again_valid;
  assign leaf_now      = leaf_ready && !leaf_valid;
  assign start_ready_o = leaf_now && !leaf_valid_i;
  assign s0_valid      = node_valid_i || again_valid || leaf_valid || leaf_valid_i || start_valid_i;

  always_comb begin
    s0 = '{ctx: start_ctx_i, fresh: 1'b1, node: 1'b0};
    if (node_valid_i) s0 = '{ctx: node_ctx_i, fresh: 1'b0, node: 1'b1};
    else if (again_valid) s0 = '{ctx: again_ctx, fresh: 1'b0, node: 1'b0};
    else if (leaf_valid) s0 = '{ctx: leaf_ctx, fresh: 1'b0, node: 1'b0};
    else if (leaf_valid_i) s0 = '{ctx: leaf_ctx_i, fresh: 1'b0, node: 1'b0};
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_valid_q <= 1'b0;
    else s1_valid_q <= s0_valid;
  end
  always_ff @(posedge clk_i) begin
    if (s0_valid) begin
      s1_q     <= s0;
      visits_q <= node_i;
      if (!node_valid_i) begin   // what is not visited has no target; the rest of it is not read
        visits_q.e0.target      <= s0.fresh ? start_i.first : Nowhere;
        visits_q.e1             <= '{least: '0, target: s0.fresh ? start_i.second : Nowhere};
        visits_q.e2.target.kind <= RefNone;
        visits_q.e3.target.kind <= RefNone;
      end
    end
  end

  // ---- s1 ----
  frame_t  top;
  logic    empty, full, forward, leave, pop, beyond, last, finish, overflow, leaf, spent, go;
  steps_t  nodes, nodes_q [Contexts];
  ref_t    target;

  // top.e0.least > reach_i, as the carry of a sum. Of all here it is known last.
  logic [DistW:0] both;
  assign both   = {1'b0, top.e0.least} + {1'b0, ~reach_i};
  assign beyond = both[DistW];

  assign ask_ctx_o = s1_q.ctx;
  always_comb begin
    {forward, leave, finish, pop, last, overflow, leaf, spent} = '0;
    target = Nowhere;
    nodes  = '0;
    if (s1_valid_q) begin
      forward  = visits_q.e0.target.kind != RefNone;
      leave    = forward && visits_q.e1.target.kind != RefNone;   // others are left behind
      finish   = !forward && (empty || stop_i);
      pop      = !forward && !finish;
      last     = top.e1.target.kind == RefNone;                    // the frame's only entry
      overflow = leave && full;
      target   = forward ? visits_q.e0.target : top.e0.target;
      leaf     = target.kind == RefLeaf;
      if (!s1_q.fresh) nodes = nodes_q[IdxW'(s1_q.ctx)] + steps_t'(s1_q.node);
      spent    = nodes >= limit_i;
    end
    go = forward ? !overflow : pop && !beyond;
  end

  frame_stack #(.Contexts(Contexts), .Depth(StackDepth)) u_stack (
    .clk_i, .rst_ni,
    .look_i(s0_valid), .look_ctx_i(IdxW'(s0.ctx)), .look_new_i(s0.fresh),
    .top_o(top), .empty_o(empty), .full_o(full),
    .push_i(leave && !full), .replace_i(pop && !last), .drop_i(pop && (beyond || last)),
    .frame_i({visits_q.e3, leave ? {visits_q.e2, visits_q.e1} : {top.e2, top.e1}})   // without children there is no e3
  );

  assign count_o = nodes_q[IdxW'(count_ctx_i)];
  always_ff @(posedge clk_i) begin
    if (s1_valid_q) nodes_q[IdxW'(s1_q.ctx)] <= nodes;
  end

  assign out_ctx_o    = s1_q.ctx;
  assign out_ref_o    = target;
  assign node_valid_o = go && !leaf && !spent;
  assign leaf_valid_o = go && leaf;
  assign done_valid_o = finish;

  // ---- s2 ----
  logic went_q, overflow_q, spent_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {again_q, went_q, overflow_q} <= '0;
    else {again_q, went_q, overflow_q} <= {pop && beyond, go, overflow};
  end
  always_ff @(posedge clk_i) begin
    if (s1_valid_q) begin
      again_ctx_q <= s1_q.ctx;
      spent_q     <= !leaf && spent;
    end
  end
  assign fault_o = overflow_q ? ErrStack : (went_q && spent_q) ? ErrSteps : ErrNone;
endmodule
