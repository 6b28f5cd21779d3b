// SPDX-License-Identifier: Apache-2.0
// The distance of an accepted primitive, and where on it: two divisions, then
//   triangle   u = U / det, v = V / det, t = Cz + u (Az - Cz) + v (Bz - Cz)
//   sphere     t = Cz + (b -+ root) / |S|^2                       (units and roundings: the parts)
// on permuted axes, then turned into the ray's direction.
//   front      one candidate: its shift (hit_norm, 2 cycles) or its root (hit_sphere)
//   issue      two cycles: the first division, then the second
//   div_pipe   operands of HitDivW bits, BaryFrac fraction bits, nearest
//   tail       hit_distance
// One triangle every two cycles; a sphere blocks the front while its root is taken. The tail never
// stalls: a result is always taken. retire_o: the candidate of out_o.ctx is finished, whether emitted
// or not. out_valid_o comes with retire_o, at most every second cycle, in order. 2 DSPs.
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
  output logic     retire_o,
  output logic     idle_o        // no candidate inside
);
  localparam int unsigned DivBitsPerStage = 2;
  // Candidates between issue and result: one every two cycles, through the divider (QFrac + 2 bits,
  // and its rounding), the tail's six stages and one to spare.
  localparam int unsigned InFlight = ((BaryFrac + 3) / DivBitsPerStage + 1 + 6) / 2 + 2;
  localparam int unsigned Places   = 16;
  if (InFlight > Places) begin : g_check
    $error("hit_unit: more candidates in flight than places");
  end

  width_check u_widths ();

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
    .disc_i(cand_q.det[2*CoordW-2:0]), .towards_i(cand_q.az), .neg_i(ray_q.neg), .norm2_i(ray_q.norm2),
    .done_o(sphere_done), .take_i(load),
    .num0_o(sphere_num0), .num1_o(sphere_num1), .den_o(sphere_den),
    .scale0_o(sphere_scale0), .scale1_o(sphere_scale1)
  );

  // ---- Issue: the candidate's two divisions ----
  function automatic delta_t minus(towards_t a, delta_t b);
    return delta_t'(a) - b;  // both corners lie on the grid: it fits
  endfunction

  ctx_t               job_ctx_q;
  prim_t              job_number_q;
  logic               job_kind_q;
  delta_t             job_cz_q, scale0_q, scale1_q;
  hit_ray_t           job_ray_q;
  logic               div_ready;
  logic [HitDivW-1:0] num, den;

  assign issue  = job_valid_q;
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
    if (load) begin
      job_ctx_q    <= cand_q.ctx;
      job_number_q <= cand_q.number;
      job_kind_q   <= cand_q.kind;
      job_cz_q     <= cand_q.cz;
      job_ray_q    <= ray_q;
      scale0_q     <= is_sphere ? sphere_scale0 : minus(cand_q.az, cand_q.cz);
      scale1_q     <= is_sphere ? sphere_scale1 : minus(towards_t'(cand_q.bz), cand_q.cz);
    end
  end

  assign num = (job_kind_q == KindSphere) ? (job_last_q ? sphere_num1 : sphere_num0)
                                          : (job_last_q ? tri_num1 : tri_num0);
  assign den = (job_kind_q == KindSphere) ? sphere_den : tri_den;

  // ---- Division and tail ----
  logic  q_valid, q_last;
  bary_t q;

  div_pipe #(.NumW(HitDivW), .QFrac(BaryFrac), .BitsPerStage(DivBitsPerStage), .tag_t(logic)) u_div (
    .clk_i, .rst_ni,
    .in_valid_i(issue), .in_ready_o(div_ready), .in_num_i(num), .in_den_i(den), .in_tag_i(job_last_q),
    .out_valid_o(q_valid), .out_ready_i(1'b1), .out_q_o(q), .out_tag_o(q_last)
  );

  hit_distance #(.Places(Places)) u_distance (
    .clk_i, .rst_ni,
    .put_i(issue && div_ready && !job_last_q), .put_ctx_i(job_ctx_q), .put_number_i(job_number_q),
    .put_kind_i(job_kind_q), .put_cz_i(job_cz_q), .put_scale0_i(scale0_q), .put_scale1_i(scale1_q),
    .put_ray_i(job_ray_q),
    .q_valid_i(q_valid), .q_last_i(q_last), .q_i(q),
    .done_o(retire_o), .out_valid_o, .out_o
  );

  credit #(.Limit(2 + Places)) u_inside (   // one in the front, one being issued
    .clk_i, .rst_ni, .take_i(take), .give_i(retire_o), .available_o(), .idle_o
  );
endmodule
