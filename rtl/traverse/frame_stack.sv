// SPDX-License-Identifier: Apache-2.0
// The stacks of a lane's contexts, in block RAM. A frame holds the children of one node that a ray
// left behind, up to three, near to far, from e0 up; RefNone ends it.
//   s0  look_i: the top frame of a context is read; look_new_i: it starts with an empty stack
//   s1  top_o (undefined on an empty stack), empty_o, full_o; and push_i, or replace_i (the top frame),
//       or drop_i (the top frame, also one that is replaced)
//   s2  the stack's new size is written
// One look a cycle. A context is not looked at while it is in s1 or s2.
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
  typedef logic [PlaceW:0]   at_t;     // the top frame's place; Empty is the one before place 0
  localparam at_t Empty = '1;

  (* ram_style = "block" *) frame_t frame_q [Depth << IdxW];
  at_t                              at_mem_q [Contexts];

  // ---- s0 ----
  at_t             at, at_q;
  frame_t          top_q;
  logic [IdxW-1:0] ctx_q;

  assign at = look_new_i ? Empty : at_mem_q[look_ctx_i];
  always_ff @(posedge clk_i) begin
    if (look_i) begin
      ctx_q <= look_ctx_i;
      at_q  <= at;
      top_q <= frame_q[{look_ctx_i, place_t'(at)}];
    end
  end

  // ---- s1 ----
  logic looked_q;
  at_t  above;
  assign top_o   = top_q;
  assign empty_o = at_q == Empty;
  assign full_o  = at_q == at_t'(Depth - 1);
  assign above   = at_q + 1'b1;
  always_ff @(posedge clk_i) begin
    if (push_i || replace_i) frame_q[{ctx_q, push_i ? place_t'(above) : place_t'(at_q)}] <= frame_i;
  end

  // ---- s2 ----
  logic            write_q, drop_q;
  logic [IdxW-1:0] write_ctx_q;
  at_t             write_at_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {looked_q, write_q} <= '0;
    else {looked_q, write_q} <= {look_i, looked_q};
  end
  always_ff @(posedge clk_i) begin
    if (looked_q) begin
      write_ctx_q <= ctx_q;
      write_at_q  <= push_i ? above : at_q;
      drop_q      <= drop_i;
    end
    if (write_q) at_mem_q[write_ctx_q] <= drop_q ? write_at_q - 1'b1 : write_at_q;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && look_i) begin
      assert (!(looked_q && ctx_q == look_ctx_i) && !(write_q && write_ctx_q == look_ctx_i))
        else $error("a stack is looked at before it is written");
    end
  end
`endif
endmodule
