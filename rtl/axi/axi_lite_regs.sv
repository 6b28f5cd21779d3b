// SPDX-License-Identifier: Apache-2.0
// The registers of castray_reg_pkg behind an AXI4-Lite port, with the start/done protocol that HLS
// tools generate (docs/register-map.md):
//   start   written as 1 it stays 1 until the job is done; writing it meanwhile changes nothing,
//           except in the very cycle of done, where it starts the next job; writing 0 does nothing
//   done, ready  set at the end of a job, cleared by reading the control register; an end in the
//           cycle of the read is not lost: it shows in the next read
//   idle    no job is running and none is wanted
//   auto restart  keeps start at 1 when a job ends: the next begins, with the arguments of then
//   isr     a bit is set at the end of a job if ier enables it, and toggled by writing a one;
//           set wins. interrupt_o = gie && any bit of isr, a level
// Arguments may be read and written at any time; job_o takes them when a job begins.
// Byte strobes are honoured. What does not exist reads as 0 and takes writes without effect;
// every response is OKAY. One access in three cycles, reads and writes independent of each other; the
// read of a counter waits for its turn: some Counters cycles more at most.
// Model: cpp_model/axi/axi_lite_regs.hpp (the job from the argument registers).
module axi_lite_regs
  import castray_cfg_pkg::*, castray_pkg::*, castray_reg_pkg::*;
