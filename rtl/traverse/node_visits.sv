// SPDX-License-Identifier: Apache-2.0
// From a reference to the children that a ray visits: a node of the image through the cache, or one of
// a tile's frontier, which is kept beside the cache's lines, then the test of its boxes.
//
//   visit --> line_fetch --> node_pipe --> out
//
// One node a cycle; nothing waits for what comes out. A node whose index is behind the section, one
// that is illegal, and one with a child that is a node and not behind it raise fault_o (ErrNode), and
// the context gets nothing.
// Model: cpp_model/traverse/node_visits.hpp, equal bit for bit in what is read: of an entry without a target, only its kind.
module node_visits
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Contexts  = DefaultContexts,
  parameter int unsigned Lines     = DefaultNodeLines,   // of the cache
  parameter int unsigned TileNodes = tile_nodes(tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2)),
  localparam int unsigned TileW    = $clog2(TileNodes)
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  line_no_t         base_i,          // the image's first node
  input  logic [31:0]      count_i,         // how many it has

  input  logic [1:0]       visit_valid_i,   // at most one of a context under way
  input  ctx_t             visit_ctx_i [2],
  input  ref_t             visit_ref_i [2],

  input  logic             tile_write_i,    // fill_i.data is a node of a tile's frontier; no fill is taken then
  input  logic [TileW-1:0] tile_index_i,

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
  node_t node;
  localparam int unsigned NodeW = $bits(node_t) - $bits(node.reserved);
  typedef logic [NodeW-1:0] stored_t;
  logic    node_valid, in_tile;
  ctx_t    node_ctx;
  line_t   index;
  stored_t stored;
  error_t  fetch_fault;

  line_fetch #(.Contexts(Contexts), .Lines(Lines), .Fault(ErrNode), .Kept(TileNodes), .ReadW(NodeW)) u_fetch (
    .clk_i, .rst_ni, .base_i, .count_i,
    .visit_valid_i, .visit_ctx_i, .visit_ref_i,
    .keep_i(tile_write_i), .keep_index_i(tile_index_i),
    .out_valid_o(node_valid), .out_ready_i(1'b1), .out_ctx_o(node_ctx), .out_kept_o(in_tile), .out_index_o(index),
    .out_data_o(stored), .fault_o(fetch_fault),
    .req_valid_o, .req_ready_i, .req_o, .fill_valid_i, .fill_ready_o, .fill_i,
    .hit_o, .miss_o, .wait_o
  );

  // ---- Children lie behind their parent ----
  function automatic logic in_order(ref_word_t word, line_t parent);
    ref_t child;
    child = ref_t'(word);
    return child.kind != RefNode || child.index > parent;
  endfunction

  logic ordered;
  assign node    = node_t'(stored);
  assign ordered = in_tile || (in_order(node.ref0, index) && in_order(node.ref1, index)
                               && in_order(node.ref2, index) && in_order(node.ref3, index));

  // ---- Boxes ----
  logic pipe_valid, illegal;
  assign ray_ctx_o = node_ctx;
  assign node_o    = node_valid && ordered;

  node_pipe u_node_pipe (
    .clk_i, .rst_ni,
    .in_valid_i(node_o), .in_ctx_i(ray_ctx_o), .in_ray_i(ray_i), .in_node_i(node), .in_t_i(t_i),
    .out_valid_o(pipe_valid), .out_ctx_o, .out_o, .error_o(illegal)
  );
  assign out_valid_o = pipe_valid && !illegal;
  assign fault_o     = (fetch_fault != ErrNone || (node_valid && !ordered) || (pipe_valid && illegal)) ? ErrNode : ErrNone;
endmodule
