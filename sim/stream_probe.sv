// SPDX-License-Identifier: Apache-2.0
// Shows each item of a stream to the simulation (sim/probe.hpp) while it asks for them: for
// `castray ray`. Bound to its units from outside; synthesis never sees it.
module stream_probe #(
  parameter int unsigned Stream = 0,  // its number in sim/probe.cpp
  parameter int unsigned Width  = 1
) (
  input logic             clk_i,
  input logic             taken_i,
  input logic [Width-1:0] data_i
);
  localparam int unsigned MaxWidth = 1024;
  if (Width > MaxWidth) begin : g_check
    $error("stream_probe: at most %0d bits", MaxWidth);
  end

  import "DPI-C" function bit castray_probing();
  import "DPI-C" function void castray_probe(input int stream, input bit [MaxWidth-1:0] data);

  always @(posedge clk_i) begin
    if (taken_i && castray_probing()) castray_probe(int'(Stream), MaxWidth'(data_i));
  end
endmodule

bind ray_source stream_probe #(.Stream(0), .Width($bits(dir))) u_probe_dir (.clk_i, .taken_i(dir_valid && dir_ready), .data_i(dir));
bind castray_core stream_probe #(.Stream(1), .Width($bits(ray))) u_probe_ray (.clk_i, .taken_i(ray_valid && ray_ready), .data_i(ray));
bind prim_tests stream_probe #(.Stream(2), .Width($bits(cand))) u_probe_cand (.clk_i, .taken_i(cand_valid), .data_i(cand));
bind prim_tests stream_probe #(.Stream(3), .Width($bits(result_i))) u_probe_result (.clk_i, .taken_i(result_valid_i), .data_i(result_i));
bind castray_core stream_probe #(.Stream(4), .Width($bits(cast.hit))) u_probe_hit (.clk_i, .taken_i(hit_valid && hit_ready), .data_i(cast.hit));
bind shading stream_probe #(.Stream(5), .Width($bits(shaded))) u_probe_shaded (.clk_i, .taken_i(shaded_valid && shaded_ready), .data_i(shaded));

// In a lane, whose ray enters which context, and where the rays go; in front of those of the context, its number.
bind lane stream_probe #(.Stream(6), .Width(CtxW + $bits(ray_i.tag))) u_probe_enter (.clk_i, .taken_i(ray_taken), .data_i({free_ctx, ray_i.tag}));
bind lane stream_probe #(.Stream(7), .Width(CtxW + $bits(target[0]))) u_probe_even (.clk_i(tree_clk), .taken_i(to_node[0] || to_leaf[0]), .data_i({next_ctx[0], target[0]}));
bind lane stream_probe #(.Stream(7), .Width(CtxW + $bits(target[1]))) u_probe_odd (.clk_i(tree_clk), .taken_i(to_node[1] || to_leaf[1]), .data_i({next_ctx[1], target[1]}));
bind lane stream_probe #(.Stream(8), .Width(CtxW + $bits(visits))) u_probe_visits (.clk_i(tree_clk), .taken_i(node_done), .data_i({node_done_ctx, visits}));
bind prim_tests stream_probe #(.Stream(9), .Width(CtxW + $bits(test_prim_i))) u_probe_test (.clk_i, .taken_i(test_valid_i), .data_i({test_ctx_i, test_prim_i}));

// The start of a tile.
bind tile_start stream_probe #(.Stream(10), .Width($bits(bounds))) u_probe_bounds (.clk_i, .taken_i(bounds_valid && bounds_ready), .data_i(bounds));
bind tile_start stream_probe #(.Stream(11), .Width($bits(ask_index))) u_probe_ask (.clk_i, .taken_i(ask_valid), .data_i(ask_index));
bind tile_start stream_probe #(.Stream(12), .Width($bits(store_node_o))) u_probe_store (.clk_i, .taken_i(store_valid_o), .data_i(store_node_o));
bind tile_start stream_probe #(.Stream(13), .Width($bits(out_o))) u_probe_start (.clk_i, .taken_i(out_valid_o && out_ready_i), .data_i(out_o));
