// SPDX-License-Identifier: Apache-2.0
// Pairs of divisions of four widths, those of the core first; Operands in the lower bits; which_i, held, says whose quotients come out.
module div_pair_tb (
  input  logic        clk_i,
  input  logic [1:0]  which_i,

  input  logic [11:0] en_i,
  input  logic [44:0] num0_i,
  input  logic [44:0] num1_i,
  input  logic [44:0] den_i,
  output logic [31:0] q0_o,
  output logic [31:0] q1_o
);
  localparam int unsigned N = 4;
  localparam int unsigned DenW [N]  = '{26, 32, 19, 45};
  localparam int unsigned QFrac [N] = '{24, 26, 15, 16};

  logic [N-1:0] [31:0] q0, q1;
  for (genvar i = 0; i < N; i++) begin : g_pair
    logic [1:0] [QFrac[i]:0] q;
    div_pair #(.DenW(DenW[i]), .QFrac(QFrac[i])) u_pair (
      .clk_i, .en_i, .num_i({num1_i[DenW[i]-1:0], num0_i[DenW[i]-1:0]}), .den_i(den_i[DenW[i]-1:0]), .q_o(q)
    );
    assign q0[i] = 32'(q[0]);
    assign q1[i] = 32'(q[1]);
  end
  assign q0_o = q0[which_i];
  assign q1_o = q1[which_i];
endmodule
