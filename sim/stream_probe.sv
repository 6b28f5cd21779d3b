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
