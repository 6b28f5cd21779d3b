// SPDX-License-Identifier: Apache-2.0
// Four dividers of other widths behind one stream; which_i, held, says which one it reaches.
module div_pipe_tb (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [1:0]  which_i,

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  logic [79:0] in_i,       // tag 16, den 32, num 32

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output logic [47:0] out_o       // tag 16, q 32
);
  typedef logic [15:0] tag_t;
  localparam int unsigned N = 4;
  localparam int unsigned NumW [N]  = '{32, 32, 26, 18};
  localparam int unsigned QFrac [N] = '{26, 26, 24, 17};
  localparam int unsigned Bits [N]  = '{2, 1, 3, 2};

  logic [N-1:0]        in_ready, out_valid;
  logic [N-1:0] [31:0] q;
  tag_t [N-1:0]        tag;

  for (genvar i = 0; i < N; i++) begin : g_div
    logic [QFrac[i]:0] quotient;
    div_pipe #(
      .NumW(NumW[i]), .QFrac(QFrac[i]), .BitsPerStage(Bits[i]), .tag_t(tag_t)
    ) u_div (
      .clk_i, .rst_ni,
      .in_valid_i(in_valid_i && which_i == 2'(i)), .in_ready_o(in_ready[i]),
      .in_num_i(in_i[NumW[i]-1:0]), .in_den_i(in_i[32 +: NumW[i]]), .in_tag_i(in_i[79:64]),
      .out_valid_o(out_valid[i]), .out_ready_i(out_ready_i && which_i == 2'(i)),
      .out_q_o(quotient), .out_tag_o(tag[i])
    );
    assign q[i] = 32'(quotient);
  end

  assign in_ready_o  = in_ready[which_i];
  assign out_valid_o = out_valid[which_i];
  assign out_o       = {tag[which_i], q[which_i]};
endmodule
