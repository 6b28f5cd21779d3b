// SPDX-License-Identifier: Apache-2.0
// axi/axi_lite_regs: each request is answered once, none that was not made, and an answer stands until it is
// taken; what was written to a byte of an argument is what is read there. One job runs at a time.
// Prove: k=1 Values=0
// Prove: k=1 Values=1
// Cover: 12
module axi_lite_regs_proof
  import castray_pkg::*, castray_reg_pkg::*;
#(
  parameter bit Values = 1'b0   // what is read and written, else only that it is
) (
  input logic                clk_i,
  input logic                rst_ni,
  input logic                s_axi_awvalid_i,
  input logic [RegAddrW-1:0] s_axi_awaddr_i,
  input logic                s_axi_wvalid_i,
  input logic [31:0]         s_axi_wdata_i,
  input logic [3:0]          s_axi_wstrb_i,
  input logic                s_axi_bready_i,
  input logic                s_axi_arvalid_i,
  input logic [RegAddrW-1:0] s_axi_araddr_i,
  input logic                s_axi_rready_i,
  input logic                done_i,
  input error_t              error_i,
  input logic [$clog2(Counters)-1:0] number_i,
  input logic [63:0]         count_i,
  input logic [4:0]          argument_i,      // any one argument, and any byte of it
  input logic [1:0]          byte_i
);
  logic        s_axi_awready_o, s_axi_wready_o, s_axi_bvalid_o, s_axi_arready_o, s_axi_rvalid_o, interrupt_o, start_o;
  logic [1:0]  s_axi_bresp_o, s_axi_rresp_o;
  logic [31:0] s_axi_rdata_o;
  job_t        job_o;
  axi_lite_regs u_dut (.*);
  reset_first u_reset (.*);
  stream_held #(.data_t(logic [1:0])) u_b (
    .clk_i, .rst_ni, .valid_i(s_axi_bvalid_o), .ready_i(s_axi_bready_i), .data_i(s_axi_bresp_o)
  );
  stream_held #(.data_t(logic [33:0])) u_r (
    .clk_i, .rst_ni, .valid_i(s_axi_rvalid_o), .ready_i(s_axi_rready_i), .data_i({s_axi_rresp_o, s_axi_rdata_o})
  );

  // ---- Requests taken and not yet answered ----
  logic       aw, w, b, ar, r, due_q;
  logic [1:0] addrs_q, datas_q, reads_q;
  assign aw = s_axi_awvalid_i && s_axi_awready_o;
  assign w  = s_axi_wvalid_i && s_axi_wready_o;
  assign b  = s_axi_bvalid_o && s_axi_bready_i;
  assign ar = s_axi_arvalid_i && s_axi_arready_o;
  assign r  = s_axi_rvalid_o && s_axi_rready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      addrs_q <= '0;
      datas_q <= '0;
      reads_q <= '0;
      due_q   <= 1'b0;
    end else begin
      addrs_q <= addrs_q + 2'(aw) - 2'(b);
      datas_q <= datas_q + 2'(w) - 2'(b);
      reads_q <= reads_q + 2'(ar) - 2'(r);
      due_q   <= !s_axi_bvalid_o && addrs_q != '0 && datas_q != '0;   // an answer by now
    end
  end

  // ---- A counter is read in its turn ----
  logic [5:0]  which_q;      // word
  logic        counter_q, turn_q;
  logic [31:0] count_q;
  always_ff @(posedge clk_i) begin
    if (ar) begin
      which_q   <= s_axi_araddr_i[7:2];
      counter_q <= s_axi_araddr_i >= RegAddrW'(RegCounters);
    end
    turn_q  <= rst_ni && reads_q != '0 && !s_axi_rvalid_o && number_i == which_q[5:1];
    count_q <= which_q[0] ? count_i[63:32] : count_i[31:0];
  end

  // ---- One byte of one argument ----
  // The offsets of the arguments and where the unit keeps them.
  function automatic logic [RegAddrW-1:0] offset_of(logic [4:0] argument);
    unique case (argument)
      5'd0:    return RegAddrW'(RegImage);
      5'd1:    return RegAddrW'(RegImage + 4);
      5'd2:    return RegAddrW'(RegFrame);
      5'd3:    return RegAddrW'(RegFrame + 4);
      5'd4:    return RegAddrW'(RegHits);
      5'd5:    return RegAddrW'(RegHits + 4);
      5'd6:    return RegAddrW'(RegImageBytes);
      5'd7:    return RegAddrW'(RegFrameBytes);
      5'd8:    return RegAddrW'(RegHitsBytes);
      5'd9:    return RegAddrW'(RegFrameSize);
      5'd10:   return RegAddrW'(RegOptions);
      5'd11:   return RegAddrW'(RegWindowMin);
      5'd12:   return RegAddrW'(RegWindowMax);
      5'd13:   return RegAddrW'(RegSteps);
      5'd14:   return RegAddrW'(RegRays);
      5'd15:   return RegAddrW'(RegRays + 4);
      5'd16:   return RegAddrW'(RegRayBytes);
      default: return RegAddrW'(RegRayCount);
    endcase
  endfunction
  logic [17:0][31:0] kept;
  assign kept = {u_dut.args_q.ray_count, u_dut.args_q.ray_bytes, u_dut.args_q.rays, u_dut.args_q.steps,
                 u_dut.args_q.window_max, u_dut.args_q.window_min, u_dut.args_q.options, u_dut.args_q.frame_size,
                 u_dut.args_q.hits_bytes, u_dut.args_q.frame_bytes, u_dut.args_q.image_bytes, u_dut.args_q.hits,
                 u_dut.args_q.frame, u_dut.args_q.image};

  logic [RegAddrW-1:0] offset, addr_q;
  logic [4:0]          argument_q;
  logic [1:0]          byte_q;
  logic [31:0]         data_q;
  logic [3:0]          strb_q;
  logic [7:0]          value_q, read_q;
  logic                commit, reads_it_q;
  assign offset = offset_of(argument_i);
  assign commit = !s_axi_bvalid_o && addrs_q != '0 && datas_q != '0;
  always_ff @(posedge clk_i) begin
    argument_q <= argument_i;
    byte_q     <= byte_i;
    if (aw) addr_q <= s_axi_awaddr_i;
    if (w) {strb_q, data_q} <= {s_axi_wstrb_i, s_axi_wdata_i};
    if (ar) begin
      reads_it_q <= s_axi_araddr_i[RegAddrW-1:2] == offset[RegAddrW-1:2];
      read_q     <= value_q;
    end
    if (!rst_ni) value_q <= '0;
    else if (commit && addr_q[RegAddrW-1:2] == offset[RegAddrW-1:2] && strb_q[byte_i]) value_q <= data_q[8*byte_i +: 8];
  end
  logic first_q = 1'b1;
  always_ff @(posedge clk_i) first_q <= 1'b0;

  // ---- Jobs ----
  logic runs_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) runs_q <= 1'b0;
    else runs_q <= (runs_q || start_o) && !done_i;
  end

  if (Values) begin : g_values
    always_comb begin
      an_argument: assume (argument_i <= 5'd17);
      if (!first_q) the_same: assume (argument_i == argument_q && byte_i == byte_q);
      if (rst_ni) begin
        if (s_axi_rvalid_o && reads_it_q) reads_what_was_written: assert (s_axi_rdata_o[8*byte_i +: 8] == read_q);
        if (u_dut.addr_held_q) inv_addr: assert (u_dut.waddr_q == addr_q[RegAddrW-1:2]);
        if (u_dut.data_held_q) inv_data: assert (u_dut.wdata_q == data_q && u_dut.wstrb_q == strb_q);
        if (u_dut.wait_q) inv_argument: assert (!reads_it_q);
        inv_value: assert (value_q == kept[argument_i][8*byte_i +: 8]);
        if (s_axi_rvalid_o && reads_it_q) inv_read: assert (u_dut.rdata_q[8*byte_i +: 8] == read_q);
        c_reads_back: cover (s_axi_rvalid_o && reads_it_q && read_q == 8'ha5);
      end
    end
  end

  always_comb begin
    if (rst_ni) begin
      if (done_i) ends_what_runs: assume (runs_q || start_o);

      if (s_axi_bvalid_o) no_write_answer_invented: assert (addrs_q != '0 && datas_q != '0);
      if (due_q) each_write_answered: assert (s_axi_bvalid_o);
      if (s_axi_rvalid_o) no_read_answer_invented: assert (reads_q != '0);
      if (reads_q != '0 && !counter_q) each_read_answered: assert (s_axi_rvalid_o);
      if (turn_q) each_count_answered: assert (s_axi_rvalid_o && s_axi_rdata_o == count_q);
      one_read_at_a_time: assert (reads_q <= 2'd1);
      takes_a_request_when_idle: assert ((addrs_q != '0 || s_axi_awready_o) && (datas_q != '0 || s_axi_wready_o) &&
                                         (reads_q != '0 || s_axi_arready_o));
      answers_okay: assert (s_axi_bresp_o == 2'b00 && s_axi_rresp_o == 2'b00);
      if (start_o) one_job_at_a_time: assert (!runs_q);

      inv_addrs: assert (addrs_q == 2'(u_dut.addr_held_q) + 2'(s_axi_bvalid_o));
      inv_datas: assert (datas_q == 2'(u_dut.data_held_q) + 2'(s_axi_bvalid_o));
      inv_wait: assert (u_dut.wait_q == (reads_q != '0 && !s_axi_rvalid_o));
      if (u_dut.wait_q) inv_which: assert (counter_q && {u_dut.number_q, u_dut.upper_q} == which_q);
      inv_runs: assert (u_dut.running_q == (runs_q || start_o));

      c_both_wait: cover (addrs_q == 2'd2 && datas_q == 2'd2);
      c_count: cover (s_axi_rvalid_o && counter_q);
      c_second_job: cover (start_o && s_axi_rvalid_o && interrupt_o);
    end
  end
endmodule
