// SPDX-License-Identifier: Apache-2.0
// A child of a node as a part of the scene: its box on the scene's grid, and its reference.
//   plane = min(origin + (plane << exp), 2^CoordFieldW - 1)      nothing of a legal scene lies beyond
// A box with a low plane above its high one holds nothing: its part refers to nothing.
//   s1  the child's planes, times 2^(exp's lower two bits)
//   s2  times the rest; the part
// One child a cycle, 2 cycles, never stalls; en_i[k]: stage k + 1 takes an item.
// bad_o: the node is illegal, or a child that is a node does not lie behind it. Combinational; without
// en_i[0] it is zero.
// Model: cpp_model/traverse/node_parts.hpp, equal bit for bit.
module node_parts
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       clk_i,

  input  logic [1:0] en_i,
  input  node_t      node_i,
  input  line_t      index_i,    // the node's own
  input  logic [1:0] child_i,
  output part_t      part_o,
  output logic       bad_o
);
  ref_word_t  word [4];
  child_box_t box  [4];
  assign word = '{node_i.ref0, node_i.ref1, node_i.ref2, node_i.ref3};
  assign box  = '{node_i.box0, node_i.box1, node_i.box2, node_i.box3};

  // ---- The child ----
  localparam int unsigned WideW = CoordFieldW + 6;
  typedef logic [$bits(plane_t)+2:0] near_t;   // a plane in part shifted
  typedef struct packed {
    near_t x0, x1, y0, y1, z0, z1;
  } near_box_t;
  function automatic near_t near(plane_t plane, plane_exp_t exp);
    return near_t'(plane) << exp[1:0];
  endfunction
  function automatic coord_t at(coord_t origin, near_t plane, plane_exp_t exp);
    logic [WideW-1:0] wide;
    wide = WideW'(origin) + (WideW'(plane) << {exp[$bits(exp)-1:2], 2'b0});
    return (wide[WideW-1:CoordFieldW] != '0) ? '1 : wide[CoordFieldW-1:0];
  endfunction
  typedef struct packed {
    coord_t     x, y, z;
    plane_exp_t exp_x, exp_y, exp_z;
  } grid_t;
  child_box_t planes;
  near_box_t  planes_q;
  ref_t       target_q;
  grid_t      grid_q;
  logic       turned;
  assign planes = box[child_i];
  assign turned = planes_q.x0 > planes_q.x1 || planes_q.y0 > planes_q.y1 || planes_q.z0 > planes_q.z1;
  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      planes_q <= '{
        x0: near(planes.x0, node_i.exp_x), x1: near(planes.x1, node_i.exp_x),
        y0: near(planes.y0, node_i.exp_y), y1: near(planes.y1, node_i.exp_y),
        z0: near(planes.z0, node_i.exp_z), z1: near(planes.z1, node_i.exp_z)
      };
      target_q <= ref_t'(word[child_i]);
      grid_q   <= '{x: node_i.x, y: node_i.y, z: node_i.z, exp_x: node_i.exp_x, exp_y: node_i.exp_y, exp_z: node_i.exp_z};
    end
    if (en_i[1]) begin
      part_o.target     <= turned ? '{kind: RefNone, index: '0} : target_q;
      part_o.box.low.x  <= at(grid_q.x, planes_q.x0, grid_q.exp_x);
      part_o.box.low.y  <= at(grid_q.y, planes_q.y0, grid_q.exp_y);
      part_o.box.low.z  <= at(grid_q.z, planes_q.z0, grid_q.exp_z);
      part_o.box.high.x <= at(grid_q.x, planes_q.x1, grid_q.exp_x);
      part_o.box.high.y <= at(grid_q.y, planes_q.y1, grid_q.exp_y);
      part_o.box.high.z <= at(grid_q.z, planes_q.z1, grid_q.exp_z);
    end
  end

  // ---- The node ----
  function automatic logic wide_grid(plane_exp_t exp);
    return exp > plane_exp_t'(MaxPlaneExp);
  endfunction
  always_comb begin
    logic none, none_before;
    ref_t target;
    none        = 1'b0;
    none_before = 1'b0;
    target      = '0;
    bad_o       = 1'b0;
    if (en_i[0]) begin
      bad_o = wide_grid(node_i.exp_x) || wide_grid(node_i.exp_y) || wide_grid(node_i.exp_z);
      for (int unsigned i = 0; i < 4; i++) begin
        target = ref_t'(word[i]);
        none   = word[i] == '0;
        if (!none && (word[i][31:$bits(ref_t)] != '0 || target.kind == RefNone || target.kind == RefTile)) bad_o = 1'b1;
        if (target.kind == RefNode && target.index <= index_i) bad_o = 1'b1;
        if (!none && none_before) bad_o = 1'b1;
        none_before = none;
      end
    end
  end
endmodule
