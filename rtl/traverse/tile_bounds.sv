// SPDX-License-Identifier: Apache-2.0
// What the directions of all rays of a tile lie between, from the rays of its four corner pixels in
// the order of the walk. t runs along the ray, so dx/dt is sx, or -sx where neg.
//   low  = floor((least - 2^-ShearFrac) 2^16) 2^-16      of the four, and one last bit beyond
//   high = ceil((most + 2^-ShearFrac) 2^16) 2^-16        (docs/tile-start.md)
// valid: all four are valid and have the same dominant axis and sign. One tile for each four rays,
// a cycle after the fourth.
// Model: cpp_model/traverse/tile_bounds.hpp, equal bit for bit.
module tile_bounds
  import castray_cfg_pkg::*;
  import castray_pkg::*;
(
  input  logic         clk_i,
  input  logic         rst_ni,

  input  logic         in_valid_i,
  output logic         in_ready_o,
  input  ray_t         in_i,

  output logic         out_valid_o,
  input  logic         out_ready_i,
  output tile_bounds_t out_o
);
  localparam int unsigned Drop = ShearFrac - TileSlopeFrac;
  typedef logic signed [ShearFrac+1:0] wide_t;

  // ---- Out once all four are in ----
  logic last;
  pipe_chain #(.Stages(1)) u_full (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i && last), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .load_o()
  );

  // ---- The range of sx and sy so far; a tile whose rays differ in neg has no bounds ----
  typedef struct packed {
    shear_t least, most;
  } range_t;
  logic [1:0] count_q;
  logic       first, take, same;
  logic       valid_q, neg_q;
  axis_t      axis_q;
  range_t     x_q, y_q, x, y;

  assign first   = count_q == 2'd0;
  assign last    = count_q == 2'd3;
  assign take    = in_valid_i && in_ready_o;
  assign same    = in_i.valid && (first || (valid_q && in_i.axis == axis_q && in_i.neg == neg_q));

  function automatic range_t widened(range_t range, shear_t slope, logic alone);
    shear_t least, most;
    least = range.least;
    most  = range.most;
    return '{least: (alone || slope < least) ? slope : least, most: (alone || slope > most) ? slope : most};
  endfunction
  always_comb begin
    x = '0;
    y = '0;
    if (in_valid_i) begin
      x = widened(x_q, in_i.sx, first);
      y = widened(y_q, in_i.sy, first);
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q <= '0;
    end else begin
      if (take) count_q <= count_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      x_q     <= x;
      y_q     <= y;
      valid_q <= same;
      if (first) axis_q <= in_i.axis;
      if (first) neg_q  <= in_i.neg;
    end
  end

  // ---- Of the slopes, rounded outward; -s is ~s + 1 ----
  function automatic tile_slope_t low_of(range_t range, logic neg);
    shear_t least;
    least = neg ? ~range.most : range.least;
    return tile_slope_t'((wide_t'(least) - wide_t'(!neg)) >>> Drop);
  endfunction
  function automatic tile_slope_t high_of(range_t range, logic neg);
    shear_t most;
    most = neg ? ~range.least : range.most;
    return tile_slope_t'((wide_t'(most) + (wide_t'(1) <<< Drop) + wide_t'(neg)) >>> Drop);
  endfunction

  always_comb begin
    out_o = '0;
    if (out_valid_o) begin
      out_o = '{valid: valid_q, axis: axis_q, neg: neg_q,
                x_low: low_of(x_q, neg_q), x_high: high_of(x_q, neg_q), y_low: low_of(y_q, neg_q), y_high: high_of(y_q, neg_q)};
    end
  end
endmodule
