// SPDX-License-Identifier: Apache-2.0
// A child of a node as a part of the scene: its box on the scene's grid, and its reference.
//   plane = min(origin + (plane << exp), 2^CoordFieldW - 1)      nothing of a legal scene lies beyond
// A box with a low plane above its high one holds nothing: its part refers to nothing.
// bad_o: the node is illegal, or a child that is a node does not lie behind it. Combinational.
// Model: cpp_model/traverse/node_parts.hpp, equal bit for bit.
module node_parts
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
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
  assign planes = box[child_i];
  logic       turned;
  assign turned = planes.x0 > planes.x1 || planes.y0 > planes.y1 || planes.z0 > planes.z1;
  assign part_o.target     = turned ? '{kind: RefNone, index: '0} : ref_t'(word[child_i]);
  assign part_o.box.low.x  = at(node_i.x, planes.x0, node_i.exp_x);
  assign part_o.box.low.y  = at(node_i.y, planes.y0, node_i.exp_y);
  assign part_o.box.low.z  = at(node_i.z, planes.z0, node_i.exp_z);
  assign part_o.box.high.x = at(node_i.x, planes.x1, node_i.exp_x);
  assign part_o.box.high.y = at(node_i.y, planes.y1, node_i.exp_y);
  assign part_o.box.high.z = at(node_i.z, planes.z1, node_i.exp_z);

  // ---- The node ----
  logic [3:0] none, wrong;
  for (genvar i = 0; i < 4; i++) begin : g_child
    ref_t target;
    assign target  = ref_t'(word[i]);
    assign none[i] = word[i] == '0;
    always_comb begin
      wrong[i] = !none[i] && (word[i][31:$bits(ref_t)] != '0 || target.kind == RefNone || target.kind == RefTile);
      if (target.kind == RefNode && target.index <= index_i) wrong[i] = 1'b1;
      if (i > 0 && !none[i] && none[(i > 0) ? i - 1 : 0]) wrong[i] = 1'b1;
    end
  end
  function automatic logic wide_grid(plane_exp_t exp);
    return exp > plane_exp_t'(MaxPlaneExp);
  endfunction
  assign bad_o = (|wrong) || wide_grid(node_i.exp_x) || wide_grid(node_i.exp_y) || wide_grid(node_i.exp_z);
endmodule
