// SPDX-License-Identifier: Apache-2.0
// Runs one job from its start to done:
//   check   the arguments: else ErrRegister, and nothing was touched
//   load    the job loader reads and checks header and frame record
//   setup   frame_setup makes the camera; not for a list of rays
//   run     the walk over the frame or the list
//   drain   until the walk has ended, the datapath is empty and no burst is outstanding, for
//           DrainCycles in a row: the last response has come and the counters have settled
// The datapath is in reset except from load to drain: at least four cycles between two jobs, so
// each job finds everything as after a reset, and a change of the arguments meets nothing awake.
// The first error from load on ends the job: abort resets the datapath and blocks the AXI units
// until no burst is outstanding, for AbortCycles in a row; then done, with the code. Errors of one
// cycle rank: read bus, write bus, loader, datapath.
// An argument is illegal if a register held bits outside its field; a side of the frame is not 1
// to MaxFrameSize; the window is empty or leaves the frame; a list has not 1 to MaxRays rays; a
// buffer is not aligned or ends behind the address space; the image's window does not hold header
// and frame record. The hit buffer counts only if hits are wanted, the rest only where the job is of
// its kind.
// Model: cpp_model/mem/image.hpp, check_job().
module job_control
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned AbortCycles = 4,
  parameter int unsigned DrainCycles = 4
) (
  input  logic   clk_i,
  input  logic   rst_ni,

  input  logic   start_i,          // one cycle, only while not running
  input  job_t   job_i,            // held while the job runs
  output logic   running_o,        // from the cycle after start_i to that of done_o
  output logic   done_o,           // one cycle
  output error_t error_o,          // of the last job: held until the next start

  output logic   datapath_rst_no,  // the datapath's reset, from a register
  output logic   block_o,          // the AXI units take no burst

  output logic   load_start_o,     // one cycle each
  input  logic   load_done_i,      // levels
  input  error_t load_error_i,     // with load_done_i
  output logic   setup_start_o,
  input  logic   setup_done_i,
  output logic   walk_start_o,
  input  logic   walk_done_i,      // level: every pixel has left the walk, or ray the list
  input  logic   empty_i,          // level: nothing is between the walk and the AXI units

  input  logic   read_idle_i,      // of the AXI units
  input  logic   write_idle_i,
  input  logic   read_error_i,     // one cycle each
  input  logic   write_error_i,
  input  error_t fault_i           // of the datapath: anything but ErrNone ends the job
);
  if (AbortCycles < 2 || AbortCycles > 15 || DrainCycles < 2 || DrainCycles > 15) begin : g_check
    $error("job_control: AbortCycles and DrainCycles must be 2 to 15");
  end

  // ---- The arguments ----
  function automatic logic window_ok(addr_t base, logic [31:0] bytes, int unsigned align);
    logic [AddrW:0] finish;
    finish = (AddrW + 1)'(base) + (AddrW + 1)'(bytes);
    return base % AddrW'(align) == '0 && finish <= {1'b1, addr_t'(0)};
  endfunction

  function automatic logic range_ok(extent_t first, extent_t finish, extent_t size);
    return size != '0 && size <= extent_t'(MaxFrameSize) && first < finish && finish <= size;
  endfunction

  function automatic logic legal(job_t job);
    logic frame_ok, list_ok;
    frame_ok = range_ok(job.x0, job.x1, job.width) && range_ok(job.y0, job.y1, job.height) &&
               window_ok(job.frame, job.frame_bytes, BufferAlign);
    list_ok  = job.ray_count != '0 && job.ray_count <= ray_count_t'(MaxRays) &&
               window_ok(job.rays, job.ray_bytes, BufferAlign);
    return !job.illegal && (job.is_list ? list_ok : frame_ok) &&
           window_ok(job.image, job.image_bytes, ImageAlign) && job.image_bytes >= HeaderBytes + FrameBytes &&
           (!job.want_hits || window_ok(job.hits, job.hits_bytes, BufferAlign));
  endfunction

  // ---- States ----
  typedef enum logic [3:0] {Idle, Check, Judge, Load, Setup, Run, Drain, Abort, Done} state_t;
  state_t     state_q, state_d;
  logic       entered_q;       // the first cycle of a state
  logic [3:0] count_q;         // cycles that a condition has held for
  logic       legal_q, rst_nq, block_q;
  error_t     error_q, error_d;

  logic   idle, drained, active;
  error_t load_error;
  assign idle    = read_idle_i && write_idle_i;
  assign drained = idle && walk_done_i && empty_i;
  assign active  = state_q inside {Load, Setup, Run, Drain};

  assign load_error = (state_q == Load && !entered_q && load_done_i) ? load_error_i : ErrNone;

  always_comb begin
    error_d = ErrNone;
    if (active) begin
      if (read_error_i) error_d = ErrReadBus;
      else if (write_error_i) error_d = ErrWriteBus;
      else if (load_error != ErrNone) error_d = load_error;
      else error_d = fault_i;
    end else if (state_q == Judge && !legal_q) error_d = ErrRegister;
  end

  always_comb begin
    state_d = state_q;
    unique case (state_q)
      Idle:    if (start_i) state_d = Check;
      Check:   state_d = Judge;
      Judge:   state_d = legal_q ? Load : Done;
      Load:    if (!entered_q && load_done_i) state_d = job_i.is_list ? Run : Setup;
      Setup:   if (!entered_q && setup_done_i) state_d = Run;
      Run:     state_d = Drain;
      Drain:   if (drained && count_q == 4'(DrainCycles - 1)) state_d = Done;
      Abort:   if (idle && count_q == 4'(AbortCycles - 1)) state_d = Done;
      Done:    state_d = Idle;
      default: state_d = Idle;
    endcase
    if (active && error_d != ErrNone) state_d = Abort;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q   <= Idle;
      entered_q <= 1'b0;
      count_q   <= '0;
      error_q   <= ErrNone;
      rst_nq    <= 1'b0;
      block_q   <= 1'b1;
    end else begin
      state_q   <= state_d;
      entered_q <= state_d != state_q;
      rst_nq    <= state_d inside {Load, Setup, Run, Drain};
      block_q   <= state_d == Abort;
      if (state_d != state_q) count_q <= '0;
      else if ((state_q == Drain && !drained) || (state_q == Abort && !idle)) count_q <= '0;
      else count_q <= count_q + 1'b1;
      if (state_q == Idle && start_i) error_q <= ErrNone;
      else if (error_d != ErrNone) error_q <= error_d;
    end
  end
  always_ff @(posedge clk_i) begin
    if (state_q == Check) legal_q <= legal(job_i);
  end

  assign running_o       = state_q != Idle;
  assign done_o          = state_q == Done;
  assign error_o         = error_q;
  assign datapath_rst_no = rst_nq;
  assign block_o         = block_q;
  assign load_start_o    = state_q == Load && entered_q;
  assign setup_start_o   = state_q == Setup && entered_q;
  assign walk_start_o    = state_q == Run;
endmodule
