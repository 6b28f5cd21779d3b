// SPDX-License-Identifier: Apache-2.0
// root_pipe at the width that the core uses, under the port names of run_stream; it never stalls, and its
// sink must not.
module root_pipe_tb (
  input  logic        clk_i,
  input  logic        rst_ni,

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  logic [55:0] in_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output logic [27:0] out_o
);
  root_pipe #(.RadW(56)) u_root (
    .clk_i, .rst_ni, .in_valid_i, .in_rad_i(in_i), .out_valid_o, .out_root_o(out_o)
  );
  assign in_ready_o = 1'b1;

  logic unused_ready;
  assign unused_ready = out_ready_i;
endmodule
