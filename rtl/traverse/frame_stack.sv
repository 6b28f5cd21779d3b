// SPDX-License-Identifier: Apache-2.0
// The stacks of a lane's contexts, in block RAM. A frame holds the children of one node that a ray
// left behind, up to three, near to far, from e0 up; RefNone ends it.
//   s0  look_i: the top frame of a context is read; look_new_i: it starts with an empty stack
//   s1  top_o (undefined on an empty stack), empty_o, full_o; and at most one of
//       push_i, replace_i (the top frame), drop_i (the top frame)
// One look a cycle. A context is not looked at while it is in s1.
// Model: cpp_model/traverse/frame_stack.hpp.
module frame_stack
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  parameter int unsigned Depth    = StackFrames,   // of a context
  localparam int unsigned IdxW    = (Contexts > 1) ? $clog2(Contexts) : 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  input  logic            look_i,
  input  logic [IdxW-1:0] look_ctx_i,
  input  logic            look_new_i,

  output frame_t          top_o,
  output logic            empty_o,
  output logic            full_o,
  input  logic            push_i,
  input  logic            replace_i,
  input  logic            drop_i,
  input  frame_t          frame_i
);
  if (Depth < 2 || (Depth & (Depth - 1)) != 0) begin : g_check
    $error("frame_stack: Depth must be a power of two, 2 or more");
  end

  localparam int unsigned PlaceW = $clog2(Depth);
  typedef logic [PlaceW-1:0] place_t;
  typedef logic [PlaceW:0]   used_t;

  (* ram_style = "block" *) frame_t frame_q [Depth << IdxW];
  used_t                            used_mem_q [Contexts];   // frames on each stack

  // ---- s0 ----
  used_t           used, used_q;
  frame_t          top_q;
  logic [IdxW-1:0] ctx_q;

  assign used = look_new_i ? '0 : used_mem_q[look_ctx_i];
  always_ff @(posedge clk_i) begin
    if (look_i) begin
      ctx_q  <= look_ctx_i;
      used_q <= used;
      top_q  <= frame_q[{look_ctx_i, place_t'(used - 1'b1)}];
    end
  end

  // ---- s1 ----
  logic  looked_q;
  used_t used_d;
  assign top_o   = top_q;
  assign empty_o = used_q == '0;
  assign full_o  = used_q == used_t'(Depth);
  assign used_d  = push_i ? used_q + 1'b1 : drop_i ? used_q - 1'b1 : used_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) looked_q <= 1'b0;
    else looked_q <= look_i;
  end
  always_ff @(posedge clk_i) begin
    if (looked_q) used_mem_q[ctx_q] <= used_d;
    if (push_i || replace_i) frame_q[{ctx_q, push_i ? place_t'(used_q) : place_t'(used_q - 1'b1)}] <= frame_i;
  end
endmodule
