// SPDX-License-Identifier: Apache-2.0
// The distance of an accepted primitive, and where on it: two divisions, then
//   triangle   u = U / det, v = V / det, t = Cz + u (Az - Cz) + v (Bz - Cz)
//   sphere     t = Cz + (b -+ root) / |S|^2                       (units and roundings: the parts)
// on permuted axes, then turned into the ray's direction.
//   front      one candidate: its shift (hit_norm, 2 cycles) or its root (hit_sphere)
//   issue      two cycles: the first division, then the second
//   div_pipe   26-bit operands, 24 fraction bits, nearest
//   tail       hit_distance
// One triangle every two cycles; a sphere blocks the front while its root is taken. The tail never
// stalls: a result is always taken. retire_o: a candidate is finished, whether emitted or not.
// out_valid_o comes with retire_o, at most every second cycle, in order. 2 DSPs.
// Model: cpp_model/isect/hit_unit.hpp, equal bit for bit.
module hit_unit
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     in_valid_i,
  output logic     in_ready_o,
  input  cand_t    in_i,
  input  hit_ray_t in_ray_i,

  output logic     out_valid_o,
  output result_t  out_o,
  output logic     retire_o
);
  localparam int unsigned DivBitsPerStage = 2;
  localparam int unsigned Waiting         = 16;  // candidates between issue and tail

  // ---- Front: one candidate ----
  typedef enum logic [1:0] {Empty, Start, Ready} step_t;
  step_t    step_q;
  cand_t    cand_q;
  hit_ray_t ray_q;
  logic     take, is_sphere, sphere_ready, sphere_done, load;

  logic     job_valid_q, job_last_q, issue, issued;

  assign is_sphere  = cand_q.kind == KindSphere;
  assign load       = step_q == Ready && (!is_sphere || sphere_done) && (!job_valid_q || issued);
  assign in_ready_o = step_q == Empty || load;
  assign take       = in_valid_i && in_ready_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      step_q <= Empty;
    end else begin
      unique case (step_q)
        Start:   if (!is_sphere || sphere_ready) step_q <= Ready;
        default: if (in_ready_o) step_q <= in_valid_i ? Start : Empty;
      endcase
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      cand_q <= in_i;
      ray_q  <= in_ray_i;
    end
  end

  logic [HitDivW-1:0] tri_num0, tri_num1, tri_den, sphere_num0, sphere_num1, sphere_den;
  delta_t             sphere_scale0, sphere_scale1;

  hit_norm u_norm (
    .clk_i, .en_i({load && !is_sphere, step_q == Start && !is_sphere}),
    .u_i(cand_q.u), .v_i(cand_q.v), .det_i(cand_q.det),
    .num0_o(tri_num0), .num1_o(tri_num1), .den_o(tri_den)
  );
  hit_sphere u_sphere (
    .clk_i, .rst_ni,
    .start_i(step_q == Start && is_sphere), .ready_o(sphere_ready),
    .disc_i(cand_q.det[50:0]), .towards_i(cand_q.az), .neg_i(ray_q.neg), .norm2_i(ray_q.norm2),
    .done_o(sphere_done), .take_i(load),
    .num0_o(sphere_num0), .num1_o(sphere_num1), .den_o(sphere_den),
    .scale0_o(sphere_scale0), .scale1_o(sphere_scale1)
  );

  // ---- Issue: the candidate's two divisions; what its tail needs waits in a queue ----
  typedef struct packed {
    ctx_t   ctx;
    prim_t  number;
    logic   kind;
    logic   neg;
    logic   cull;
    t_t     tmin;
    delta_t cz;
    delta_t scale0;
    delta_t scale1;
  } division_t;

  function automatic delta_t minus(logic signed [31:0] a, delta_t b);
    return delta_t'(a) - b;  // both corners lie on the grid: it fits
  endfunction
  function automatic division_t job_of(cand_t cand, hit_ray_t ray, delta_t sphere0, delta_t sphere1);
    logic sphere;
    sphere = cand.kind == KindSphere;
    return '{ctx: cand.ctx, number: cand.number, kind: cand.kind, neg: ray.neg, cull: ray.cull,
             tmin: ray.tmin, cz: cand.cz,
             scale0: sphere ? sphere0 : minus(cand.az, cand.cz),
             scale1: sphere ? sphere1 : minus(32'(cand.bz), cand.cz)};
  endfunction

  division_t               job_q;
  logic               queue_ready, div_ready;
  logic [HitDivW-1:0] num, den;

  assign issue  = job_valid_q && (job_last_q || queue_ready);
  assign issued = issue && div_ready && job_last_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      job_valid_q <= 1'b0;
      job_last_q  <= 1'b0;
    end else begin
      if (load) job_valid_q <= 1'b1;
      else if (issued) job_valid_q <= 1'b0;
      if (issue && div_ready) job_last_q <= !job_last_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (load) job_q <= job_of(cand_q, ray_q, sphere_scale0, sphere_scale1);
  end

  // ---- Division and tail ----
  logic  q_valid, q_last, unused_job_valid;
  bary_t q;
  division_t  done_job;
  logic [$clog2(Waiting+1)-1:0] unused_used;

  assign num = (job_q.kind == KindSphere) ? (job_last_q ? sphere_num1 : sphere_num0)
                                          : (job_last_q ? tri_num1 : tri_num0);
  assign den = (job_q.kind == KindSphere) ? sphere_den : tri_den;

  div_pipe #(.NumW(HitDivW), .QFrac(BaryFrac), .BitsPerStage(DivBitsPerStage), .tag_t(logic)) u_div (
    .clk_i, .rst_ni,
    .in_valid_i(issue), .in_ready_o(div_ready), .in_num_i(num), .in_den_i(den), .in_tag_i(job_last_q),
    .out_valid_o(q_valid), .out_ready_i(1'b1), .out_q_o(q), .out_tag_o(q_last)
  );

  stream_fifo #(.data_t(division_t), .Depth(Waiting)) u_queue (
    .clk_i, .rst_ni,
    .valid_i(issue && div_ready && !job_last_q), .ready_o(queue_ready), .data_i(job_q),
    .valid_o(unused_job_valid), .ready_i(q_valid && q_last), .data_o(done_job), .used_o(unused_used)
  );

  hit_distance u_distance (
    .clk_i, .rst_ni,
    .q_valid_i(q_valid), .q_last_i(q_last), .q_i(q),
    .ctx_i(done_job.ctx), .number_i(done_job.number), .kind_i(done_job.kind), .neg_i(done_job.neg),
    .cull_i(done_job.cull), .tmin_i(done_job.tmin), .cz_i(done_job.cz),
    .scale0_i(done_job.scale0), .scale1_i(done_job.scale1),
    .done_o(retire_o), .out_valid_o, .out_o
  );
endmodule
