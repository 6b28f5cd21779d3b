// SPDX-License-Identifier: Apache-2.0
// The parts of a tile's frontier as nodes of a ray's kind, up to four parts each, on one grid.
//   measure   a part a cycle: the least and the greatest corner
//   extent    origin = least, extent = greatest - least
//   grid      exp = the smallest with extent >> exp <= 254, in two cycles
//   planes    a part a cycle, from the origin, the first while the grid is sought; a cycle later rounded
//             outward: low down, high up; a full node is written
// 2 n + 4 cycles for n parts, and one more for each that is not read at once; none for n = 0.
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
  typedef enum logic [1:0] {Measure, Extent, Planes, Finish} phase_t;
  phase_t     phase_q;
  logic [2:0] at_q, place_q;
  logic       last, read;
  logic       here_q, last_q;      // part place_q is at part_i, the last one
  logic       top_q, grid_q;       // the exponents are sought

  assign part_o = at_q;
  assign last   = 4'(at_q) + 4'd1 == parts_i;
  assign read   = start_i && part_read_i && phase_q inside {Measure, Planes};
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !start_i || done_o) begin
      phase_q <= Measure;
      at_q    <= '0;
      here_q  <= 1'b0;
      top_q   <= 1'b0;
      grid_q  <= 1'b0;
    end else begin
      unique case (phase_q)
        Measure: if (read && last) phase_q <= Extent;
        Extent:  if (!here_q) phase_q <= Planes;
        default: if (read && last) phase_q <= Finish;
      endcase
      if (read) at_q <= last ? '0 : at_q + 1'b1;
      here_q <= read;
      top_q  <= phase_q == Extent && !here_q;
      grid_q <= top_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (read) begin
      place_q <= at_q;
      last_q  <= last;
    end
  end

  // ---- Measure ----
  function automatic coord_t least(coord_t a, coord_t b);
    return (a < b) ? a : b;
  endfunction
  function automatic coord_t greatest(coord_t a, coord_t b);
    return (a > b) ? a : b;
  endfunction
  point_t low, high, low_q, high_q;
  logic   measure;
  assign low  = part_i.box.low;
  assign high = part_i.box.high;
  assign measure = here_q && phase_q inside {Measure, Extent};
  always_ff @(posedge clk_i) begin
    if (measure) begin
      low_q  <= (place_q == '0) ? low : '{x: least(low.x, low_q.x), y: least(low.y, low_q.y), z: least(low.z, low_q.z)};
      high_q <= (place_q == '0) ? high :
                '{x: greatest(high.x, high_q.x), y: greatest(high.y, high_q.y), z: greatest(high.z, high_q.z)};
    end
  end

  // ---- Grid: the eight bits from the extent's top one down, or one less fine if they are all ones ----
  function automatic plane_exp_t top_of(coord_t extent);
    plane_exp_t exp;
    exp = '0;
    for (int unsigned i = 1; i <= CoordFieldW - 8; i++) if (extent[i+7]) exp = plane_exp_t'(i);
    return exp;
  endfunction
  function automatic plane_exp_t exp_of(coord_t extent, plane_exp_t exp);
    return ((extent >> exp) == coord_t'(255)) ? exp + 1'b1 : exp;
  endfunction
  point_t     extent_q;
  plane_exp_t exp_x_q, exp_y_q, exp_z_q;
  always_ff @(posedge clk_i) begin
    if (phase_q == Extent) extent_q <= '{x: high_q.x - low_q.x, y: high_q.y - low_q.y, z: high_q.z - low_q.z};
    if (top_q) begin
      exp_x_q <= top_of(extent_q.x);
      exp_y_q <= top_of(extent_q.y);
      exp_z_q <= top_of(extent_q.z);
    end
    if (grid_q) begin
      exp_x_q <= exp_of(extent_q.x, exp_x_q);
      exp_y_q <= exp_of(extent_q.y, exp_y_q);
      exp_z_q <= exp_of(extent_q.z, exp_z_q);
    end
  end

  // ---- Planes ----
  function automatic plane_t down(coord_t away, plane_exp_t exp);
    return plane_t'(away >> exp);
  endfunction
  function automatic plane_t up(coord_t away, plane_exp_t exp);
    return plane_t'(away >> exp) + plane_t'((away & ~({CoordFieldW{1'b1}} << exp)) != '0);
  endfunction
  child_box_t       box, none;
  child_box_t [2:0] boxes_q;      // of the node's parts so far
  ref_word_t  [2:0] words_q;
  ref_word_t        word;
  logic [3:0]       there;
  point_t           near_q, far_q;     // the part's corners from the origin
  ref_t             target_q;
  logic             there_q, end_q;    // its corners are there, the last one's
  logic [2:0]       there_place_q;
  assign none = '0;
  assign done_o = there_q && end_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) there_q <= 1'b0;
    else there_q <= here_q && !measure;
  end
  always_ff @(posedge clk_i) begin
    if (here_q && !measure) begin
      near_q        <= '{x: low.x - low_q.x, y: low.y - low_q.y, z: low.z - low_q.z};
      far_q         <= '{x: high.x - low_q.x, y: high.y - low_q.y, z: high.z - low_q.z};
      target_q      <= part_i.target;
      end_q         <= last_q;
      there_place_q <= place_q;
    end
  end
  always_comb begin
    box = '0;
    if (there_q) begin
      box = '{
        x0: down(near_q.x, exp_x_q), x1: up(far_q.x, exp_x_q),
        y0: down(near_q.y, exp_y_q), y1: up(far_q.y, exp_y_q),
        z0: down(near_q.z, exp_z_q), z1: up(far_q.z, exp_z_q)
      };
    end
  end
  assign word = 32'(target_q);
  always_ff @(posedge clk_i) begin
    if (there_q) begin
      for (int unsigned i = 0; i < 3; i++) begin
        if (there_place_q[1:0] == 2'(i)) begin
          boxes_q[i] <= box;
          words_q[i] <= word;
        end
      end
    end
  end

  assign there    = 4'b1111 >> (2'd3 - there_place_q[1:0]);   // the node's parts, this one included
  assign write_o  = there_q && (end_q || there_place_q[1:0] == 2'd3);
  assign second_o = there_place_q[2];
  function automatic child_box_t box_at(int unsigned i);
    return !there[i] ? none : (there_place_q[1:0] == 2'(i)) ? box : boxes_q[i % 3];
  endfunction
  function automatic ref_word_t word_at(int unsigned i);
    return !there[i] ? '0 : (there_place_q[1:0] == 2'(i)) ? word : words_q[i % 3];
  endfunction
  always_comb begin
    node_o = '0;
    if (write_o) begin
      node_o = '{
        x: low_q.x, y: low_q.y, z: low_q.z, exp_x: exp_x_q, exp_y: exp_y_q, exp_z: exp_z_q,
        ref0: word_at(0), ref1: word_at(1), ref2: word_at(2), ref3: word_at(3),
        box0: box_at(0), box1: box_at(1), box2: box_at(2), box3: box_at(3), reserved: '0
      };
    end
  end
endmodule
