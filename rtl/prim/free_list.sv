// SPDX-License-Identifier: Apache-2.0
// The numbers 0 to N-1 that nobody uses. After a reset all of them; the lowest never used goes first,
// then those given back, in that order.
// One number out and one back each cycle; a number given back is offered the cycle after.
module free_list #(
  parameter int unsigned N = 8,
  localparam int unsigned IdxW = (N > 1) ? $clog2(N) : 1
) (
  input  logic            clk_i,
  input  logic            rst_ni,

  output logic            valid_o,    // some number is free
  output logic [IdxW-1:0] number_o,
  input  logic            take_i,     // it is taken; only with valid_o

  input  logic            give_i,
  input  logic [IdxW-1:0] number_i
);
  logic [IdxW:0]   fresh_q;           // numbers from here up were never taken
  logic            fresh, back_valid;
  logic [IdxW-1:0] back;
  assign fresh    = fresh_q != (IdxW+1)'(N);
  assign valid_o  = fresh || back_valid;
  assign number_o = fresh ? IdxW'(fresh_q) : back;

  stream_fifo #(.data_t(logic [IdxW-1:0]), .Depth((N > 1) ? N : 2)) u_back (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(give_i), .ready_o(), .data_i(number_i),
    .valid_o(back_valid), .ready_i(take_i && !fresh), .data_o(back)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni) fresh_q <= '0;
    else if (take_i && fresh) fresh_q <= fresh_q + 1'b1;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && take_i) assert (valid_o) else $error("free_list: a number was taken where none is free");
    if (rst_ni && give_i) begin
      assert ({1'b0, number_i} < fresh_q) else $error("free_list: %0d was given back and never taken", number_i);
    end
  end
`endif
endmodule
