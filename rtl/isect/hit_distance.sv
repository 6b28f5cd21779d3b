// SPDX-License-Identifier: Apache-2.0
// From the two quotients of a candidate, q0 then q1, to the distance along the ray.
//            triangle: q0 = u, q1 = v                 sphere: q scale = a root, quarter steps
//   s1-s3    u (Az - Cz), v (Bz - Cz)                 q0 scale0, q1 scale1        exact, 2 DSPs
//   s4       their sum in 1/16 steps, nearest         both
//   s5       +-(Cz + sum)                             +-Cz + each                 clamped to +-TMax
//   s6       out if beyond tmin                       the nearer root beyond tmin, else (unless
//                                                     back faces are culled) the farther
// One quotient a cycle, six cycles from the second one, never stalls. What belongs to a candidate
// is put into small memories when it is issued (put_i) and read where it is needed; at most Places
// candidates may be on their way from there to the result.
// Model: cpp_model/isect/hit_distance.hpp, equal bit for bit.
module hit_distance
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned Places = 16
) (
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     put_i,
  input  ctx_t     put_ctx_i,
  input  prim_t    put_number_i,
  input  logic     put_kind_i,
  input  delta_t   put_cz_i,
  input  delta_t   put_scale0_i,
  input  delta_t   put_scale1_i,
  input  hit_ray_t put_ray_i,

  input  logic     q_valid_i,
  input  logic     q_last_i,     // the candidate's second
  input  bary_t    q_i,

  output logic     done_o,
  output logic     out_valid_o,
  output result_t  out_o
);
  if (Places < 16 || (Places & (Places - 1)) != 0) begin : g_check
    $error("hit_distance: Places must be a power of two, 16 or more");
  end

  // ---- What waits for the quotients ----
  typedef logic [$clog2(Places)-1:0] place_t;
  typedef struct packed {
    delta_t scale0;
    delta_t scale1;
  } scales_t;
  typedef struct packed {
    ctx_t   ctx;
    prim_t  number;
    logic   kind;
    logic   neg;
    logic   cull;
  } kept_t;

  place_t  put_place_q, q_place_q, sum_place_q, out_place_q;
  scales_t scales_q [Places];
  delta_t  cz_q [Places];
  kept_t   kept_q [Places];
  t_t      tmin_q [Places];
  bary_t   u_q [Places];
  bary_t   v_q [Places];

  // valid_q[k], last_q[k]: stage k holds a quotient, the second one.
  logic [3:1] valid_q;
  logic [5:1] last_q;
  logic       last;
  assign last = q_valid_i && q_last_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q     <= '0;
      last_q      <= '0;
      put_place_q <= '0;
      q_place_q   <= '0;
      sum_place_q <= '0;
      out_place_q <= '0;
    end else begin
      valid_q <= {valid_q[2:1], q_valid_i};
      last_q  <= {last_q[4:1], last};
      if (put_i) put_place_q <= put_place_q + 1'b1;
      if (last) q_place_q <= q_place_q + 1'b1;
      if (last_q[3]) sum_place_q <= sum_place_q + 1'b1;
      if (last_q[5]) out_place_q <= out_place_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (put_i) begin
      scales_q[put_place_q] <= '{scale0: put_scale0_i, scale1: put_scale1_i};
      cz_q[put_place_q]     <= put_cz_i;
      tmin_q[put_place_q]   <= put_ray_i.tmin;
      kept_q[put_place_q]   <= '{ctx: put_ctx_i, number: put_number_i, kind: put_kind_i,
                                 neg: put_ray_i.neg, cull: put_ray_i.cull};
    end
  end

  // ---- s1 to s3 ----
  mul54_t p, p0_q;
  scales_t            scales;
  delta_t             scale;
  assign scales = scales_q[q_place_q];
  assign scale  = q_last_i ? scales.scale1 : scales.scale0;

  mul27 u_part (.clk_i, .en_i({valid_q[2:1], q_valid_i}),
                .a_i(mul27_t'(scale)), .b_i(mul27_t'({1'b0, q_i})), .p_o(p));

  always_ff @(posedge clk_i) begin
    if (q_valid_i && !q_last_i) u_q[q_place_q] <= q_i;
    if (last) v_q[q_place_q] <= q_i;
  end
  always_ff @(posedge clk_i) begin
    if (valid_q[3] && !last_q[3]) p0_q <= p;
  end

  // ---- s4, s5: a triangle's sum in 1/16 steps, a sphere's parts in quarter steps; distances ----
  typedef logic signed [CoordW+8:0]  part_t;
  typedef logic signed [CoordW+11:0] wide_t;

  // The only place where precision is lost: to the last bit of a distance.
  function automatic part_t round_parts(mul54_t a, mul54_t b);
    logic signed [54:0] sum;
    sum = 55'(a) + 55'(b) + (55'sd1 <<< (BaryFrac - TFrac - 1));
    return part_t'(sum >>> (BaryFrac - TFrac));
  endfunction
  function automatic t_t clamp(wide_t t);
    if (t > wide_t'(TMax)) return TMax;
    if (t < -wide_t'(TMax)) return -TMax;
    return t_t'(t);
  endfunction
  // A triangle's part is along the dominant axis, a sphere's already along the ray.
  function automatic t_t distance(logic kind, logic neg, delta_t cz, part_t part);
    wide_t base, wide;
    base = wide_t'(cz) <<< TFrac;
    wide = (kind == KindSphere) ? wide_t'(part) <<< (TFrac - 2) : neg ? -wide_t'(part) : wide_t'(part);
    return clamp((neg ? -base : base) + wide);
  endfunction

  logic               kind4_q, neg4_q;
  delta_t             cz4_q;
  part_t              part0_q, part1_q;
  t_t                 t0_q, t1_q;

  always_ff @(posedge clk_i) begin
    if (last_q[3]) begin
      kind4_q <= kept_q[sum_place_q].kind;
      neg4_q  <= kept_q[sum_place_q].neg;
      cz4_q   <= cz_q[sum_place_q];
      part0_q <= (kept_q[sum_place_q].kind == KindSphere) ? part_t'(p0_q) : round_parts(p0_q, p);
      part1_q <= part_t'(p);
    end
  end
  always_ff @(posedge clk_i) begin
    if (last_q[4]) begin
      t0_q <= distance(kind4_q, neg4_q, cz4_q, part0_q);
      t1_q <= distance(kind4_q, neg4_q, cz4_q, part1_q);
    end
  end

  // ---- s6 ----
  function automatic logic beyond(t_t t, t_t tmin);
    return t > tmin;
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      done_o      <= 1'b0;
      out_valid_o <= 1'b0;
    end else begin
      done_o      <= last_q[5];
      out_valid_o <= 1'b0;
      if (last_q[5]) begin
        out_valid_o <= beyond(t0_q, tmin_q[out_place_q])
                       || (kept_q[out_place_q].kind == KindSphere && !kept_q[out_place_q].cull
                           && beyond(t1_q, tmin_q[out_place_q]));
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (last_q[5]) begin
      out_o.ctx    <= kept_q[out_place_q].ctx;
      out_o.number <= kept_q[out_place_q].number;
      out_o.kind   <= kept_q[out_place_q].kind;
      out_o.t      <= beyond(t0_q, tmin_q[out_place_q]) ? t0_q : t1_q;
      out_o.u      <= (kept_q[out_place_q].kind == KindSphere) ? '0 : u_q[out_place_q];
      out_o.v      <= (kept_q[out_place_q].kind == KindSphere) ? '0 : v_q[out_place_q];
    end
  end
endmodule
