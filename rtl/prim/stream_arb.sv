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
  logic            locked_q;
  logic [IdxW-1:0] index_q;      // the input served last, or, when locked, offered now
  logic [IdxW-1:0] pick;

  // The first offered input behind the one served last.
  function automatic logic [IdxW-1:0] next_of(logic [N-1:0] offered, logic [IdxW-1:0] last);
    logic [IdxW-1:0] at;
    next_of = last;
    at = last;
    for (int unsigned i = 0; i < N; i++) begin
      // From the lowest priority, the one served last, to the highest, the one behind it.
      if (offered[at]) next_of = at;
      at = (at == '0) ? IdxW'(N - 1) : at - 1'b1;
    end
  endfunction

  always_comb begin
    pick = index_q;
    if (!locked_q && valid_i != '0) pick = next_of(valid_i, index_q);
  end

  assign valid_o = |valid_i;
  assign index_o = pick;
  assign data_o  = data_i[pick];
  always_comb begin
    ready_o       = '0;
    ready_o[pick] = ready_i;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      locked_q <= 1'b0;
      index_q  <= '0;
    end else if (valid_o) begin
      locked_q <= !ready_i;
      index_q  <= pick;
    end
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
