// SPDX-License-Identifier: Apache-2.0
// The nodes of tiles' frontiers, kept on chip: whoever makes a frontier writes it, the rays of the tile
// start at it. Contexts sent here wait in a queue; a node is offered the cycle after its context came.
// One node a cycle.
module tile_nodes
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  parameter int unsigned Nodes    = 32,
  localparam int unsigned IdxW    = $clog2(Nodes)
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  input  logic            write_i,
  input  logic [IdxW-1:0] write_index_i,
  input  node_t           node_i,

  input  logic [1:0]      visit_valid_i,   // at most one of a context under way
  input  ctx_t            visit_ctx_i [2],
  input  ref_t            visit_ref_i [2],

  output logic            out_valid_o,
  input  logic            out_ready_i,
  output ctx_t            out_ctx_o,
  output node_t           out_o
);
  localparam int unsigned QueueDepth = (Contexts > 1) ? Contexts : 2;
  typedef struct packed {
    ctx_t            ctx;
    logic [IdxW-1:0] index;
  } visit_t;
  visit_t visit [2], head;
  for (genvar i = 0; i < 2; i++) begin : g_visit
    assign visit[i] = '{ctx: visit_ctx_i[i], index: IdxW'(visit_ref_i[i].index)};
  end

  pair_fifo #(.data_t(visit_t), .Depth(QueueDepth)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(visit_valid_i), .ready_o(), .data_i(visit),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(head)
  );

  node_t node_q [Nodes];
  assign out_ctx_o = head.ctx;
  assign out_o     = node_q[head.index];
  always_ff @(posedge clk_i) begin
    if (write_i) node_q[write_index_i] <= node_i;
  end
endmodule
