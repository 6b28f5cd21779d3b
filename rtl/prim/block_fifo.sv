// SPDX-License-Identifier: Apache-2.0
// A first-in first-out queue in block RAM, for wide items: Depth places and an output register. One
// item in and one out each cycle; an item is visible two cycles after it entered; ready does not
// depend on ready_i.
module block_fifo #(
  parameter type         data_t = logic [31:0],
  parameter int unsigned Depth  = 64
) (
  input  logic  clk_i,
  input  logic  rst_ni,

  input  logic  valid_i,
  output logic  ready_o,
  input  data_t data_i,

  output logic  valid_o,
  input  logic  ready_i,
  output data_t data_o,

  output logic  empty_o    // nothing is inside, visible or not
);
  if (Depth < 2) begin : g_check
    $error("block_fifo: Depth must be at least 2");
  end

  localparam int unsigned PtrW = $clog2(Depth);
  localparam int unsigned CntW = $clog2(Depth + 1);
  localparam logic [PtrW-1:0] Last = PtrW'(Depth - 1);

  (* ram_style = "block" *) data_t mem_q [Depth];
  data_t           out_q;
  logic [PtrW-1:0] head_q, tail_q;
  logic [CntW-1:0] used_q;          // places
  logic            valid_q, push, fetch;

  assign ready_o = used_q != CntW'(Depth);
  assign valid_o = valid_q;
  assign empty_o = used_q == '0 && !valid_q;
  assign data_o  = out_q;
  assign push    = valid_i && ready_o;
  assign fetch   = used_q != '0 && (!valid_q || ready_i);

  always_ff @(posedge clk_i) begin
    if (push) mem_q[tail_q] <= data_i;
    if (fetch) out_q <= mem_q[head_q];
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      head_q  <= '0;
      tail_q  <= '0;
      used_q  <= '0;
      valid_q <= 1'b0;
    end else begin
      valid_q <= fetch || (valid_q && !ready_i);
      if (fetch) head_q <= (head_q == Last) ? '0 : head_q + 1'b1;
      if (push) tail_q <= (tail_q == Last) ? '0 : tail_q + 1'b1;
      if (push != fetch) used_q <= push ? used_q + 1'b1 : used_q - 1'b1;
    end
  end

`ifndef SYNTHESIS
  stream_check #(.data_t(data_t)) u_check_out (
    .clk_i, .rst_ni, .valid_i(valid_o), .ready_i(ready_i), .data_i(data_o)
  );
`endif
endmodule
