// SPDX-License-Identifier: Apache-2.0
// Merges N streams into one, round robin: after an input was served, the next ones come first.
// An offered item is kept: the choice does not change while it waits. Combinational, latency 0.
module stream_arb #(
  parameter type         data_t = logic [31:0],
  parameter int unsigned N      = 2,
  localparam int unsigned IdxW  = (N > 1) ? $clog2(N) : 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  input  logic  [N-1:0]   valid_i,
  output logic  [N-1:0]   ready_o,
  input  data_t           data_i [N],

  output logic            valid_o,
  input  logic            ready_i,
  output data_t           data_o,
  output logic [IdxW-1:0] index_o
);
  logic [N-1:0] early_q;   // come before the others: those behind the input served last, or from the one that waits on
  logic [N-1:0] offered, given, ahead;
  assign offered = ((valid_i & early_q) != '0) ? valid_i & early_q : valid_i;
  for (genvar i = 0; i < N; i++) begin : g_turn
    assign given[i]  = offered[i] && (offered & N'((1 << i) - 1)) == '0;   // the first
    assign ahead[i]  = (offered & N'((2 << i) - 1)) == '0;                 // those before it
  end

  assign valid_o = |valid_i;
  assign ready_o = given & {N{ready_i}};
  always_comb begin
    index_o = '0;
    for (int unsigned i = 0; i < N; i++) if (given[i]) index_o |= IdxW'(i);
  end

  // Four inputs and two bits of an index are a LUT; more inputs are fewer as a sum of products.
  if (N <= 4) begin : g_few
    assign data_o = data_i[index_o];
  end else begin : g_many
    always_comb begin
      data_o = data_t'('0);
      for (int unsigned i = 0; i < N; i++) data_o = data_t'(data_o | (data_i[i] & {$bits(data_t){given[i]}}));
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) early_q <= ~N'(1);
    else if (valid_o) early_q <= ready_i ? ~(ahead | given) : ~ahead;
  end

`ifndef SYNTHESIS
  // Combinational: what it offers is kept only if its inputs keep what they offer.
  for (genvar i = 0; i < N; i++) begin : g_check_in
    stream_check #(.data_t(data_t)) u_check_in (
      .clk_i, .rst_ni, .valid_i(valid_i[i]), .ready_i(ready_o[i]), .data_i(data_i[i])
    );
  end
  stream_check #(.data_t(data_t)) u_check_out (
    .clk_i, .rst_ni, .valid_i(valid_o), .ready_i(ready_i), .data_i(data_o)
  );
`endif
endmodule
