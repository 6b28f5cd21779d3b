// SPDX-License-Identifier: Apache-2.0
// Reads a list of rays from its first record to its last and gives what they ask for, in that order.
//   ask      bursts of 4 records (16 beats), up to the next multiple of 256 bytes, while the queue
//            has room for 4
//   arrive   four beats make a record, and that a request (ray_request); fault_o is ErrRay for a cycle
//            if it is not legal
//   queue    Depth requests, prefetched
// base_i is aligned to 64 bytes. base_i and count_i stand still until done.
// done_o: a level, from the cycle after the last request was taken until the next start. A start is
// allowed before the first and after each done.
// One ray every four cycles while the memory keeps up; a burst under way covers 16 cycles of latency.
// Model: cpp_model/mem/ray_request.hpp, for each record.
module ray_reader
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  localparam int unsigned BurstRays = 4,
  parameter int unsigned Depth = BurstRays * DefaultRayBursts
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       start_i,
  input  addr_t      base_i,
  input  ray_count_t count_i,
  output logic       done_o,
  output error_t     fault_o,

  output logic       req_valid_o,
  input  logic       req_ready_i,
  output read_req_t  req_o,
  input  logic       rsp_valid_i,
  input  read_rsp_t  rsp_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output ray_req_t   out_o
);
  localparam int unsigned Beats     = RayBytes / StrbW;   // of a record
  localparam int unsigned FreeW     = $clog2(Depth + 1);
  typedef logic [FreeW-1:0] free_t;
  if (Depth < BurstRays) begin : g_depth
    $error("ray_reader: Depth must hold the rays of a burst");
  end
  if ($bits(ray_record_t) != Beats * DataW || Beats != 4) begin : g_record
    $error("ray_reader: a record must be four beats");
  end

  // ---- Ask ----
  logic       started_q, ask;
  addr_t      addr_q;
  ray_count_t left_q;          // rays not asked for
  logic [2:0] to_edge, rays;   // up to the next multiple of a burst's bytes; of the burst
  free_t      free_q;          // places of the queue neither taken nor promised

  assign to_edge     = 3'(BurstRays) - 3'(addr_q[7:6]);
  assign rays        = (left_q < ray_count_t'(to_edge)) ? left_q[2:0] : to_edge;
  assign req_valid_o = left_q != '0 && free_q >= free_t'(BurstRays);
  assign req_o       = '{addr: addr_q, beats: BeatsW'(rays) * BeatsW'(Beats)};
  assign ask         = req_valid_o && req_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      left_q    <= '0;
    end else if (start_i) begin
      started_q <= 1'b1;
      left_q    <= count_i;
    end else if (ask) begin
      left_q <= left_q - ray_count_t'(rays);
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i) addr_q <= base_i;
    else if (ask) addr_q <= addr_q + (addr_t'(rays) << $clog2(RayBytes));
  end

  // ---- Arrive ----
  logic [1:0]           beat_q;
  logic [3*DataW-1:0]   lower_q;   // the beats of a record before its last
  ray_no_t              number_q;
  logic                 whole, legal, fault_q;
  ray_req_t             req;

  assign whole = rsp_valid_i && beat_q == 2'(Beats - 1);
  ray_request u_request (.record_i({rsp_i.data, lower_q}), .number_i(number_q), .legal_o(legal), .req_o(req));

  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) begin
      beat_q   <= '0;
      number_q <= '0;
      fault_q  <= 1'b0;
    end else begin
      if (rsp_valid_i) beat_q <= beat_q + 1'b1;
      if (whole) number_q <= number_q + 1'b1;
      fault_q <= whole && !legal;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rsp_valid_i && !whole) lower_q <= {rsp_i.data, lower_q[3*DataW-1:DataW]};
  end
  assign fault_o = fault_q ? ErrRay : ErrNone;

  // ---- Queue ----
  logic pop;
  stream_fifo #(.data_t(ray_req_t), .Depth(Depth)) u_queue (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(whole), .ready_o(), .data_i(req),   // there is room: it was promised
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_o)
  );
  assign pop = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) free_q <= free_t'(Depth);
    else free_q <= free_q - (ask ? free_t'(rays) : '0) + free_t'(pop);
  end

  assign done_o = started_q && left_q == '0 && free_q == free_t'(Depth);
endmodule
