// SPDX-License-Identifier: Apache-2.0
// The handshake of a pipeline of Stages registers whose payloads its user holds: stage i takes its
// payload at load_o[i], and only then, so that an empty stage computes nothing.
//   if (load[0]) a_q <= f(in_i);
//   if (load[1]) b_q <= g(a_q);
// Bubbles close up while the output is blocked; ready is combinational from output to input.
module pipe_chain #(
  parameter int unsigned Stages = 2
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              valid_i,
  output logic              ready_o,

  output logic              valid_o,
  input  logic              ready_i,

  output logic [Stages-1:0] load_o
);
  if (Stages < 1) begin : g_check
    $error("pipe_chain: Stages must be at least 1");
  end

  logic [Stages-1:0] valid_q, offered, open, ready;

  assign offered  = Stages'({valid_q, valid_i});  // the valid that each stage is offered
  assign ready_o = ready[0];
  assign valid_o = valid_q[Stages-1];
  assign load_o  = offered & ready;

  // A stage moves if a place from it on is free, or the output is taken: the free places, smeared
  // towards the input in a logarithmic number of steps.
  always_comb begin
    open  = ~valid_q;
    ready = '1;
    if (!ready_i && valid_q != '0) begin
      for (int unsigned i = 1; i < Stages; i *= 2) open = open | (open >> i);
      ready = open;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= (valid_q & ~ready) | (offered & ready);
  end
endmodule