#(
  parameter int unsigned Lanes    = DefaultLanes,
  parameter int unsigned Contexts = DefaultContexts,
  parameter int unsigned TileLog2 = DefaultTileLog2,
  localparam int unsigned CounterW = $clog2(Counters)
) (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                s_axi_awvalid_i,
  output logic                s_axi_awready_o,
  input  logic [RegAddrW-1:0] s_axi_awaddr_i,
  input  logic                s_axi_wvalid_i,
  output logic                s_axi_wready_o,
  input  logic [31:0]         s_axi_wdata_i,
  input  logic [3:0]          s_axi_wstrb_i,
  output logic                s_axi_bvalid_o,
  input  logic                s_axi_bready_i,
  output logic [1:0]          s_axi_bresp_o,

  input  logic                s_axi_arvalid_i,
  output logic                s_axi_arready_o,
  input  logic [RegAddrW-1:0] s_axi_araddr_i,
  output logic                s_axi_rvalid_o,
  input  logic                s_axi_rready_i,
  output logic [31:0]         s_axi_rdata_o,
  output logic [1:0]          s_axi_rresp_o,

  output logic                interrupt_o,

  output logic                start_o,             // one cycle: a job begins
  output job_t                job_o,               // its arguments, held until the next begins
  input  logic                done_i,              // one cycle: it ended
  input  error_t              error_i,             // of the last job, held
  input  logic [CounterW-1:0] number_i,            // of a counter, each in turn
  input  logic [63:0]         count_i              // its count
);
  if (RegCounters % (8 * Counters) != 0 || 2 ** CounterW != Counters) begin : g_counters
    $error("axi_lite_regs: the counters' offsets must end in a counter's number");
  end
  if (Lanes < 1 || Lanes > 255 || Contexts < 1 || Contexts > 255 || TileLog2 > 7) begin : g_check
    $error("axi_lite_regs: Lanes, Contexts and the tile size must fit the config register");
  end

  localparam logic [31:0] Version = {16'(castray_cfg_pkg::VersionMajor), 8'(castray_cfg_pkg::VersionMinor),
                                     8'(castray_cfg_pkg::VersionPatch)};
  localparam logic [31:0] Config  = {8'd0, 8'(1 << TileLog2), 8'(Contexts), 8'(Lanes)};

  // A register number: the byte offset in words.
  typedef logic [RegAddrW-3:0] reg_t;
  function automatic reg_t number(int unsigned offset);
    return reg_t'(offset >> 2);
  endfunction

  // ---- Write channels: address and data wait for each other, in either order ----
  logic        addr_held_q, data_held_q, b_valid_q, write;
  reg_t        waddr_q;
  logic [31:0] wdata_q;
  logic [3:0]  wstrb_q;
  assign s_axi_awready_o = !addr_held_q;
  assign s_axi_wready_o  = !data_held_q;
  assign s_axi_bvalid_o  = b_valid_q;
  assign s_axi_bresp_o   = 2'b00;
  assign write           = addr_held_q && data_held_q && !b_valid_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      addr_held_q <= 1'b0;
      data_held_q <= 1'b0;
      b_valid_q   <= 1'b0;
    end else begin
      if (s_axi_awready_o) addr_held_q <= s_axi_awvalid_i;
      else if (write) addr_held_q <= 1'b0;
      if (s_axi_wready_o) data_held_q <= s_axi_wvalid_i;
      else if (write) data_held_q <= 1'b0;
      if (write) b_valid_q <= 1'b1;
      else if (s_axi_bready_i) b_valid_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (s_axi_awvalid_i && s_axi_awready_o) waddr_q <= s_axi_awaddr_i[RegAddrW-1:2];
    if (s_axi_wvalid_i && s_axi_wready_o) begin
      wdata_q <= s_axi_wdata_i;
      wstrb_q <= s_axi_wstrb_i;
    end
  end

  // ---- Arguments: 32-bit words, two for a pointer ----
  typedef struct packed {
    logic [31:0] ray_count, ray_bytes, steps, window_max, window_min, options, frame_size, hits_bytes, frame_bytes, image_bytes;
    logic [63:0] rays, hits, frame, image;
  } args_t;
  args_t args_q;

  // A word with the strobed bytes replaced.
  function automatic logic [31:0] merge(logic [31:0] old, logic [31:0] data, logic [3:0] strb);
    for (int unsigned i = 0; i < 4; i++) merge[8*i +: 8] = strb[i] ? data[8*i +: 8] : old[8*i +: 8];
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) args_q <= '0;
    else if (write) begin
      unique0 case (waddr_q)
        number(RegImage):      args_q.image[31:0]  <= merge(args_q.image[31:0], wdata_q, wstrb_q);
        number(RegImage + 4):  args_q.image[63:32] <= merge(args_q.image[63:32], wdata_q, wstrb_q);
        number(RegFrame):      args_q.frame[31:0]  <= merge(args_q.frame[31:0], wdata_q, wstrb_q);
        number(RegFrame + 4):  args_q.frame[63:32] <= merge(args_q.frame[63:32], wdata_q, wstrb_q);
        number(RegHits):       args_q.hits[31:0]   <= merge(args_q.hits[31:0], wdata_q, wstrb_q);
        number(RegHits + 4):   args_q.hits[63:32]  <= merge(args_q.hits[63:32], wdata_q, wstrb_q);
        number(RegImageBytes): args_q.image_bytes  <= merge(args_q.image_bytes, wdata_q, wstrb_q);
        number(RegFrameBytes): args_q.frame_bytes  <= merge(args_q.frame_bytes, wdata_q, wstrb_q);
        number(RegHitsBytes):  args_q.hits_bytes   <= merge(args_q.hits_bytes, wdata_q, wstrb_q);
        number(RegFrameSize):  args_q.frame_size   <= merge(args_q.frame_size, wdata_q, wstrb_q);
        number(RegOptions):    args_q.options      <= merge(args_q.options, wdata_q, wstrb_q);
        number(RegWindowMin):  args_q.window_min   <= merge(args_q.window_min, wdata_q, wstrb_q);
        number(RegWindowMax):  args_q.window_max   <= merge(args_q.window_max, wdata_q, wstrb_q);
        number(RegSteps):      args_q.steps        <= merge(args_q.steps, wdata_q, wstrb_q);
        number(RegRays):       args_q.rays[31:0]   <= merge(args_q.rays[31:0], wdata_q, wstrb_q);
        number(RegRays + 4):   args_q.rays[63:32]  <= merge(args_q.rays[63:32], wdata_q, wstrb_q);
        number(RegRayBytes):   args_q.ray_bytes    <= merge(args_q.ray_bytes, wdata_q, wstrb_q);
        number(RegRayCount):   args_q.ray_count    <= merge(args_q.ray_count, wdata_q, wstrb_q);
        default: ;
      endcase
    end
  end

  // The two numbers of a word.
  function automatic extent_t low_of(logic [31:0] pair);
    return pair[$bits(extent_t)-1:0];
  endfunction
  function automatic extent_t high_of(logic [31:0] pair);
    return pair[16 +: $bits(extent_t)];
  endfunction

  function automatic job_t job_of(args_t args);
    logic [31:0] pairs, window_max;
    logic        is_list, want_hits, frame_bad, list_bad;
    is_list    = args.options[OptionList];
    want_hits  = args.options[OptionHits] || is_list;
    window_max = (args.window_max == '0) ? args.frame_size : args.window_max;
    pairs      = args.frame_size | args.window_min | args.window_max;
    frame_bad  = (pairs[15:0] >> $bits(extent_t)) != '0 || (pairs[31:16] >> $bits(extent_t)) != '0 ||
                 args.frame[63:AddrW] != '0;
    list_bad   = args.rays[63:AddrW] != '0 || (args.ray_count >> $bits(ray_count_t)) != '0;
    return '{
      image:       args.image[AddrW-1:0],
      frame:       args.frame[AddrW-1:0],
      hits:        args.hits[AddrW-1:0],
      rays:        args.rays[AddrW-1:0],
      image_bytes: args.image_bytes,
      frame_bytes: args.frame_bytes,
      hits_bytes:  args.hits_bytes,
      ray_bytes:   args.ray_bytes,
      ray_count:   ray_count_t'(args.ray_count),
      width:       low_of(args.frame_size),
      height:      high_of(args.frame_size),
      x0:          low_of(args.window_min),
      y0:          high_of(args.window_min),
      x1:          low_of(window_max),
      y1:          high_of(window_max),
      is_list:     is_list,
      want_hits:   want_hits,
      want_work:   args.options[OptionWork],
      z_order:     args.options[OptionZOrder],
      brute:       args.options[OptionBrute],
      from_root:   args.options[OptionRoot],
      steps:       (args.steps == '0) ? '1 : steps_t'(args.steps),
      illegal:     (is_list ? list_bad : frame_bad) || (args.options >> NumOptions) != '0 || (args.options[OptionWork] && !want_hits) ||
                   (args.steps >> $bits(steps_t)) != '0 || args.image[63:AddrW] != '0 ||
                   (want_hits && args.hits[63:AddrW] != '0)
    };
  endfunction

  // ---- Start and done ----
  logic start_q, running_q, begin_q, restart_q, done_q, ready_q, write_control, begin_job, idle;
  job_t job_q;
  assign write_control = write && waddr_q == number(RegControl) && wstrb_q[0];
  assign begin_job     = start_q && !running_q;
  assign idle          = !start_q && !running_q;
  assign start_o       = begin_q;
  assign job_o         = job_q;

  logic read, read_control;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      start_q   <= 1'b0;
      running_q <= 1'b0;
      begin_q   <= 1'b0;
      restart_q <= 1'b0;
      done_q    <= 1'b0;
      ready_q   <= 1'b0;
    end else begin
      begin_q <= begin_job;
      if (write_control && wdata_q[CtrlStart]) start_q <= 1'b1;
      else if (done_i) start_q <= restart_q;
      if (write_control) restart_q <= wdata_q[CtrlAutoRestart];
      if (begin_job) running_q <= 1'b1;
      else if (done_i) running_q <= 1'b0;
      if (done_i) begin
        done_q  <= 1'b1;
        ready_q <= 1'b1;
      end else if (read_control) begin
        done_q  <= 1'b0;
        ready_q <= 1'b0;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (begin_job) job_q <= job_of(args_q);
  end

  // ---- Interrupt ----
  logic       gie_q;
  logic [1:0] ier_q, isr_q;
  assign interrupt_o = gie_q && isr_q != '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gie_q <= 1'b0;
      ier_q <= '0;
      isr_q <= '0;
    end else begin
      if (write && wstrb_q[0]) begin
        unique0 case (waddr_q)
          number(RegGie): gie_q <= wdata_q[0];
          number(RegIer): ier_q <= wdata_q[1:0];
          number(RegIsr): isr_q <= isr_q ^ wdata_q[1:0];
          default: ;
        endcase
      end
      if (done_i) begin
        if (ier_q[IsrDone]) isr_q[IsrDone] <= 1'b1;
        if (ier_q[IsrReady]) isr_q[IsrReady] <= 1'b1;
      end
    end
  end

  // ---- Read channels ----
  logic        r_valid_q, wait_q, is_counter, upper_q, here;   // wait_q: for counter number_q
  logic [CounterW-1:0] number_q;
  logic [31:0] rdata_q;
  reg_t        raddr;
  assign s_axi_arready_o = !r_valid_q && !wait_q;
  assign s_axi_rvalid_o  = r_valid_q;
  assign s_axi_rdata_o   = rdata_q;
  assign s_axi_rresp_o   = 2'b00;
  assign raddr           = s_axi_araddr_i[RegAddrW-1:2];
  assign read            = s_axi_arvalid_i && s_axi_arready_o;
  assign read_control    = read && raddr == number(RegControl);
  assign is_counter      = raddr[RegAddrW-3:CounterW+1] == (RegAddrW-CounterW-3)'(RegCounters / (8 * Counters));
  assign here            = wait_q && number_i == number_q;

  function automatic logic [31:0] control_word();
    control_word = '0;
    control_word[CtrlStart]       = start_q;
    control_word[CtrlDone]        = done_q;
    control_word[CtrlIdle]        = idle;
    control_word[CtrlReady]       = ready_q;
    control_word[CtrlAutoRestart] = restart_q;
    control_word[CtrlInterrupt]   = interrupt_o;
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      r_valid_q <= 1'b0;
      wait_q    <= 1'b0;
    end else begin
      if ((read && !is_counter) || here) r_valid_q <= 1'b1;
      else if (s_axi_rready_i) r_valid_q <= 1'b0;
      if (read) wait_q <= is_counter;
      else if (here) wait_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (read) {number_q, upper_q} <= raddr[CounterW:0];
  end
  always_ff @(posedge clk_i) begin
    if (read) begin
      unique0 case (raddr)
        number(RegControl):    rdata_q <= control_word();
        number(RegGie):        rdata_q <= 32'(gie_q);
        number(RegIer):        rdata_q <= 32'(ier_q);
        number(RegIsr):        rdata_q <= 32'(isr_q);
        number(RegImage):      rdata_q <= args_q.image[31:0];
        number(RegImage + 4):  rdata_q <= args_q.image[63:32];
        number(RegFrame):      rdata_q <= args_q.frame[31:0];
        number(RegFrame + 4):  rdata_q <= args_q.frame[63:32];
        number(RegHits):       rdata_q <= args_q.hits[31:0];
        number(RegHits + 4):   rdata_q <= args_q.hits[63:32];
        number(RegImageBytes): rdata_q <= args_q.image_bytes;
        number(RegFrameBytes): rdata_q <= args_q.frame_bytes;
        number(RegHitsBytes):  rdata_q <= args_q.hits_bytes;
        number(RegFrameSize):  rdata_q <= args_q.frame_size;
        number(RegOptions):    rdata_q <= args_q.options;
        number(RegWindowMin):  rdata_q <= args_q.window_min;
        number(RegWindowMax):  rdata_q <= args_q.window_max;
        number(RegSteps):      rdata_q <= args_q.steps;
        number(RegRays):       rdata_q <= args_q.rays[31:0];
        number(RegRays + 4):   rdata_q <= args_q.rays[63:32];
        number(RegRayBytes):   rdata_q <= args_q.ray_bytes;
        number(RegRayCount):   rdata_q <= args_q.ray_count;
        number(RegVersion):    rdata_q <= Version;
        number(RegConfig):     rdata_q <= Config;
        number(RegParameters): rdata_q <= castray_image_pkg::ImageParameters;
        number(RegError):      rdata_q <= 32'(error_i);
        default:               rdata_q <= '0;
      endcase
    end else if (here) rdata_q <= upper_q ? count_i[63:32] : count_i[31:0];
  end
endmodule
