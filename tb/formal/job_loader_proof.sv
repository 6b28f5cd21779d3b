// SPDX-License-Identifier: Apache-2.0
// mem/job_loader: job_control starts it with an aligned window of at least 256 bytes. Then it makes one burst, of
// 16 beats, inside the window; and where it finds no error, every section of the image lies inside the window.
// Prove: k=1
// Cover: 8
module job_loader_proof
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input logic      clk_i,
  input logic      rst_ni,
  input logic      start_i,
  input job_t      job_i,
  input logic      req_ready_i,
  input logic      rsp_valid_i,
  input beat_t     data_i
);
  logic          done_o, req_valid_o;
  error_t        error_o;
  image_header_t header_o;
  frame_record_t record_o;
  read_req_t     req_o;
  read_rsp_t     rsp_i;
  job_loader u_dut (.*);
  reset_first u_reset (.*);
  read_window u_window (
    .clk_i, .rst_ni, .base_i(job_i.image), .bytes_i({9'd0, job_i.image_bytes}),
    .valid_i(req_valid_o), .ready_i(req_ready_i), .req_i(req_o)
  );
  logic [6:0] beats;
  read_beats #(.Most(64)) u_beats (.clk_i, .rst_ni, .req_valid_i(req_valid_o), .req_ready_i, .req_i(req_o), .rsp_valid_i, .beats_o(beats));
  assign rsp_i = '{last: beats == 7'd1, data: data_i};

  // A start is allowed before the first and when all is done; the job stands still meanwhile.
  logic first_q = 1'b1;
  logic [5:0] cycle_q = '0;
  logic busy_q, asked_q;
  job_t job_q;
  always_ff @(posedge clk_i) begin
    first_q <= 1'b0;
    cycle_q <= cycle_q + 6'(cycle_q != '1);
    job_q   <= job_i;
    if (!rst_ni) busy_q <= 1'b0;
    else if (start_i) busy_q <= 1'b1;
    else if (done_o) busy_q <= 1'b0;
    if (!rst_ni || start_i) asked_q <= 1'b0;
    else if (req_valid_o && req_ready_i) asked_q <= 1'b1;
  end

  // A section as the unit must have found it.
  function automatic logic lies_inside(section_t section);
    logic [63:0] behind;
    behind = 64'(section.offset) + 64'(section.count) * 64'd64;
    return section.count == '0 || (section.offset != '0 && section.offset[7:0] == '0 && behind <= 64'(job_i.image_bytes));
  endfunction
  logic [4:0] passed;   // of the checks that the sections need, those that the unit has come behind
  logic [2:0] state;
  assign state = 3'(u_dut.state_q);
  always_comb begin
    passed = '0;
    if (state == 3'd3) for (int unsigned i = 0; i < 5; i++) passed[i] = 32'(u_dut.step_q) > i + 2;
    if (state == 3'd4) passed = '1;
  end

  always_comb begin
    if (rst_ni) begin
      if (start_i) starts_when_idle: assume (!busy_q || done_o);
      if (busy_q && !first_q) job_stands_still: assume (job_i == job_q);
      window_is_legal: assume (job_i.image[7:0] == '0 && job_i.image_bytes >= 32'd256 &&
                               41'(job_i.image) + 41'(job_i.image_bytes) <= 41'h100_0000_0000);

      if (req_valid_o) one_burst_a_job: assert (!asked_q);
      if (req_valid_o) the_whole_record: assert (req_o.beats == 5'd16 && req_o.addr == job_i.image);
      if (busy_q && done_o && error_o == ErrNone)
        sections_inside_window: assert (lies_inside(header_o.lines) && lies_inside(header_o.attributes) &&
                                        lies_inside(header_o.nodes) && header_o.primitives <= header_o.attributes.count);

      inv_state: assert (state <= 3'd4 && (state != 3'd4 || !busy_q || asked_q));
      inv_beats: assert ((state == 3'd2) == (beats != '0) && (state != 3'd2 || (7'(u_dut.step_q) + beats == 7'd16)));
      inv_busy: assert (busy_q || state == 3'd0 || state == 3'd4);
      inv_asked: assert ((state != 3'd1 || !asked_q) && ((state != 3'd2 && state != 3'd3) || (asked_q && busy_q)));
      inv_ask: assert (state != 3'd1 || (u_dut.error_q == ErrNone && u_dut.step_q == '0));
      if (busy_q && error_o == ErrNone) begin
        if (passed[0]) inv_bytes: assert (header_o.image_bytes <= job_i.image_bytes);
        if (passed[1]) inv_lines: assert (lies_inside(header_o.lines));
        if (passed[2]) inv_attributes: assert (lies_inside(header_o.attributes));
        if (passed[3]) inv_nodes: assert (lies_inside(header_o.nodes));
        if (passed[4]) inv_primitives: assert (header_o.primitives <= header_o.attributes.count);
      end

      c_comes: cover (beats == 7'd13 && rsp_valid_i);
      c_taken_late: cover (req_valid_o && req_ready_i && cycle_q >= 6'd5);
    end
  end
endmodule
