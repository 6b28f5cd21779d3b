// SPDX-License-Identifier: Apache-2.0
// From rays to hits: the lanes, what deals rays to them, and what leads primitives past their
// contexts. Instances and wires only.
//
//   in -> ray_dispatch -> lane[Lanes] -> arb -> out
//   prim_reader -> brute_walk -^ (all lanes)
//
// Hits leave in another order than their rays came. lines_i and what belongs to it stand still
// from the first ray until idle.
// Model: cpp_model/core.cpp (cast), equal bit for bit.
module traversal
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Lanes    = DefaultLanes,
  parameter int unsigned Contexts = DefaultContexts
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  addr_t            lines_i,        // where the primitives' lines begin
  input  logic [31:0]      line_count_i,
  input  logic [31:0]      primitives_i,   // numbers are below it
  output error_t           fault_o,

  input  logic             exhausted_i,    // no more rays come
  input  logic             starved_i,      // none come before hits have left
  output logic             idle_o,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  ray_t             in_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output hit_t             out_o,

  output logic             read_valid_o,   // primitives
  input  logic             read_ready_i,
  output read_req_t        read_o,
  input  logic             rsp_valid_i,
  input  read_rsp_t        rsp_i,

  output logic [Lanes-1:0] test_o,         // counter events
  output logic [Lanes-1:0] ray_o,
  output logic [Lanes-1:0] hit_o,
  output logic [Lanes-1:0] cand_o,
  output logic             batch_o,
  output logic             test_stall_o,
  output logic             fetch_stall_o
);
  // ---- Rays to lanes ----
  logic             fill, emit;
  logic [Lanes-1:0] ray_valid, ray_ready;

  ray_dispatch #(.Lanes(Lanes)) u_ray_dispatch (
    .clk_i, .rst_ni, .restart_i(emit),
    .in_valid_i, .in_ready_o, .out_valid_o(ray_valid), .out_ready_i(ray_ready)
  );

  // ---- Primitives past the lanes ----
  logic [Lanes-1:0] full, quiet, empty, test_ready;
  logic [CtxW:0]    used [Lanes];
  logic             reader_start, reader_done, slot_valid, slot_ready, test_valid;
  prim_slot_t       slot, test_prim;
  ctx_t             test_ctx;

  prim_reader u_prim_reader (
    .clk_i, .rst_ni,
    .start_i(reader_start), .base_i(lines_i), .lines_i(line_count_i), .primitives_i,
    .done_o(reader_done), .fault_o,
    .req_valid_o(read_valid_o), .req_ready_i(read_ready_i), .req_o(read_o), .rsp_valid_i, .rsp_i,
    .out_valid_o(slot_valid), .out_ready_i(slot_ready), .out_o(slot)
  );

  brute_walk #(.Lanes(Lanes)) u_brute_walk (
    .clk_i, .rst_ni,
    .exhausted_i, .starved_i,
    .used_i(used[0]), .full_i(full), .quiet_i(quiet), .empty_i(empty),
    .fill_o(fill), .emit_o(emit),
    .reader_start_o(reader_start), .reader_done_i(reader_done),
    .prim_valid_i(slot_valid), .prim_ready_o(slot_ready), .prim_i(slot),
    .test_valid_o(test_valid), .test_ready_i(test_ready),
    .test_ctx_o(test_ctx), .test_prim_o(test_prim),
    .idle_o, .batch_o, .test_stall_o, .fetch_stall_o
  );

  // ---- Lanes ----
  logic [Lanes-1:0] hit_valid, hit_ready, found;
  hit_t             hit [Lanes];

  for (genvar i = 0; i < Lanes; i++) begin : g_lane
    lane #(.Contexts(Contexts)) u_lane (
      .clk_i, .rst_ni, .fill_i(fill),
      .ray_valid_i(ray_valid[i]), .ray_ready_o(ray_ready[i]), .ray_i(in_i),
      .test_valid_i(test_valid), .test_ready_o(test_ready[i]), .test_step_i(&test_ready),
      .test_ctx_i(test_ctx), .test_prim_i(test_prim),
      .emit_i(emit),
      .hit_valid_o(hit_valid[i]), .hit_ready_i(hit_ready[i]), .hit_o(hit[i]),
      .used_o(used[i]), .full_o(full[i]), .empty_o(empty[i]), .quiet_o(quiet[i]),
      .test_o(test_o[i]), .cand_o(cand_o[i])
    );
    assign found[i] = hit[i].found;
  end
  assign ray_o = ray_valid & ray_ready;
  assign hit_o = found & hit_valid & hit_ready;

  stream_arb #(.data_t(hit_t), .N(Lanes)) u_merge (
    .clk_i, .rst_ni,
    .valid_i(hit_valid), .ready_o(hit_ready), .data_i(hit),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_o), .index_o()
  );
endmodule
