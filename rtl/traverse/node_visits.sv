// SPDX-License-Identifier: Apache-2.0
// From a reference to the children that a ray visits: a node of the image through the cache, or one of
// a tile's frontier from the chip, then the test of its boxes. Tiles' nodes go first.
//
//   visit -+-> line_fetch -+-> node_pipe -> out
//          +-> tile_nodes -+
//
// One node a cycle; nothing waits for what comes out. A node whose index is behind the section, one
// that is illegal, and one with a child that is a node and not behind it raise fault_o (ErrNode), and
// the context gets nothing.
// Model: cpp_model/traverse/node_visits.hpp, equal bit for bit.
module node_visits
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Contexts  = DefaultContexts,
  parameter int unsigned Lines     = 512,   // of the cache
  parameter int unsigned TileNodes = 32,
  localparam int unsigned TileW    = $clog2(TileNodes)
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  line_no_t         base_i,          // the image's first node
  input  logic [31:0]      count_i,         // how many it has

  input  logic [1:0]       visit_valid_i,   // at most one of a context under way
  input  ctx_t             visit_ctx_i [2],
  input  ref_t             visit_ref_i [2],

  input  logic             tile_write_i,    // a node of a tile's frontier
  input  logic [TileW-1:0] tile_index_i,
  input  node_t            tile_node_i,

  output ctx_t             ray_ctx_o,       // who is tested
  input  slab_ray_t        ray_i,
  input  t_t               t_i,             // its nearest hit so far

  output logic             out_valid_o,
  output ctx_t             out_ctx_o,
  output visits_t          out_o,
  output error_t           fault_o,

  output logic             req_valid_o,     // to memory
  input  logic             req_ready_i,
  output line_req_t        req_o,
  input  logic             fill_valid_i,
  output logic             fill_ready_o,
  input  line_fill_t       fill_i,

  output logic             node_o,          // counter events: a node is tested
  output logic             hit_o,
  output logic             miss_o,
  output logic             wait_o
);
  // ---- Where the node is ----
  logic [1:0] in_tile;
  logic       line_valid, tile_valid;
  ctx_t       line_ctx, tile_ctx;
  line_data_t line;
  line_t      index;       // of the line's node
  node_t      tile_node;
  error_t     fetch_fault;
  assign in_tile = {visit_ref_i[1].kind == RefTile, visit_ref_i[0].kind == RefTile};

  line_fetch #(.Contexts(Contexts), .Lines(Lines), .Fault(ErrNode)) u_fetch (
    .clk_i, .rst_ni, .base_i, .count_i,
    .visit_valid_i(visit_valid_i & ~in_tile), .visit_ctx_i, .visit_ref_i,
    .out_valid_o(line_valid), .out_ready_i(!tile_valid), .out_ctx_o(line_ctx), .out_index_o(index), .out_data_o(line),
    .fault_o(fetch_fault),
    .req_valid_o, .req_ready_i, .req_o, .fill_valid_i, .fill_ready_o, .fill_i,
    .hit_o, .miss_o, .wait_o
  );

  tile_nodes #(.Contexts(Contexts), .Nodes(TileNodes)) u_tiles (
    .clk_i, .rst_ni,
    .write_i(tile_write_i), .write_index_i(tile_index_i), .node_i(tile_node_i),
    .visit_valid_i(visit_valid_i & in_tile), .visit_ctx_i, .visit_ref_i,
    .out_valid_o(tile_valid), .out_ready_i(1'b1), .out_ctx_o(tile_ctx), .out_o(tile_node)
  );

  // ---- Children lie behind their parent ----
  function automatic logic in_order(ref_word_t word, line_t parent);
    ref_t child;
    child = ref_t'(word);
    return child.kind != RefNode || child.index > parent;
  endfunction

  node_t node;
  logic  ordered;
  always_comb begin   // nothing moves here while there is no node
    node    = '0;
    ordered = 1'b1;
    if (tile_valid) node = tile_node;
    else if (line_valid) begin
      node    = node_t'(line);
      ordered = in_order(node.ref0, index) && in_order(node.ref1, index)
                && in_order(node.ref2, index) && in_order(node.ref3, index);
    end
  end

  // ---- Boxes ----
  logic pipe_valid, illegal;
  assign ray_ctx_o = tile_valid ? tile_ctx : line_ctx;
  assign node_o    = (tile_valid || line_valid) && ordered;

  node_pipe u_node_pipe (
    .clk_i, .rst_ni,
    .in_valid_i(node_o), .in_ctx_i(ray_ctx_o), .in_ray_i(ray_i), .in_node_i(node), .in_t_i(t_i),
    .out_valid_o(pipe_valid), .out_ctx_o, .out_o, .error_o(illegal)
  );
  assign out_valid_o = pipe_valid && !illegal;
  assign fault_o     = (fetch_fault != ErrNone || (line_valid && !ordered) || (pipe_valid && illegal)) ? ErrNode : ErrNone;
endmodule
