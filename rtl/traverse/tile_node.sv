// SPDX-License-Identifier: Apache-2.0
// The parts of a tile's frontier as nodes of a ray's kind, up to four parts each, on one grid. After
// the measure one axis each cycle, with one subtraction and one shift of either corner:
//   measure   the least and the greatest corner: a part a cycle
//   extent    origin = least, extent = greatest - least: x, y, z
//   planes    the corners from the origin, x, y, z of each part
// In the pipe:
//   s1  the low and the high corner on the axis
//   s2  low - origin, high - origin
//   s3  of an extent exp = the smallest with eight bits left, or the axis' own
//   s4  shifted; planes rounded outward, low down, high up; the exp of an extent is one more where all
//       eight bits are ones: extent >> exp <= 254
//   s5  a node that is full, or the last, is written
// 4 n + 8 cycles for n parts, and one more for each time that one is not read at once; none for n = 0.
// Model: cpp_model/traverse/tile_node.hpp, equal bit for bit.
module tile_node
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       start_i,      // held until done_o; parts stand still as long
  input  logic [3:0] parts_i,      // 1 to TileParts
  output logic       done_o,       // in the last cycle

  output logic [2:0] part_o,       // which is wanted
  input  logic       part_read_i,  // it is read, and comes a cycle later
  input  part_t      part_i,

  output logic       write_o,
  output logic       second_o,     // of the two nodes
  output node_t      node_o
);
  // ---- What is done in a cycle ----
  typedef enum logic [1:0] {Measure, Extent, Planes, Finish} phase_t;
  typedef struct packed {
    phase_t     phase;
    logic [2:0] at;      // the part
    logic       last;    // it is the last one
    axis_t      axis;
  } step_t;
  localparam int unsigned Stages = 4;
  step_t             step, step_q [Stages + 1];   // of the part that comes, then of s1 on
  logic              go;
  logic [Stages:0]   valid_q;
  phase_t            phase_q;
  logic [2:0]        at_q;
  axis_t             axis_q;
  assign part_o = at_q;
  assign step   = '{phase: phase_q, at: at_q, last: 4'(at_q) + 4'd1 == parts_i, axis: axis_q};
  assign go     = start_i && (phase_q == Extent || (phase_q != Finish && part_read_i));
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !start_i || done_o) begin
      phase_q <= Measure;
      at_q    <= '0;
      axis_q  <= '0;
      valid_q <= '0;
    end else begin
      valid_q <= {valid_q[Stages-1:0], go};
      if (go && phase_q != Measure) axis_q <= (axis_q == 2'd2) ? '0 : axis_q + 1'b1;
      if (go && (phase_q == Measure || axis_q == 2'd2)) begin
        if (phase_q == Extent) phase_q <= Planes;
        else begin
          at_q <= step.last ? '0 : at_q + 1'b1;
          if (step.last) phase_q <= (phase_q == Measure) ? Extent : Finish;
        end
      end
    end
  end
  always_ff @(posedge clk_i) begin
    step_q[0] <= step;
    for (int unsigned i = 1; i <= Stages; i++) step_q[i] <= step_q[i-1];
  end

  // ---- Measure ----
  point_t low, high, least_q, most_q;
  logic   first;
  assign low   = part_i.box.low;
  assign high  = part_i.box.high;
  assign first = step_q[0].at == '0;
  always_ff @(posedge clk_i) begin
    if (valid_q[0] && step_q[0].phase == Measure) begin
      if (first || low.x < least_q.x) least_q.x <= low.x;
      if (first || low.y < least_q.y) least_q.y <= low.y;
      if (first || low.z < least_q.z) least_q.z <= low.z;
      if (first || high.x > most_q.x) most_q.x <= high.x;
      if (first || high.y > most_q.y) most_q.y <= high.y;
      if (first || high.z > most_q.z) most_q.z <= high.z;
    end
  end

  // ---- s1: one axis of the corners; of an extent, of the greatest ----
  function automatic coord_t along(point_t p, axis_t axis);
    return (axis == 2'd0) ? p.x : (axis == 2'd1) ? p.y : p.z;
  endfunction
  coord_t low_q, high_q;
  ref_t   target_q [Stages - 1];   // of s1 to s3
  always_ff @(posedge clk_i) begin
    if (valid_q[0]) begin
      low_q  <= along(low, step_q[0].axis);
      high_q <= along((step_q[0].phase == Extent) ? most_q : high, step_q[0].axis);
      target_q[0] <= part_i.target;
    end
    for (int unsigned i = 1; i < Stages - 1; i++) if (valid_q[i]) target_q[i] <= target_q[i-1];
  end

  // ---- s2: from the origin ----
  coord_t origin, near_q, far_q;
  assign origin = along(least_q, step_q[1].axis);
  always_ff @(posedge clk_i) begin
    if (valid_q[1]) begin
      near_q <= low_q - origin;
      far_q  <= high_q - origin;
    end
  end

  // ---- s3: the grid, of an extent the eight bits from its top one down ----
  function automatic plane_exp_t top_of(coord_t extent);
    plane_exp_t exp;
    exp = '0;
    for (int unsigned i = 1; i <= CoordFieldW - 8; i++) if (extent[i+7]) exp = plane_exp_t'(i);
    return exp;
  endfunction
  plane_exp_t exp_x_q, exp_y_q, exp_z_q, exp_q;
  coord_t     near_s3_q, far_s3_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[2]) begin
      near_s3_q <= near_q;
      far_s3_q  <= far_q;
      if (step_q[2].phase == Extent) exp_q <= top_of(far_q);
      else exp_q <= (step_q[2].axis == 2'd0) ? exp_x_q : (step_q[2].axis == 2'd1) ? exp_y_q : exp_z_q;
    end
  end

  // ---- s4: planes into the node's boxes; or one less fine if they are all ones ----
  plane_t           down, up;
  plane_exp_t       exp;
  child_box_t [3:0] box_q;
  ref_word_t  [3:0] word_q;
  logic       [1:0] place;
  assign down  = plane_t'(near_s3_q >> exp_q);
  assign up    = plane_t'(far_s3_q >> exp_q) + plane_t'((far_s3_q & ~({CoordFieldW{1'b1}} << exp_q)) != '0);
  assign exp   = (plane_t'(far_s3_q >> exp_q) == '1) ? exp_q + 1'b1 : exp_q;
  assign place = step_q[3].at[1:0];
  always_ff @(posedge clk_i) begin
    if (valid_q[3] && step_q[3].phase == Planes) begin
      if (place == '0 && step_q[3].axis == '0) begin   // parts that the node may not have
        box_q  <= '0;
        word_q <= '0;
      end
      word_q[place] <= 32'(target_q[2]);
      unique case (step_q[3].axis)
        2'd0:    {box_q[place].x1, box_q[place].x0} <= {up, down};
        2'd1:    {box_q[place].y1, box_q[place].y0} <= {up, down};
        default: {box_q[place].z1, box_q[place].z0} <= {up, down};
      endcase
    end
  end
  always_ff @(posedge clk_i) begin
    if (valid_q[3] && step_q[3].phase == Extent) begin
      unique case (step_q[3].axis)
        2'd0:    exp_x_q <= exp;
        2'd1:    exp_y_q <= exp;
        default: exp_z_q <= exp;
      endcase
    end
  end

  // ---- s5 ----
  assign write_o  = valid_q[4] && step_q[4].phase == Planes && step_q[4].axis == 2'd2 &&
                    (step_q[4].last || step_q[4].at[1:0] == 2'd3);
  assign done_o   = write_o && step_q[4].last;
  assign second_o = step_q[4].at[2];
  assign node_o   = '{
    x: least_q.x, y: least_q.y, z: least_q.z, exp_x: exp_x_q, exp_y: exp_y_q, exp_z: exp_z_q,
    ref0: word_q[0], ref1: word_q[1], ref2: word_q[2], ref3: word_q[3],
    box0: box_q[0], box1: box_q[1], box2: box_q[2], box3: box_q[3], reserved: '0
  };
endmodule
