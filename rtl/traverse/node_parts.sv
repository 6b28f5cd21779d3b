// SPDX-License-Identifier: Apache-2.0
// A child of a node as a part of the scene: its box on the scene's grid, and its reference.
//   plane = min(origin + (plane << exp), 2^CoordFieldW - 1)      nothing of a legal scene lies beyond
// A box with a low plane above its high one holds nothing: its part refers to nothing.
// bad_o: the node is illegal, or a child that is a node does not lie behind it. Combinational; without
// valid_i all is zero.
// Model: cpp_model/traverse/node_parts.hpp, equal bit for bit.
module node_parts
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       valid_i,
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
  function automatic coord_t at(coord_t origin, plane_t plane, plane_exp_t exp);
    logic [WideW-1:0] wide;
    wide = WideW'(origin) + (WideW'(plane) << exp);
    return (wide[WideW-1:CoordFieldW] != '0) ? '1 : wide[CoordFieldW-1:0];
  endfunction
  child_box_t planes;
  logic       turned;
  always_comb begin
    planes = '0;
    turned = 1'b0;
    part_o = '0;
    if (valid_i) begin
      planes            = box[child_i];
      turned            = planes.x0 > planes.x1 || planes.y0 > planes.y1 || planes.z0 > planes.z1;
      part_o.target     = turned ? '{kind: RefNone, index: '0} : ref_t'(word[child_i]);
      part_o.box.low.x  = at(node_i.x, planes.x0, node_i.exp_x);
      part_o.box.low.y  = at(node_i.y, planes.y0, node_i.exp_y);
      part_o.box.low.z  = at(node_i.z, planes.z0, node_i.exp_z);
      part_o.box.high.x = at(node_i.x, planes.x1, node_i.exp_x);
      part_o.box.high.y = at(node_i.y, planes.y1, node_i.exp_y);
      part_o.box.high.z = at(node_i.z, planes.z1, node_i.exp_z);
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
    if (valid_i) begin
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
