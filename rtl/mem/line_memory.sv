// SPDX-License-Identifier: Apache-2.0
// The memory behind the caches of Clients: one or two ports, each with its bank of a shared second
// cache. The lowest bit of a line's number chooses between two.
//   take   each bank: the clients' requests, round robin, into a register
//   bank   a line_cache, in which a client's miss is who asks: it merges requests for one line and
//          has at most Misses lines under way
//   port   line_port: to an axi_reader's client and back
//   give   the banks' lines, round robin, one a cycle to the client that asked
// L2Lines are the lines of all banks together, or 0: then a bank has only BufferLines, through
// which lines pass.
// base_i is the address of line 0, an image's start, and stands still while a line is under way.
// A line of the second cache is offered to its client 6 cycles after the request was offered.
module line_memory
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Clients = 2,
  parameter int unsigned Ports   = 1,
  parameter int unsigned L2Lines = DefaultL2Kbytes * 1024 / LineBytes,
  parameter int unsigned L2Ways  = DefaultL2Ways,
  parameter int unsigned Misses  = DefaultL2Misses,   // lines under way for each port
  parameter int unsigned ClientMisses = DefaultCacheMisses   // numbers that a client gives its lines
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  addr_t              base_i,
  output logic [Ports-1:0]   hit_o,       // of the banks, for the counters
  output logic [Ports-1:0]   miss_o,

  input  logic [Clients-1:0] req_valid_i,
  output logic [Clients-1:0] req_ready_o,
  input  line_req_t          req_i [Clients],

  output logic [Clients-1:0] fill_valid_o,
  input  logic [Clients-1:0] fill_ready_i,
  output line_fill_t         fill_o,

  output logic [Ports-1:0]   read_valid_o,
  input  logic [Ports-1:0]   read_ready_i,
  output read_req_t          read_o [Ports],
  input  logic [Ports-1:0]   rsp_valid_i,
  input  read_rsp_t          rsp_i [Ports]
);
  if (Clients < 1 || Clients > 32) begin : g_clients
    $error("line_memory: Clients must be 1 to 32");
  end
  if (Ports < 1 || Ports > 2) begin : g_ports
    $error("line_memory: Ports must be 1 or 2");
  end

  localparam int unsigned BufferLines = 128;
  localparam int unsigned BankLines   = (L2Lines == 0) ? BufferLines : L2Lines / Ports;
  localparam int unsigned IdxW        = (Clients > 1) ? $clog2(Clients) : 1;
  localparam int unsigned NumberW   = $clog2(ClientMisses);
  typedef struct packed {
    logic [IdxW-1:0]    client;
    logic [NumberW-1:0] miss;
  } owner_t;
  typedef struct packed {
    owner_t   owner;
    line_no_t line;
  } bank_req_t;

  // ---- Banks ----
  logic [Ports-1:0]              out_valid, out_ready;
  logic [Ports-1:0][Clients-1:0] taken;
  owner_t                        out_owner [Ports];
  line_data_t                    out_data  [Ports];
  for (genvar p = 0; p < Ports; p++) begin : g_bank
    logic [Clients-1:0] valid, ready;
    logic               taken_valid, taken_ready, in_valid, in_ready, ask_valid, ask_ready, line_valid, line_ready;
    logic [IdxW-1:0]    client;
    line_req_t          first, ask;
    bank_req_t          in;
    logic               data_valid;
    logic [1:0]         data_beat;
    miss_t              data_miss, line_miss;
    beat_t              data;

    for (genvar c = 0; c < Clients; c++) begin : g_client
      assign valid[c] = req_valid_i[c] && (Ports == 1 || req_i[c].line[0] == 1'(p));
    end
    assign taken[p] = valid & ready;
    stream_arb #(.data_t(line_req_t), .N(Clients)) u_take (
      .clk_i, .rst_ni, .valid_i(valid), .ready_o(ready), .data_i(req_i),
      .valid_o(taken_valid), .ready_i(taken_ready), .data_o(first), .index_o(client)
    );
    pipe_cut #(.data_t(bank_req_t)) u_in (
      .clk_i, .rst_ni,
      .valid_i(taken_valid), .ready_o(taken_ready),
      .data_i('{owner: '{client: client, miss: NumberW'(first.miss)}, line: first.line}),
      .valid_o(in_valid), .ready_i(in_ready), .data_o(in)
    );
    line_cache #(.id_t(owner_t), .Lines(BankLines), .Ways(L2Ways), .Misses(Misses), .Skip(Ports - 1), .Parts(4)) u_bank (
      .clk_i, .rst_ni, .hit_o(hit_o[p]), .miss_o(miss_o[p]),
      .in_valid_i(in_valid), .in_ready_o(in_ready), .in_id_i(in.owner), .in_line_i(in.line),
      .keep_i(1'b0), .keep_index_i('0),
      .kept_valid_i(1'b0), .kept_ready_o(), .kept_id_i('0), .kept_index_i('0),
      .out_valid_o(out_valid[p]), .out_ready_i(out_ready[p]), .out_id_o(out_owner[p]), .out_kept_o(),
      .out_data_o(out_data[p]),
      .req_valid_o(ask_valid), .req_ready_i(ask_ready), .req_o(ask),
      .data_valid_i(data_valid), .data_miss_i(data_miss), .data_part_i(data_beat), .data_i(data),
      .fill_valid_i(line_valid), .fill_ready_o(line_ready), .fill_miss_i(line_miss)
    );
    line_port #(.Lines(Misses)) u_port (
      .clk_i, .rst_ni, .base_i,
      .in_valid_i(ask_valid), .in_ready_o(ask_ready), .in_i(ask),
      .data_valid_o(data_valid), .data_miss_o(data_miss), .data_beat_o(data_beat), .data_o(data),
      .out_valid_o(line_valid), .out_ready_i(line_ready), .out_miss_o(line_miss),
      .req_valid_o(read_valid_o[p]), .req_ready_i(read_ready_i[p]), .req_o(read_o[p]),
      .rsp_valid_i(rsp_valid_i[p]), .rsp_i(rsp_i[p])
    );
  end
  always_comb begin
    req_ready_o = '0;
    for (int unsigned p = 0; p < Ports; p++) req_ready_o |= taken[p];
  end

  // ---- Give ----
  logic   give_valid, give_ready, bank;
  owner_t owner;
  stream_arb #(.data_t(owner_t), .N(Ports)) u_give (
    .clk_i, .rst_ni, .valid_i(out_valid), .ready_o(out_ready), .data_i(out_owner),
    .valid_o(give_valid), .ready_i(give_ready), .data_o(owner), .index_o(bank)
  );
  assign give_ready = fill_ready_i[owner.client];
  always_comb begin   // nothing moves here while there is no line
    fill_o = '0;
    if (Ports == 1 || give_valid) fill_o = '{miss: miss_t'(owner.miss), data: out_data[bank]};
  end
  always_comb begin
    fill_valid_o               = '0;
    fill_valid_o[owner.client] = give_valid;
  end
endmodule
