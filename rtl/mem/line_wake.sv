// SPDX-License-Identifier: Apache-2.0
// Lines that came, and whose chains of line_misses are still to be served: Depth of them, first
// come first served, one of a chain a cycle. busy_o: a line of this set is among them; it must not
// be replaced.
module line_wake #(
  parameter type         id_t  = logic [5:0],
  parameter int unsigned SetW  = 8,
  parameter int unsigned WayW  = 1,
  parameter int unsigned Depth = 4
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  input  logic                 push_i,
  output logic                 ready_o,
  input  id_t                  head_i,
  input  logic [SetW+WayW-1:0] place_i,

  input  logic [SetW-1:0]      set_i,
  output logic                 busy_o,

  output logic                 out_valid_o,
  input  logic                 out_ready_i,
  output id_t                  out_id_o,
  output logic [SetW+WayW-1:0] out_place_o,
  input  id_t                  next_i        // of out_id_o: itself at the end of its chain
);
  typedef struct packed {
    id_t                  head;
    logic [SetW+WayW-1:0] place;
  } line_t;
  line_t            line_q [Depth];   // the one being served at 0
  logic [Depth-1:0] valid_q;
  logic             take, finish;

  assign ready_o     = !valid_q[Depth-1];
  assign out_valid_o = valid_q[0];
  assign out_id_o    = line_q[0].head;
  assign out_place_o = line_q[0].place;
  assign take        = out_valid_o && out_ready_i;
  assign finish      = take && next_i == out_id_o;

  always_comb begin
    busy_o = 1'b0;
    if (valid_q[0]) begin
      for (int unsigned i = 0; i < Depth; i++)
        busy_o |= valid_q[i] && line_q[i].place[WayW +: SetW] == set_i;
    end
  end

  // A line enters at the first place that is free after this cycle.
  logic [Depth-1:0] kept;
  assign kept = finish ? valid_q >> 1 : valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (push_i || finish) valid_q <= push_i ? Depth'({kept, 1'b1}) : kept;
  end
  always_ff @(posedge clk_i) begin
    if (finish) begin
      for (int unsigned i = 0; i + 1 < Depth; i++) line_q[i] <= line_q[i+1];
    end else if (take) begin
      line_q[0].head <= next_i;
    end
    if (push_i) begin
      for (int unsigned i = 0; i < Depth; i++)
        if (!kept[i] && (i == 0 || kept[i-1])) line_q[i] <= '{head: head_i, place: place_i};
    end
  end
endmodule
