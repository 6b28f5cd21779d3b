// SPDX-License-Identifier: Apache-2.0
// cordic_sqrt with a tag, under the port names of run_stream.
module cordic_sqrt_tb (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  logic [37:0] in_i,       // tag 12, rad 26

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output logic [29:0] out_o       // tag 12, root 18
);
  typedef logic [11:0] tag_t;
  logic [17:0] root;
  tag_t        tag;

  cordic_sqrt #(.tag_t(tag_t)) u_root (
    .clk_i, .rst_ni,
    .in_valid_i, .in_ready_o, .in_rad_i(in_i[25:0]), .in_tag_i(in_i[37:26]),
    .out_valid_o, .out_ready_i, .out_root_o(root), .out_tag_o(tag)
  );
  assign out_o = {tag, root};
endmodule
