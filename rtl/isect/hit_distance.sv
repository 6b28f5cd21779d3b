// SPDX-License-Identifier: Apache-2.0
// From the two quotients of a candidate, q0 then q1, to the distance along the ray.
//            triangle: q0 = u, q1 = v                 sphere: q scale = a root, quarter steps
//   s1-s3    u (Az - Cz), v (Bz - Cz)                 q0 scale0, q1 scale1        exact, 2 DSPs
//   s4       their sum in 1/16 steps, nearest         both
//   s5       +-(Cz + sum)                             +-Cz + each                 clamped to +-TMax
//   s6       out if beyond tmin                       the nearer root beyond tmin, else (unless
//                                                     back faces are culled) the farther
// One quotient a cycle, six cycles from the second one, never stalls. What belongs to the candidate
// is on the ports while its quotients come, and moves every second cycle from there.
// Model: cpp_model/isect/hit_distance.hpp, equal bit for bit.
module hit_distance
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic    clk_i,
  input  logic    rst_ni,

  input  logic    q_valid_i,
  input  logic    q_last_i,     // the candidate's second
  input  bary_t   q_i,
  input  ctx_t    ctx_i,
  input  prim_t   number_i,
  input  logic    kind_i,
  input  logic    neg_i,
  input  logic    cull_i,
  input  t_t      tmin_i,
  input  delta_t  cz_i,
  input  delta_t  scale0_i,
  input  delta_t  scale1_i,

  output logic    done_o,
  output logic    out_valid_o,
  output result_t out_o
);
  typedef struct packed {
    ctx_t   ctx;
    prim_t  number;
    logic   kind;
    logic   cull;
    t_t     tmin;
    bary_t  u;
    bary_t  v;
  } rest_t;

  // valid_q[k], last_q[k]: stage k holds a quotient, the second one.
  logic [3:1]         valid_q;
  logic [5:1]         last_q;
  logic               last, neg1_q, neg3_q;
  bary_t              q0_q;
  rest_t              rest1_q, rest3_q, rest5_q;
  delta_t             cz1_q, cz3_q;
  logic signed [53:0] p, p0_q;
  logic signed [34:0] part0_q, part1_q;
  t_t                 t0_q, t1_q;

  assign last = q_valid_i && q_last_i;

  mul27 u_part (.clk_i, .en_i({valid_q[2:1], q_valid_i}), .a_i(q_last_i ? scale1_i : scale0_i),
                .b_i({2'b0, q_i}), .p_o(p));

  // The only place where precision is lost: to 1/16 steps.
  function automatic logic signed [34:0] round_parts(logic signed [53:0] a, logic signed [53:0] b);
    logic signed [54:0] sum;
    sum = 55'(a) + 55'(b) + (55'sd1 <<< (BaryFrac - TFrac - 1));
    return 35'(sum >>> (BaryFrac - TFrac));
  endfunction
  function automatic t_t clamp_sum(delta_t cz, logic neg, logic signed [36:0] part);
    logic signed [37:0] base, sum;
    base = 38'(cz) <<< TFrac;
    sum = (neg ? -base : base) + 38'(part);
    if (sum > 38'(TMax)) return TMax;
    if (sum < -38'(TMax)) return -TMax;
    return t_t'(sum);
  endfunction
  function automatic logic signed [36:0] part_of(logic kind, logic neg, logic signed [34:0] part);
    if (kind == KindSphere) return 37'(part) <<< (TFrac - 2);
    return neg ? -37'(part) : 37'(part);
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
      last_q  <= '0;
      done_o  <= 1'b0;
    end else begin
      valid_q <= {valid_q[2:1], q_valid_i};
      last_q  <= {last_q[4:1], last};
      done_o  <= last_q[5];
    end
  end

  always_ff @(posedge clk_i) begin
    if (q_valid_i && !q_last_i) q0_q <= q_i;
    if (last) begin
      rest1_q <= '{ctx: ctx_i, number: number_i, kind: kind_i, cull: cull_i, tmin: tmin_i,
                   u: q0_q, v: q_i};
      neg1_q  <= neg_i;
      cz1_q   <= cz_i;
    end
    if (last_q[2]) begin
      rest3_q <= rest1_q;
      neg3_q  <= neg1_q;
      cz3_q   <= cz1_q;
    end
    if (last_q[4]) rest5_q <= rest3_q;

    if (valid_q[3] && !last_q[3]) p0_q <= p;
    if (last_q[3]) begin
      part0_q <= (rest3_q.kind == KindSphere) ? 35'(p0_q) : round_parts(p0_q, p);
      part1_q <= 35'(p);
    end
    if (last_q[4]) begin
      t0_q <= clamp_sum(cz3_q, neg3_q, part_of(rest3_q.kind, neg3_q, part0_q));
      t1_q <= clamp_sum(cz3_q, neg3_q, part_of(rest3_q.kind, neg3_q, part1_q));
    end
  end

  // The arithmetic comparisons need signed operands of their own.
  t_t   tmin5;
  logic near5, far5;
  assign tmin5 = rest5_q.tmin;
  assign near5 = t0_q > tmin5;
  assign far5  = rest5_q.kind == KindSphere && !rest5_q.cull && t1_q > tmin5;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) out_valid_o <= 1'b0;
    else out_valid_o <= last_q[5] && (near5 || far5);
  end
  always_ff @(posedge clk_i) begin
    if (last_q[5]) begin
      out_o.ctx    <= rest5_q.ctx;
      out_o.number <= rest5_q.number;
      out_o.kind   <= rest5_q.kind;
      out_o.t      <= near5 ? t0_q : t1_q;
      out_o.u      <= (rest5_q.kind == KindSphere) ? '0 : rest5_q.u;
      out_o.v      <= (rest5_q.kind == KindSphere) ? '0 : rest5_q.v;
    end
  end
endmodule
