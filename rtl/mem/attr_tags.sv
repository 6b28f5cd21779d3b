// SPDX-License-Identifier: Apache-2.0
// The tags of the attribute cache: which place a primitive's line has, and whether it must be
// asked for. Two ways, least recently used; an empty way is filled first, the lower one before.
//   cycle 0  both tags of the set, out of the memory
//   cycle 1  compare; the tag is replaced and the line asked for at once, so that the next hit on
//            it finds it although the data is still on its way
// A miss waits while Misses lines are outstanding; given_i: the last of a line was used up.
// One lookup every two cycles. The result is offered with its number: both are taken together.
// Model: cpp_model/mem/attr_tags.hpp.
module attr_tags
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Entries = DefaultAttrEntries,
  parameter int unsigned Misses  = DefaultAttrMisses,
  localparam int unsigned PlaceW = $clog2(Entries)
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  addr_t             base_i,
  output logic              hit_o,
  output logic              miss_o,

  input  logic              in_valid_i,
  output logic              in_ready_o,
  input  prim_t             in_i,

  output logic              out_valid_o,
  input  logic              out_ready_i,
  output logic [PlaceW-1:0] out_place_o,
  output logic              out_miss_o,

  output logic              req_valid_o,
  input  logic              req_ready_i,
  output read_req_t         req_o,
  input  logic              given_i
);
  if (Entries < 4 || (Entries & (Entries - 1)) != 0) begin : g_entries
    $error("attr_tags: Entries must be a power of two, at least 4");
  end
  if (Misses < 1) begin : g_misses
    $error("attr_tags: Misses must be at least 1");
  end

  localparam int unsigned Sets = Entries / 2;
  localparam int unsigned SetW = $clog2(Sets);
  localparam int unsigned TagW = $bits(prim_t) - SetW;
  typedef logic [SetW-1:0] set_t;
  typedef logic [TagW-1:0] tag_t;

  set_t set;
  tag_t tag;
  assign set = in_i[SetW-1:0];
  assign tag = in_i[$bits(prim_t)-1:SetW];

  // ---- Cycle 0 ----
  tag_t tags0_q [Sets];
  tag_t tags1_q [Sets];
  logic last_q  [Sets];           // the way used last; of no meaning while a way is empty
  logic [Sets-1:0] full0_q, full1_q;

  logic compare_q, go;
  tag_t tag0_q, tag1_q;
  logic is_full0_q, is_full1_q, is_last_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) compare_q <= 1'b0;
    else if (compare_q) compare_q <= !go;
    else compare_q <= in_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (in_valid_i && !compare_q) begin
      tag0_q     <= tags0_q[set];
      tag1_q     <= tags1_q[set];
      is_full0_q <= full0_q[set];
      is_full1_q <= full1_q[set];
      is_last_q  <= last_q[set];
    end
  end

  // ---- Cycle 1 ----
  logic found0, found1, miss, way, room, req_ready;
  assign found0 = is_full0_q && tag0_q == tag;
  assign found1 = is_full1_q && tag1_q == tag;
  assign miss   = !found0 && !found1;
  always_comb begin
    if (!miss) way = found1;
    else if (!is_full0_q) way = 1'b0;
    else if (!is_full1_q) way = 1'b1;
    else way = !is_last_q;
  end

  assign out_valid_o = compare_q && (!miss || (room && req_ready));
  assign out_place_o = {set, way};
  assign out_miss_o  = miss;
  assign go          = out_valid_o && out_ready_i;
  assign in_ready_o  = go;
  assign hit_o       = go && !miss;
  assign miss_o      = go && miss;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      full0_q <= '0;
      full1_q <= '0;
    end else if (miss_o) begin
      if (way) full1_q[set] <= 1'b1;
      else full0_q[set] <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (miss_o && !way) tags0_q[set] <= tag;
    if (miss_o && way) tags1_q[set] <= tag;
    if (go) last_q[set] <= way;
  end

  // ---- Lines asked for ----
  credit #(.Limit(Misses)) u_room (
    .clk_i, .rst_ni, .take_i(miss_o), .give_i(given_i), .available_o(room), .idle_o()
  );
  pipe_stage #(.data_t(read_req_t)) u_req (
    .clk_i, .rst_ni,
    .valid_i(miss_o), .ready_o(req_ready),
    .data_i('{addr: base_i + addr_t'({in_i, {$clog2(AttrBytes){1'b0}}}), beats: BeatsW'(AttrBytes / StrbW)}),
    .valid_o(req_valid_o), .ready_i(req_ready_i), .data_o(req_o)
  );
endmodule
