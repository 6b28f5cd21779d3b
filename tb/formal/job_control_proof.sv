// SPDX-License-Identifier: Apache-2.0
// control/job_control: nothing is read or written before every window of memory of the job was found aligned and
// inside the address space, the image's with room for its header; while it aborts no burst is taken; a job ends.
// Prove: k=1
// Cover: 16
module job_control_proof
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input logic   clk_i,
  input logic   rst_ni,
  input logic   start_i,
  input job_t   job_i,
  input logic   load_done_i,
  input error_t load_error_i,
  input logic   setup_done_i,
  input logic   walk_done_i,
  input logic   empty_i,
  input logic   read_idle_i,
  input logic   write_idle_i,
  input logic   read_error_i,
  input logic   write_error_i,
  input error_t fault_i
);
  logic   running_o, done_o, datapath_rst_no, block_o, load_start_o, setup_start_o, walk_start_o;
  error_t error_o;
  job_control u_dut (.*);
  reset_first u_reset (.*);

  function automatic logic window_ok(addr_t base, logic [31:0] bytes, logic [8:0] align);
    return (base & addr_t'(align - 9'd1)) == '0 && 41'(base) + 41'(bytes) <= 41'h100_0000_0000;
  endfunction
  logic windows_ok;
  assign windows_ok = window_ok(job_i.image, job_i.image_bytes, 9'd256) && job_i.image_bytes >= 32'd256 &&
                      (job_i.is_list ? window_ok(job_i.rays, job_i.ray_bytes, 9'd64)
                                     : window_ok(job_i.frame, job_i.frame_bytes, 9'd64)) &&
                      (!job_i.want_hits || window_ok(job_i.hits, job_i.hits_bytes, 9'd64));

  logic       first_q = 1'b1;
  logic       runs_q, idle_q;
  job_t       job_q;
  logic [3:0] state;
  assign state = 4'(u_dut.state_q);
  always_ff @(posedge clk_i) begin
    first_q <= 1'b0;
    job_q   <= job_i;
    idle_q  <= read_idle_i && write_idle_i;
    if (!rst_ni || done_o) runs_q <= 1'b0;
    else if (start_i) runs_q <= 1'b1;
  end

  always_comb begin
    if (rst_ni) begin
      if (running_o && !first_q) job_stands_still: assume (job_i == job_q);
      if (running_o) one_start_a_job: assume (!start_i);

      runs_from_start_to_done: assert (running_o == runs_q);
      if (datapath_rst_no) windows_are_legal: assert (windows_ok);
      if (load_start_o || setup_start_o || walk_start_o) starts_what_is_awake: assert (datapath_rst_no && running_o && !block_o);
      if (done_o) done_when_idle: assert (idle_q || error_o == ErrRegister);
      if (done_o && error_o != ErrNone) asleep_after_an_error: assert (!datapath_rst_no);

      inv_state: assert (state <= 4'd8);
      inv_awake: assert (datapath_rst_no == (state >= 4'd3 && state <= 4'd6) &&
                         (state == 4'd0 || block_o == (state == 4'd7)));
      if ((state == 4'd2 && u_dut.legal_q) || (state >= 4'd3 && state <= 4'd7)) inv_legal: assert (windows_ok);
      if (state == 4'd8) inv_done: assert (idle_q || error_o == ErrRegister);

      c_aborts: cover (done_o && error_o == ErrReadBus);
      c_ends: cover (done_o && error_o == ErrNone && runs_q);
    end
  end
endmodule
