// SPDX-License-Identifier: Apache-2.0
// Follows one item, any one, from where it enters a unit to where it leaves it. choose_i is free, so what is
// proved of the item that it chose is proved of every item.
//   nothing_invented      nothing is offered while nothing is inside
//   unchanged_in_order    what is offered when all that came before the followed item has left is that item
//   not_more_than_fits    at most Most items are inside
// That what is inside is offered in time is for the unit's own proof.
module stream_follow #(
  parameter type         data_t = logic,
  parameter int unsigned Most   = 2,
  localparam int unsigned CntW  = $clog2(Most + 2)
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic            choose_i,

  input  logic            push_i,
  input  data_t           in_i,
  input  logic            out_valid_i,
  input  logic            out_ready_i,
  input  data_t           out_i,

  output logic [CntW-1:0] inside_o,     // items that entered and have not left
  output logic            follows_o,    // the followed item is inside,
  output logic [CntW-1:0] ahead_o,      // behind so many
  output data_t           item_o
);
  logic [CntW-1:0] inside_q, ahead_q;
  logic            follows_q, pop;
  data_t           item_q;
  assign inside_o  = inside_q;
  assign follows_o = follows_q;
  assign ahead_o   = ahead_q;
  assign item_o    = item_q;
  assign pop       = out_valid_i && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      inside_q  <= '0;
      follows_q <= 1'b0;
    end else begin
      inside_q <= inside_q + CntW'(push_i) - CntW'(pop);
      if (!follows_q) begin
        follows_q <= push_i && choose_i;
        item_q    <= in_i;
        ahead_q   <= inside_q - CntW'(pop);
      end else if (pop) begin
        follows_q <= ahead_q != '0;
        ahead_q   <= ahead_q - 1'b1;
      end
    end
  end

  always_comb begin
    if (rst_ni) begin
      if (out_valid_i) nothing_invented: assert (inside_q != '0);
      if (out_valid_i && follows_q && ahead_q == '0) unchanged_in_order: assert (out_i == item_q);
      not_more_than_fits: assert (inside_q <= CntW'(Most));
      if (follows_q) inv_ahead: assert (ahead_q < inside_q);
    end
  end
endmodule
