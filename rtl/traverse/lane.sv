// SPDX-License-Identifier: Apache-2.0
// A lane: a stream of rays in, a stream of hits out. Its rays in flight are contexts, numbered places
// in small memories. Which primitives a context's ray is tested against comes
//   by brute force      from outside, one primitive for all contexts of all lanes
//   in the hierarchy    from the lane itself:
//
//            +--> node_visits --> +
//   ray --> step                  +--> step ... --> done: its hit leaves
//            +--> line_fetch --> leaf_tests --> prim_tests --> over
//                    (leaves)                          |
//                                        cand_o to the hit unit of all lanes, and back
//
// Units meet a context's ray and its nearest hit at their heads, in ray_store and prim_tests.
// hierarchy_i and tree_i stand still from the reset on. Without hierarchy_i step, node_visits and
// the leaves' units rest.
// Model: cpp_model/traverse/lane.hpp, equal bit for bit.
module lane
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Contexts  = DefaultContexts,
  parameter int unsigned NodeLines = DefaultNodeLines,    // of the caches
  parameter int unsigned LeafLines = DefaultCacheLines,
  parameter int unsigned TileNodes = tile_nodes(tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2)),   // nodes of tiles' frontiers
  parameter bit          GateClocks = 1'b0,
  localparam int unsigned TileW    = $clog2(TileNodes)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             hierarchy_i,
  input  tree_t            tree_i,

  input  logic             fill_i,         // rays may enter
  input  logic             ray_valid_i,
  output logic             ray_ready_o,
  input  ray_t             ray_i,
  input  start_t           start_i,        // where in the hierarchy it starts

  input  logic             test_valid_i,   // brute force
  output logic             test_ready_o,
  input  logic             test_step_i,    // the test is taken by all lanes
  input  ctx_t             test_ctx_i,
  input  prim_slot_t       test_prim_i,

  input  logic             tile_write_i,   // node_fill_i.data is a node of a tile's frontier
  input  logic [TileW-1:0] tile_index_i,

  output logic             cand_valid_o,   // accepted tests, to the hit unit of all lanes
  input  logic             cand_ready_i,
  output cand_t            cand_o,
  output hit_ray_t         cand_ray_o,
  input  logic             hit_over_i,     // one is over
  input  logic             result_valid_i,
  input  result_t          result_i,       // its context, and its result where result_valid_i

  input  logic             emit_i,         // hits may leave
  output logic             hit_valid_o,
  input  logic             hit_ready_i,
  output hit_t             hit_o,
  output work_t            work_o,         // what was done for it
  output error_t           fault_o,

  // Lines of nodes and of leaves, from memory.
  output logic             node_req_valid_o,
  input  logic             node_req_ready_i,
  output line_req_t        node_req_o,
  input  logic             node_fill_valid_i,
  output logic             node_fill_ready_o,
  input  line_fill_t       node_fill_i,
  output logic             leaf_req_valid_o,
  input  logic             leaf_req_ready_i,
  output line_req_t        leaf_req_o,
  input  logic             leaf_fill_valid_i,
  output logic             leaf_fill_ready_o,
  input  line_fill_t       leaf_fill_i,

  output logic [CtxW:0]    used_o,
  output logic             full_o,
  output logic             empty_o,
  output logic             quiet_o,
  output lane_events_t     events_o
);
  localparam int unsigned IdxW = (Contexts > 1) ? $clog2(Contexts) : 1;

  // ---- Contexts ----
  ctx_t       free_ctx, out_ctx;
  ctx_t       next_ctx [2];   // whose step is decided
  logic [1:0] done;
  logic       may_enter, start_ready, tests_ready, ray_taken, out_valid;

  assign may_enter   = fill_i && !full_o && tests_ready;
  assign ray_ready_o = may_enter && (start_ready || !hierarchy_i);
  assign ray_taken   = ray_valid_i && ray_ready_o;
  assign hit_valid_o = emit_i && out_valid;

  contexts #(.Contexts(Contexts)) u_contexts (
    .clk_i, .rst_ni, .hierarchy_i,
    .free_ctx_o(free_ctx), .take_i(ray_taken), .done_valid_i(done), .done_ctx_i(next_ctx),
    .out_valid_o(out_valid), .out_ctx_o(out_ctx), .out_taken_i(hit_valid_o && hit_ready_i),
    .used_o, .full_o, .empty_o
  );

  // ---- The rays, and what each unit reads of them ----
  ctx_t            test_ctx, look_ctx, node_ctx;
  ctx_t            ask_ctx [2];
  logic [IdxW-1:0] step_ctx [2];
  test_ray_t       test_ray;
  logic            look_valid;
  logic [1:0]      any_hit;
  prim_t           look_ignore;
  slab_ray_t       node_ray;

  ray_store #(.Contexts(Contexts)) u_rays (
    .clk_i,
    .write_i(ray_taken), .write_ctx_i(IdxW'(free_ctx)), .ray_i,
    .test_ctx_i(IdxW'(test_ctx)), .test_ray_o(test_ray),
    .look_ctx_i(IdxW'(look_ctx)), .look_valid_o(look_valid), .look_ignore_o(look_ignore),
    .node_ctx_i(IdxW'(node_ctx)), .node_ray_o(node_ray),
    .step_ctx_i(step_ctx), .step_any_hit_o(any_hit),
    .hit_ctx_i(IdxW'(cand_o.ctx)), .hit_ray_o(cand_ray_o),
    .out_ctx_i(IdxW'(out_ctx)), .out_tag_o(hit_o.tag), .out_sx_o(hit_o.sx), .out_sy_o(hit_o.sy),
    .out_axis_o(hit_o.axis), .out_neg_o(hit_o.neg), .out_any_hit_o(hit_o.any_hit)
  );

  // ---- Steps through the hierarchy; by brute force these units rest, and so may their clock ----
  logic tree_clk;
  clock_gate #(.Gated(GateClocks)) u_tree_clock (.clk_i, .awake_i(hierarchy_i || !rst_ni), .clk_o(tree_clk));

  logic       node_done, leaf_done;
  ctx_t       node_done_ctx, leaf_done_ctx;
  visits_t    visits;
  dist_t      step_reach [2];
  logic [1:0] to_node, to_leaf, found;
  ref_t       target [2];
  error_t     step_fault;
  steps_t     nodes;
  assign step_ctx = '{IdxW'(ask_ctx[0]), IdxW'(ask_ctx[1])};

  step_pair #(.Contexts(Contexts)) u_step (
    .clk_i(tree_clk), .rst_ni, .limit_i(tree_i.limit),
    .start_valid_i(hierarchy_i && ray_valid_i && may_enter), .start_ready_o(start_ready),
    .start_ctx_i(free_ctx), .start_i(ray_i.valid ? start_i : start_t'('0)),
    .node_valid_i(node_done), .node_ctx_i(node_done_ctx), .node_i(visits),
    .leaf_valid_i(leaf_done), .leaf_ctx_i(leaf_done_ctx),
    .ask_ctx_o(ask_ctx), .reach_i(step_reach), .stop_i(any_hit & found),
    .out_ctx_o(next_ctx), .node_valid_o(to_node), .leaf_valid_o(to_leaf), .out_ref_o(target),
    .done_valid_o(done), .fault_o(step_fault),
    .count_ctx_i(out_ctx), .count_o(nodes)
  );

  // ---- Nodes ----
  t_t     node_t_near;
  error_t node_fault;

  node_visits #(.Contexts(Contexts), .Lines(NodeLines), .TileNodes(TileNodes)) u_nodes (
    .clk_i(tree_clk), .rst_ni, .base_i(tree_i.node_base), .count_i(tree_i.node_count),
    .visit_valid_i(to_node), .visit_ctx_i(next_ctx), .visit_ref_i(target),
    .tile_write_i, .tile_index_i,
    .ray_ctx_o(node_ctx), .ray_i(node_ray), .t_i(node_t_near),
    .out_valid_o(node_done), .out_ctx_o(node_done_ctx), .out_o(visits), .fault_o(node_fault),
    .req_valid_o(node_req_valid_o), .req_ready_i(node_req_ready_i), .req_o(node_req_o),
    .fill_valid_i(node_fill_valid_i), .fill_ready_o(node_fill_ready_o), .fill_i(node_fill_i),
    .node_o(events_o.node), .hit_o(events_o.node_hit), .miss_o(events_o.node_miss), .wait_o(events_o.node_wait)
  );

  // ---- Leaves ----
  logic       line_valid, line_ready, leaf_test;
  ctx_t       line_ctx, leaf_test_ctx;
  line_data_t line;
  prim_slot_t leaf_prim;
  error_t     leaf_fault, prim_fault;
  logic [1:0] test_over;
  ctx_t       over_ctx [2];

  line_fetch #(.Contexts(Contexts), .Lines(LeafLines), .Fault(ErrLeaf)) u_leaves (
    .clk_i(tree_clk), .rst_ni, .base_i(tree_i.leaf_base), .count_i(tree_i.leaf_count),
    .visit_valid_i(to_leaf), .visit_ctx_i(next_ctx), .visit_ref_i(target),
    .keep_i(1'b0), .keep_index_i('0),
    .out_valid_o(line_valid), .out_ready_i(line_ready), .out_ctx_o(line_ctx), .out_kept_o(), .out_index_o(),
    .out_data_o(line),
    .fault_o(leaf_fault),
    .req_valid_o(leaf_req_valid_o), .req_ready_i(leaf_req_ready_i), .req_o(leaf_req_o),
    .fill_valid_i(leaf_fill_valid_i), .fill_ready_o(leaf_fill_ready_o), .fill_i(leaf_fill_i),
    .hit_o(events_o.leaf_hit), .miss_o(events_o.leaf_miss), .wait_o(events_o.leaf_wait)
  );

  leaf_tests #(.Contexts(Contexts)) u_leaf_tests (
    .clk_i(tree_clk), .rst_ni, .primitives_i(tree_i.primitives),
    .line_valid_i(line_valid), .line_ready_o(line_ready), .line_ctx_i(line_ctx), .line_i(line),
    .ignore_i(look_ignore),
    .test_valid_o(leaf_test), .test_ready_i(test_ready_o), .test_ctx_o(leaf_test_ctx), .test_prim_o(leaf_prim),
    .over_i(test_over & {2{hierarchy_i}}), .over_ctx_i(over_ctx),
    .leaf_valid_o(leaf_done), .leaf_ctx_o(leaf_done_ctx), .fault_o(prim_fault)
  );

  // ---- Tests ----
  logic       brute_test, test;
  prim_slot_t tested;
  result_t    best;
  tests_t     tests;

  assign look_ctx   = hierarchy_i ? line_ctx : test_ctx_i;
  assign test_ctx   = hierarchy_i ? leaf_test_ctx : test_ctx_i;
  assign brute_test = test_valid_i && test_step_i && {1'b0, test_ctx_i} < used_o && look_valid
                      && test_prim_i.number != look_ignore;
  assign test       = hierarchy_i ? leaf_test && test_ready_o : brute_test;
  assign tested     = hierarchy_i ? leaf_prim : test_prim_i;

  prim_tests #(.Contexts(Contexts)) u_tests (
    .clk_i, .rst_ni,
    .start_i(ray_taken), .start_ready_o(tests_ready), .start_ctx_i(IdxW'(free_ctx)), .tmax_i(ray_i.tmax),
    .test_valid_i(test), .test_ready_o, .test_ctx_i(test_ctx), .test_ray_i(test_ray),
    .test_prim_i(tested),
    .cand_valid_o, .cand_ready_i, .cand_o, .hit_over_i, .result_valid_i, .result_i,
    .over_o(test_over), .over_ctx_o(over_ctx), .idle_o(quiet_o), .accept_o(events_o.cand),
    .node_ctx_i(IdxW'(node_ctx)), .node_t_o(node_t_near),
    .step_ctx_i(step_ctx), .step_reach_o(step_reach), .step_found_o(found),
    .out_ctx_i(IdxW'(out_ctx)), .out_found_o(hit_o.found), .out_o(best), .out_tests_o(tests)
  );
  assign events_o.test      = test;
  assign events_o.test_wait = leaf_test && !test_ready_o;

  // ---- Out ----
  assign hit_o.kind   = best.kind;
  assign hit_o.number = best.number;
  assign hit_o.t      = best.t;
  assign hit_o.u      = best.u;
  assign hit_o.v      = best.v;
  assign work_o       = '{tests: tests, nodes: hierarchy_i ? nodes : '0};

  error_t fault;
  always_comb begin
    fault = step_fault;
    if (node_fault != ErrNone) fault = node_fault;
    if (leaf_fault != ErrNone) fault = leaf_fault;
    if (prim_fault != ErrNone) fault = prim_fault;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) fault_o <= ErrNone;
    else fault_o <= fault;
  end
endmodule
