// SPDX-License-Identifier: Apache-2.0
// From the two quotients of a candidate to the distance along the ray.
//            triangle: q0 = u, q1 = v                 sphere: q scale = a root, quarter steps
//   s1-s3    u (Az - Cz), v (Bz - Cz)                 q0 scale0, q1 scale1        exact, 4 DSPs
//   s4       their sum                                q0 scale0 alone             exact
//   s5       z = Cz + sum in 1/16 steps, nearest      z = Cz +- each              turned, where neg
//   s6       +-z                                      both                        clamped to +-TMax
//   s7       out if beyond tmin                       the nearer root beyond tmin, else (unless
//                                                     back faces are culled) the farther
// One candidate a cycle, seven cycles, never stalls. What belongs to a candidate is put into small
// memories, at a place of its own, when it enters the hit unit (put_i), and read where it is needed.
// Model: cpp_model/isect/hit_distance.hpp, equal bit for bit.
module hit_distance
  import castray_cfg_pkg::*, castray_pkg::*;
#(
  parameter int unsigned PlaceW = HitPlaceW
) (
  input  logic              clk_i,
  input  logic              rst_ni,

  input  logic              put_i,
  input  logic [PlaceW-1:0] put_place_i,
  input  ctx_t              put_ctx_i,
  input  prim_t             put_number_i,
  input  logic              put_kind_i,
  input  delta_t            put_cz_i,
  input  lane_no_t          put_lane_i,
  input  hit_ray_t          put_ray_i,

  input  logic              q_valid_i,
  input  logic [PlaceW-1:0] q_place_i,
  input  bary_t             q0_i,
  input  bary_t             q1_i,
  input  delta_t            scale0_i,
  input  delta_t            scale1_i,

  output logic              done_o,
  output logic              out_valid_o,
  output result_t           out_o,
  output lane_no_t          out_lane_o
);
  // ---- What waits for the quotients, and where they wait for the distance ----
  typedef logic [PlaceW-1:0] place_t;
  typedef struct packed {
    logic   kind;
    logic   neg;
    delta_t cz;
  } base_t;        // for s5
  typedef struct packed {
    lane_no_t lane;
    ctx_t     ctx;
    prim_t    number;
    logic     cull;
    t_t       tmin;
  } kept_t;        // for s7
  typedef struct packed {
    bary_t u;
    bary_t v;
  } where_t;
  localparam int unsigned WaitCycles = 6;   // of u and v: until the last stage but one
  typedef logic [2:0] turn_t;
  if (WaitCycles >= 1 << $bits(turn_t)) begin : g_check
    $error("hit_distance: the places of u and v are fewer than the cycles that they wait");
  end

  base_t  base_q [1 << PlaceW];
  kept_t  kept_q [1 << PlaceW];
  where_t where_q [1 << $bits(turn_t)];

  // Stage k holds a candidate, and which one.
  logic [WaitCycles:1] valid_q;
  place_t     place_q [WaitCycles:1];
  turn_t      turn_q;   // the place of u and v is that of the cycle

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
      turn_q  <= '0;
    end else begin
      valid_q <= {valid_q[WaitCycles-1:1], q_valid_i};
      turn_q  <= turn_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (q_valid_i) place_q[1] <= q_place_i;
    for (int unsigned i = 2; i <= WaitCycles; i++) if (valid_q[i-1]) place_q[i] <= place_q[i-1];
  end
  always_ff @(posedge clk_i) begin
    if (put_i) begin
      base_q[put_place_i] <= '{kind: put_kind_i, neg: put_ray_i.neg, cz: put_cz_i};
      kept_q[put_place_i] <= '{lane: put_lane_i, ctx: put_ctx_i, number: put_number_i, cull: put_ray_i.cull,
                               tmin: put_ray_i.tmin};
    end
    if (q_valid_i) where_q[turn_q] <= '{u: q0_i, v: q1_i};
  end

  // ---- s1 to s3 ----
  mul54_t p0, p1;
  mul27 u_part0 (.clk_i, .en_i({valid_q[2:1], q_valid_i}),
                 .a_i(mul27_t'(scale0_i)), .b_i(mul27_t'({1'b0, q0_i})), .p_o(p0));
  mul27 u_part1 (.clk_i, .en_i({valid_q[2:1], q_valid_i}),
                 .a_i(mul27_t'(scale1_i)), .b_i(mul27_t'({1'b0, q1_i})), .p_o(p1));

  // ---- s4 to s6 ----
  typedef logic signed [CoordW+8:0]  part_t;   // a sphere's, quarter steps
  typedef logic signed [CoordW+11:0] wide_t;

  // The only place where precision is lost: a triangle's sum, to the last bit of a distance. The bits that
  // are dropped are the first function's, the half that decides is added by the second.
  function automatic wide_t sixteenths(mul_sum_t sum);
    return wide_t'(sum >>> (BaryFrac - TFrac));
  endfunction
  function automatic logic half_up(mul_sum_t sum);
    return sum[BaryFrac-TFrac-1];
  endfunction
  // Cz and what is added to it or, for a sphere ahead of a ray that goes back, subtracted.
  function automatic wide_t along(delta_t cz, wide_t part, logic minus, logic one);
    wide_t sum;
    logic  unused;
    {sum, unused} = {wide_t'(cz) <<< TFrac, 1'b0} - {part ^ {$bits(wide_t){!minus}}, !(minus || one)};
    return sum;
  endfunction
  function automatic t_t turned(wide_t z, logic neg);
    wide_t t;
    t = neg ? -z : z;
    if (t > wide_t'(TMax)) return TMax;
    if (t < -wide_t'(TMax)) return -TMax;
    return t_t'(t);
  endfunction

  base_t              base3, base4_q;
  logic               kind5_q, neg5_q, kind6_q;
  mul_sum_t           sum4_q;
  part_t              part4_q;
  wide_t              z0_q, z1_q;
  t_t                 t0_q, t1_q;
  assign base3 = base_q[place_q[3]];

  always_ff @(posedge clk_i) begin
    if (valid_q[3]) begin
      base4_q <= base3;
      sum4_q  <= mul_sum_t'(p0) + ((base3.kind == KindSphere) ? '0 : mul_sum_t'(p1));
      part4_q <= part_t'(p1);
    end
    if (valid_q[4]) begin
      kind5_q <= base4_q.kind;
      neg5_q  <= base4_q.neg;
      z0_q    <= along(base4_q.cz, (base4_q.kind == KindSphere) ? wide_t'(part_t'(sum4_q)) <<< (TFrac - 2)
                                                                : sixteenths(sum4_q),
                       base4_q.kind == KindSphere && base4_q.neg, base4_q.kind == KindTriangle && half_up(sum4_q));
      z1_q    <= along(base4_q.cz, wide_t'(part4_q) <<< (TFrac - 2), base4_q.neg, 1'b0);
    end
    if (valid_q[5]) begin
      kind6_q <= kind5_q;
      t0_q    <= turned(z0_q, neg5_q);
      t1_q    <= turned(z1_q, neg5_q);
    end
  end

  // ---- s7 ----
  function automatic logic beyond(t_t t, t_t tmin);
    return t > tmin;
  endfunction

  kept_t  kept;
  where_t uv;
  logic   sphere6, first, second;
  assign kept    = kept_q[place_q[WaitCycles]];
  assign uv      = where_q[turn_q - turn_t'(WaitCycles)];
  assign sphere6 = kind6_q == KindSphere;
  assign first   = beyond(t0_q, kept.tmin);
  assign second  = sphere6 && !kept.cull && beyond(t1_q, kept.tmin);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      done_o      <= 1'b0;
      out_valid_o <= 1'b0;
    end else begin
      done_o      <= valid_q[WaitCycles];
      out_valid_o <= valid_q[WaitCycles] && (first || second);
    end
  end
  always_ff @(posedge clk_i) begin
    if (valid_q[WaitCycles]) begin
      out_lane_o   <= kept.lane;
      out_o.ctx    <= kept.ctx;
      out_o.number <= kept.number;
      out_o.kind   <= kind6_q;
      out_o.t      <= first ? t0_q : t1_q;
      out_o.u      <= sphere6 ? '0 : uv.u;
      out_o.v      <= sphere6 ? '0 : uv.v;
    end
  end
endmodule
