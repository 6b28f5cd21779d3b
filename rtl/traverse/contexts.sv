// SPDX-License-Identifier: Apache-2.0
// Which contexts of a lane hold rays.
//   brute force   given out from 0 up, and given back in that order, all of them before the next is
//                 given out; used_o: they are 0 to used_o - 1
//   hierarchy     given out as they are free, given back in the order in which their rays are done
// hierarchy_i stands still from the reset on.
module contexts
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts
) (
  input  logic          clk_i,
  input  logic          rst_ni,
  input  logic          hierarchy_i,

  output ctx_t          free_ctx_o,      // the next ray's, unless full_o
  input  logic          take_i,

  input  logic [1:0]    done_valid_i,    // rays are done; always taken. Not for brute force
  input  ctx_t          done_ctx_i [2],

  output logic          out_valid_o,     // whose hit may leave; for brute force any, when all are done
  output ctx_t          out_ctx_o,
  input  logic          out_taken_i,

  output logic [CtxW:0] used_o,
  output logic          full_o,
  output logic          empty_o
);
  if (Contexts < 1 || Contexts > 2 ** CtxW) begin : g_check
    $error("contexts: Contexts must be 1 to %0d", 2 ** CtxW);
  end
  localparam int unsigned QueueDepth = (Contexts > 1) ? Contexts : 2;
  localparam int unsigned IdxW       = (Contexts > 1) ? $clog2(Contexts) : 1;

  // used_q contexts hold rays. Brute force: those before out_q have given their hits.
  logic [CtxW:0] used_q, out_q;
  logic          last_out;

  assign used_o   = used_q;
  assign full_o   = used_q == (CtxW+1)'(Contexts);
  assign empty_o  = used_q == '0;
  assign last_out = out_q + 1'b1 == used_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      used_q <= '0;
      out_q  <= '0;
    end else if (hierarchy_i) begin
      if (take_i != out_taken_i) used_q <= take_i ? used_q + 1'b1 : used_q - 1'b1;
    end else if (take_i) begin
      used_q <= used_q + 1'b1;
    end else if (out_taken_i) begin
      out_q <= last_out ? '0 : out_q + 1'b1;
      if (last_out) used_q <= '0;
    end
  end

  // ---- Hierarchy: who is done, and who is free ----
  logic done_valid;
  ctx_t done_ctx;
  logic [IdxW-1:0] free_ctx;

  pair_fifo #(.data_t(ctx_t), .Depth(QueueDepth)) u_done (
    .clk_i, .rst_ni,
    .valid_i(done_valid_i), .ready_o(), .data_i(done_ctx_i),
    .valid_o(done_valid), .ready_i(hierarchy_i && out_taken_i), .data_o(done_ctx)
  );
  free_list #(.N(Contexts)) u_free (
    .clk_i, .rst_ni,
    .valid_o(), .number_o(free_ctx), .take_i(hierarchy_i && take_i),
    .give_i(hierarchy_i && out_taken_i), .number_i(IdxW'(done_ctx))
  );

  assign free_ctx_o  = hierarchy_i ? CtxW'(free_ctx) : CtxW'(used_q);
  assign out_valid_o = hierarchy_i ? done_valid : !empty_o;
  assign out_ctx_o   = hierarchy_i ? done_ctx : CtxW'(out_q);
endmodule
