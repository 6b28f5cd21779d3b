// SPDX-License-Identifier: Apache-2.0
// The memory before a client of axi_reader, as far as its user may rely on it: beats come in the order of its
// bursts, none that was not asked for, the last of each burst marked. Assumed.
module read_beats
  import castray_pkg::*;
#(
  parameter int unsigned Most  = 64,   // beats that may be outstanding
  localparam int unsigned CntW = $clog2(Most + 32)
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic            req_valid_i,
  input  logic            req_ready_i,
  input  read_req_t       req_i,
  input  logic            rsp_valid_i,
  output logic [CntW-1:0] beats_o      // outstanding
);
  logic [CntW-1:0] beats_q;
  logic            ask;
  assign beats_o = beats_q;
  assign ask     = req_valid_i && req_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) beats_q <= '0;
    else beats_q <= beats_q + (ask ? CntW'(req_i.beats) : '0) - CntW'(rsp_valid_i);
  end
  always_comb if (rst_ni && rsp_valid_i) only_what_was_asked: assume (beats_q != '0);
endmodule
