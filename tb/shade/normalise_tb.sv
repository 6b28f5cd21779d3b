// SPDX-License-Identifier: Apache-2.0
// normalise with a tag, under the port names of run_stream.
module normalise_tb
  import castray_pkg::*;
(
  input  logic        clk_i,
  input  logic        rst_ni,

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  logic [96:0] in_i,       // tag 10, x, y, z

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output logic [63:0] out_o       // tag 10, unit
);
  typedef logic [9:0] tag_t;
  unit3_t unit;
  tag_t   tag;

  normalise #(.tag_t(tag_t)) u_normalise (
    .clk_i, .rst_ni,
    .in_valid_i, .in_ready_o, .in_x_i(in_i[86:58]), .in_y_i(in_i[57:29]), .in_z_i(in_i[28:0]),
    .in_tag_i(in_i[96:87]),
    .out_valid_o, .out_ready_i, .out_o(unit), .out_tag_o(tag)
  );
  assign out_o = {tag, unit};
endmodule
