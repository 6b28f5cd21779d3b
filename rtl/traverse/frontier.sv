// SPDX-License-Identifier: Apache-2.0
// For each of Tiles tiles in flight, the parts of the scene that its rays may meet: at most TileParts,
// from the root down. A part that is a node waits; the first that waits is read, and its children that
// the tile may meet take its place if there is room for them, else it stays. A tile is finished when
// none waits, or none may be read any more: then its rays start at the root, as they do where its
// bounds are not valid or the root is a leaf.
//   ask     a node, by the number of its tile
//   split   four cycles a node: its children through node_parts into tile_box
//   met     as they come out: appended to the tile's kept parts, or to those that wait
//   judge   with the last: too many, then the lists are as they were, and the node is kept; else
//           the new ones count
//   decide  a cycle later: the next that waits is asked for, or the tile is finished
// Tiles are finished in any order and leave in theirs. part_o is the part part_i of the tile offered, a cycle
// later, if it was read: not where the lists' one read is for a node, before judge and before decide.
// Model: cpp_model/traverse/frontier.hpp, equal bit for bit.
module frontier
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Tiles = StartTiles   // a power of two
) (
  input  logic         clk_i,
  input  logic         rst_ni,

  input  point_t       eye_i,        // eye and root stand still
  input  ref_t         root_i,
  output error_t       fault_o,

  input  logic         in_valid_i,
  output logic         in_ready_o,
  input  tile_bounds_t in_i,

  output logic         ask_valid_o,  // at most one for a tile: whoever takes it has room for all
  output ctx_t         ask_tile_o,
  output line_t        ask_index_o,

  input  logic         node_valid_i,
  output logic         node_ready_o,
  input  ctx_t         node_tile_i,
  input  node_t        node_i,

  output logic         out_valid_o,
  input  logic         out_ready_i,
  output logic         out_root_o,   // the tile's rays start at the root
  output logic [3:0]   out_parts_o,  // else at so many parts
  input  logic [2:0]   part_i,
  output logic         part_read_o,
  output part_t        part_o,
  output logic         read_o        // a node was read: for the counter
);
  if (Tiles < 2 || (Tiles & (Tiles - 1)) != 0 || Tiles > 2 ** $bits(ctx_t)) begin : g_check
    $error("frontier: Tiles must be a power of two, 2 to %0d", 2 ** $bits(ctx_t));
  end

  localparam int unsigned IdxW   = $clog2(Tiles);
  localparam int unsigned Places = 16;   // of a list: eight, and four that do not count yet
  localparam int unsigned ReadW  = $clog2(TileReads + 1);
  localparam int unsigned Stages = 4;    // of tile_box, which refuses another number
  localparam int unsigned Ring   = 8;    // children there are places for, a cycle each: a power of two
  if (Ring <= Stages) begin : g_ring
    $error("frontier: a child's place is given away before the child comes out of tile_box");
  end
  typedef logic [IdxW-1:0] tile_no_t;
  typedef logic [3:0]      count_t;

  // ---- Tiles, in a ring ----
  tile_no_t         enter_q, leave_q;
  tile_no_t         judged_q;         // whose node was judged in the cycle before
  logic [Tiles-1:0] used_q, finished_q, root_q;
  tile_bounds_t     bounds_q [Tiles];
  logic             enter, at_root, leave, ask_next, finish, spent;
  assign in_ready_o  = !used_q[enter_q] && !ask_next;
  assign enter       = in_valid_i && in_ready_o;
  assign at_root     = !in_i.valid || root_i.kind != RefNode;
  assign out_valid_o = used_q[leave_q] && finished_q[leave_q];
  assign out_root_o  = root_q[leave_q];
  assign leave       = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      enter_q <= '0;
      leave_q <= '0;
      used_q  <= '0;
    end else begin
      if (enter) begin
        enter_q         <= enter_q + 1'b1;
        used_q[enter_q] <= 1'b1;
      end
      if (leave) begin
        leave_q         <= leave_q + 1'b1;
        used_q[leave_q] <= 1'b0;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (enter) begin
      bounds_q[enter_q]   <= in_i;
      finished_q[enter_q] <= at_root;
      root_q[enter_q]     <= at_root;
    end
    if (finish) finished_q[judged_q] <= 1'b1;
    if (finish) root_q[judged_q]     <= spent;
  end

  // ---- Split ----
  logic [1:0] split_q;
  tile_no_t   node_tile;
  part_t      part;
  logic       bad;
  line_t      index_q [Tiles];    // of the node of each tile that is read
  assign node_ready_o = split_q == '1;
  assign node_tile    = tile_no_t'(node_tile_i);
  assign read_o       = node_valid_i && node_ready_o;
  assign fault_o      = (read_o && bad) ? ErrNode : ErrNone;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) split_q <= '0;
    else if (node_valid_i) split_q <= split_q + 1'b1;
  end
  logic [2:0] live;    // a child enters node_parts' s1, its s2, tile_box
  logic [2:1] live_q;
  assign live = {live_q, node_valid_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) live_q <= '0;
    else live_q <= live[1:0];
  end
  node_parts u_parts (
    .clk_i, .en_i(live[1:0]), .node_i, .index_i(index_q[node_tile]), .child_i(split_q), .part_o(part), .bad_o(bad)
  );

  // ---- The box against the tile's rays, and what is needed of the child behind that ----
  typedef struct packed {
    tile_no_t   tile;
    logic [1:0] child;
  } step_t;
  logic       box_valid, meets;
  step_t      step_q [2];     // of the stages of node_parts
  typedef logic [$clog2(Ring)-1:0] place_t;
  step_t      side_q [Ring];
  place_t     place_q;
  part_t      parts_q [Ring];
  tile_box #(.Stages(Stages)) u_tile_box (
    .clk_i, .rst_ni, .in_valid_i(live[2]), .bounds_i(bounds_q[step_q[1].tile]), .eye_i,
    .box_i(part.box), .out_valid_o(box_valid), .meets_o(meets)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= '0;
    else place_q <= place_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (live[0]) step_q[0] <= '{tile: node_tile, child: split_q};
    if (live[1]) step_q[1] <= step_q[0];
    if (live[2]) begin
      side_q[place_q]  <= step_q[1];
      parts_q[place_q] <= part;
    end
  end

  // ---- The lists of each tile: parts that wait, from first_q on, and that are kept ----
  (* ram_style = "block" *) part_t list_q [2 * Tiles * Places];
  typedef struct packed {
    logic     is_kept;
    tile_no_t tile;
    count_t   place;
  } at_t;
  part_t            read_q;
  at_t              read_at, write_at;
  count_t           kept_count_q [Tiles], waiting_count_q [Tiles], first_q [Tiles];
  logic [ReadW-1:0] reads_q [Tiles];

  step_t    side;
  tile_no_t tile;                 // whose child came
  part_t    met;
  line_t    look, new_index_q;
  count_t   new_kept_q, new_waiting_q, new_kept, new_waiting, kept, waiting, first;
  logic     is_met, keeps, waits, judge, decide_q, too_many, read_node, look_is_new_q;
  assign side        = side_q[place_q - place_t'(Stages)];
  assign met         = parts_q[place_q - place_t'(Stages)];
  assign tile        = side.tile;
  assign kept        = kept_count_q[tile];
  assign waiting     = waiting_count_q[tile];
  assign first       = first_q[tile];
  assign is_met      = box_valid && meets && met.target.kind != RefNone;
  assign keeps       = is_met && met.target.kind == RefLeaf;
  assign waits       = is_met && met.target.kind != RefLeaf;
  assign new_kept    = new_kept_q + count_t'(keeps);
  assign new_waiting = new_waiting_q + count_t'(waits);
  assign judge       = box_valid && side.child == '1;
  assign too_many    = judge && kept + waiting + new_kept + new_waiting > count_t'(TileParts);

  always_ff @(posedge clk_i) begin
    if (!rst_ni || judge) begin
      new_kept_q    <= '0;
      new_waiting_q <= '0;
    end else if (is_met) begin
      new_kept_q    <= new_kept;
      new_waiting_q <= new_waiting;
    end
  end
  // A node is read a cycle before it is judged; the next that waits as it is judged, where it is not just
  // then written.
  assign read_node = box_valid && side.child[1];
  always_comb begin
    read_at  = '{is_kept: 1'b0, tile: tile, place: judge ? first : first - 1'b1};
    write_at = '{is_kept: too_many || keeps, tile: tile, place: first + waiting + new_waiting_q};
    if (!read_node) read_at = '{is_kept: 1'b1, tile: leave_q, place: count_t'(part_i)};
    if (too_many) write_at.place = kept;
    else if (keeps) write_at.place = kept + new_kept_q;
  end
  always_ff @(posedge clk_i) begin
    if (is_met || too_many) list_q[write_at] <= too_many ? read_q : met;   // the node itself
    if (read_node || out_valid_o) read_q <= list_q[read_at];
  end
  always_ff @(posedge clk_i) begin
    if (judge) begin
      look_is_new_q <= waits && waiting + new_waiting_q == '0;
      new_index_q   <= met.target.index;
    end
  end

  assign look     = look_is_new_q ? new_index_q : read_q.target.index;
  assign spent    = waiting_count_q[judged_q] != '0;
  assign ask_next = decide_q && spent && reads_q[judged_q] != ReadW'(TileReads);
  assign finish   = decide_q && !ask_next;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) decide_q <= 1'b0;
    else decide_q <= judge;
  end
  always_ff @(posedge clk_i) begin
    if (judge) judged_q <= tile;
    if (enter) begin
      kept_count_q[enter_q]    <= '0;
      waiting_count_q[enter_q] <= '0;
      first_q[enter_q]         <= '0;
      reads_q[enter_q]         <= ReadW'(1);
      index_q[enter_q]         <= root_i.index;
    end
    if (judge) begin
      kept_count_q[tile]    <= too_many ? kept + 1'b1 : kept + new_kept;
      waiting_count_q[tile] <= too_many ? waiting : waiting + new_waiting;
    end
    if (ask_next) begin
      waiting_count_q[judged_q] <= waiting_count_q[judged_q] - 1'b1;
      first_q[judged_q]         <= first_q[judged_q] + 1'b1;
      reads_q[judged_q]         <= reads_q[judged_q] + 1'b1;
      index_q[judged_q]         <= look;
    end
  end

  assign ask_valid_o = ask_next || (enter && !at_root);
  assign ask_tile_o  = ask_next ? ctx_t'(judged_q) : ctx_t'(enter_q);
  assign ask_index_o = ask_next ? look : root_i.index;

  assign out_parts_o = kept_count_q[leave_q];
  assign part_read_o = !read_node;
  assign part_o      = read_q;
endmodule
