// SPDX-License-Identifier: Apache-2.0
// stream_arb of four inputs, their items side by side on one port.
module stream_arb_tb #(
  parameter int unsigned N = 4
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  input  logic [N-1:0]         valid_i,
  output logic [N-1:0]         ready_o,
  input  logic [N-1:0] [15:0]  data_i,

  output logic                 valid_o,
  input  logic                 ready_i,
  output logic [15:0]          data_o,
  output logic [$clog2(N)-1:0] index_o
);
  logic [15:0] data [N];
  for (genvar i = 0; i < N; i++) begin : g_data
    assign data[i] = data_i[i];
  end
  stream_arb #(.data_t(logic [15:0]), .N(N)) u_arb (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i(data), .valid_o, .ready_i, .data_o, .index_o
  );
endmodule
