// SPDX-License-Identifier: Apache-2.0
// Whether some ray of a tile may meet what a box holds: the tile's rays, as a pyramid, against the box,
// in each of the two axes that are not dominant.
//   s1  the box from the eye, on permuted axes; t0, t1: where it lies along the dominant axis
//   s2  operands: for each of four sides the t that reaches farthest, and the plane to be reached
//   s3  t slope                                         27 x 18, four DSPs
//   s4  meets: t1 >= -BoxMargin, and each product >= plane - BoxMargin (docs/tile-start.md)
// One box a cycle, four cycles, never stalls.
// Model: cpp_model/traverse/tile_box.hpp, equal bit for bit.
module tile_box
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Stages = 4   // what its user counts on: no other number is legal
) (
  input  logic         clk_i,
  input  logic         rst_ni,

  input  logic         in_valid_i,
  input  tile_bounds_t bounds_i,
  input  point_t       eye_i,
  input  box_t         box_i,

  output logic         out_valid_o,
  output logic         meets_o
);
  if (Stages != 4) begin : g_check
    $error("tile_box: a box takes 4 cycles, not %0d", Stages);
  end
  localparam logic signed [CoordW+1:0] Slack = (CoordW+2)'(BoxMargin);
  typedef logic signed [CoordW+1:0]                wide_t;     // a delta and the slack
  typedef logic signed [CoordW+TileSlopeFrac+2:0]  product_t;

  logic [Stages-1:0] live;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_o(), .valid_o(out_valid_o), .ready_i(1'b1), .load_o(live)
  );

  // ---- s1 ----
  delta_t low_x, low_y, low_z, high_x, high_y, high_z;
  corner_delta #(.Points(2)) u_delta (
    .point_i(box_i), .org_i(permute(eye_i, bounds_i.axis)), .axis_i(bounds_i.axis),   // {high, low}
    .x_o({high_x, low_x}), .y_o({high_y, low_y}), .z_o({high_z, low_z})
  );

  function automatic delta_t not_negative(delta_t t);
    return t[CoordW] ? '0 : t;
  endfunction

  delta_t       first, last, t0_q, t1_q, low_x_q, low_y_q, high_x_q, high_y_q;
  logic         ahead_q;
  tile_bounds_t bounds_q;
  assign first = bounds_i.neg ? -high_z : low_z;
  assign last  = bounds_i.neg ? -low_z : high_z;
  always_ff @(posedge clk_i) begin
    if (live[0]) begin
      t0_q     <= not_negative(first);
      t1_q     <= not_negative(last);
      ahead_q  <= wide_t'(last) >= -Slack;
      low_x_q  <= low_x;
      low_y_q  <= low_y;
      high_x_q <= high_x;
      high_y_q <= high_y;
      bounds_q <= bounds_i;
    end
  end

  // ---- s2 to s4, a side each: x low, x high, y low, y high ----
  tile_slope_t slope [4];
  delta_t      plane [4];
  logic [3:0]  reached;
  logic        ahead2_q, ahead3_q;
  assign slope = '{bounds_q.x_high, -bounds_q.x_low, bounds_q.y_high, -bounds_q.y_low};
  assign plane = '{low_x_q, -high_x_q, low_y_q, -high_y_q};

  for (genvar i = 0; i < 4; i++) begin : g_side
    delta_t      t_q;
    tile_slope_t slope_q, side;
    wide_t       plane_q, plane3_q;
    product_t    product_q;
    assign side = slope[i];
    always_ff @(posedge clk_i) begin
      if (live[1]) begin
        t_q     <= side[TileSlopeFrac+1] ? t0_q : t1_q;
        slope_q <= side;
        plane_q <= wide_t'(plane[i]) - Slack;
      end
      if (live[2]) begin
        product_q <= product_t'(t_q) * product_t'(slope_q);
        plane3_q  <= plane_q;
      end
    end
    assign reached[i] = product_q >= (product_t'(plane3_q) <<< TileSlopeFrac);
  end
  always_ff @(posedge clk_i) begin
    if (live[1]) ahead2_q <= ahead_q;
    if (live[2]) ahead3_q <= ahead2_q;
    if (live[3]) meets_o <= ahead3_q && (&reached);
  end
endmodule
