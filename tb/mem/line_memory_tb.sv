// SPDX-License-Identifier: Apache-2.0
// Memories of one and two ports, with and without the second cache, side by side; select_i says
// which one is under test.
module line_memory_tb
  import castray_pkg::*;
#(
  parameter int unsigned Clients = 3
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic [1:0]         select_i,

  input  addr_t              base_i,
  output logic [1:0]         hit_o,
  output logic [1:0]         miss_o,

  input  logic [Clients-1:0] req_valid_i,
  output logic [Clients-1:0] req_ready_o,
  input  line_req_t          req_i [Clients],

  output logic [Clients-1:0] fill_valid_o,
  input  logic [Clients-1:0] fill_ready_i,
  output line_fill_t         fill_o,

  output logic [1:0]         read_valid_o,
  input  logic [1:0]         read_ready_i,
  output read_req_t          read_o [2],
  input  logic [1:0]         rsp_valid_i,
  input  read_rsp_t          rsp_i [2]
);
  localparam int unsigned Units = 4;
  localparam int unsigned Ports   [Units] = '{1, 2, 1, 2};
  localparam int unsigned L2Lines [Units] = '{0, 0, 2048, 2048};

  logic [Units-1:0][1:0]         hit, miss, read_valid;
  logic [Units-1:0][Clients-1:0] req_ready, fill_valid;
  line_fill_t                    fill [Units];
  read_req_t                     read [Units][2];
  for (genvar i = 0; i < Units; i++) begin : g_unit
    logic selected;
    assign selected = select_i == 2'(i);
    logic [Ports[i]-1:0] unit_hit, unit_miss, unit_read_valid;
    read_req_t           unit_read [Ports[i]];
    read_rsp_t           unit_rsp  [Ports[i]];
    line_memory #(.Clients(Clients), .Ports(Ports[i]), .L2Lines(L2Lines[i])) u_memory (
      .clk_i, .rst_ni, .base_i, .hit_o(unit_hit), .miss_o(unit_miss),
      .req_valid_i(req_valid_i & {Clients{selected}}), .req_ready_o(req_ready[i]), .req_i,
      .fill_valid_o(fill_valid[i]), .fill_ready_i, .fill_o(fill[i]),
      .read_valid_o(unit_read_valid), .read_ready_i(read_ready_i[Ports[i]-1:0]), .read_o(unit_read),
      .rsp_valid_i(rsp_valid_i[Ports[i]-1:0] & {Ports[i]{selected}}), .rsp_i(unit_rsp)
    );
    for (genvar p = 0; p < Ports[i]; p++) begin : g_port
      assign unit_rsp[p] = rsp_i[p];
      assign read[i][p]  = unit_read[p];
    end
    if (Ports[i] == 1) begin : g_one
      assign read[i][1] = '0;
    end
    assign hit[i]        = 2'(unit_hit);
    assign miss[i]       = 2'(unit_miss);
    assign read_valid[i] = 2'(unit_read_valid);
  end
  assign hit_o        = hit[select_i];
  assign miss_o       = miss[select_i];
  assign req_ready_o  = req_ready[select_i];
  assign fill_valid_o = fill_valid[select_i];
  assign fill_o       = fill[select_i];
  assign read_valid_o = read_valid[select_i];
  assign read_o       = read[select_i];
endmodule
