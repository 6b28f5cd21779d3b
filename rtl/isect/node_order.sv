// SPDX-License-Identifier: Apache-2.0
// Which children are visited, in which order, and the least t of each:
//   s1  plane: the node's first plane across the dominant axis, margin included, in units of
//       2^-DistFrac of a dist_t's last bit; rounded towards the ray's origin
//   s2  visited: the child's stretch is one, and meets the limits'. Its place: how many enter sooner,
//       or in the same tick with a lower number. z = plane + the tick of entry
//   s3  least = z, or ~z where the ray runs along -z, cut to 0 and the largest; the entries in place
//       combinational, for the register of who decides. Where no child comes the kind is RefNone, and the
//       rest of the entry any child's
// One node a cycle, never stalls; en_i[k]: stage k + 1 takes an item. neg_i, dz_i and ez_i belong to
// s1, the children's and the limits' stretches to s2, targets to s3.
// Model: cpp_model/isect/node_order.hpp, equal bit for bit in what is read: of an entry without a target, only its kind.
module node_order
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic        clk_i,

  input  logic [1:0]  en_i,
  input  logic        neg_i,
  input  delta_t      dz_i,
  input  plane_exp_t  ez_i,
  input  logic [3:0]  exists_i,
  input  logic [3:0]  none_i,
  input  tick_t [3:0] low_i,
  input  tick_t [3:0] high_i,
  input  logic        limits_none_i,
  input  tick_t       first_i,
  input  tick_t       last_i,
  input  ref_t [3:0]  target_i,

  output visits_t     out_o
);
  localparam int unsigned Unit = CoordW - DistW - DistFrac;
  localparam int unsigned ZW   = 8 + MaxPlaneExp - Unit + 3;
  typedef logic signed [ZW-1:0] z_t;
  typedef struct packed {
    logic [3:0]       some;   // [k]: a child comes in place k
    logic [3:0] [1:0] who;    // [k]: its number
  } places_t;

  // Of -dz rounded towards the origin, so of dz upwards: a unit more.
  function automatic z_t plane(delta_t dz, logic neg);
    logic signed [CoordW+1:0] sum;
    sum = (CoordW+2)'(dz) + (neg ? (CoordW+2)'(BoxMargin + (1 << Unit)) : -(CoordW+2)'(BoxMargin));
    sum = sum >>> Unit;
    return z_t'(sum);
  endfunction

  function automatic z_t ticks(tick_t tick, plane_exp_t ez);
    logic [$bits(tick_t)+30:0] wide;
    wide = {31'b0, tick};
    for (int k = 4; k >= 0; k--) if (ez[k]) wide = wide << (1 << k);
    return z_t'(wide >> (SubPlane + Unit));
  endfunction

  function automatic dist_t least(z_t z, logic neg);
    z_t t;
    t = (neg ? ~z : z) >>> DistFrac;
    if (t < 0) return '0;
    return (t >>> DistW) != '0 ? '1 : dist_t'(t);
  endfunction

  // ---- s1, s2 ----
  z_t          plane_q;
  z_t [3:0]    z_q;
  plane_exp_t  ez_q;
  logic        neg_q, neg2_q;
  places_t     place_q;

  // Whether two of four bits are set, or more.
  function automatic logic two(logic [3:0] x);
    return (x[0] && x[1]) || (x[2] && x[3]) || ((x[0] || x[1]) && (x[2] || x[3]));
  endfunction

  function automatic places_t places();
    logic  [3:0]       visited;
    tick_t [3:0]       entered;
    logic  [3:0] [3:0] ahead;      // [i][j]: child j comes before child i; those that are not visited come last
    for (int unsigned i = 0; i < 4; i++) begin
      visited[i] = exists_i[i] && !none_i[i] && !limits_none_i && low_i[i] <= high_i[i] && low_i[i] <= last_i
                   && high_i[i] >= first_i;
      entered[i] = neg_q ? ~high_i[i] : low_i[i];
    end
    ahead = '0;
    for (int unsigned i = 0; i < 4; i++) begin
      for (int unsigned j = 0; j < i; j++) begin
        ahead[i][j] = !visited[i] || (visited[j] && entered[j] <= entered[i]);
        ahead[j][i] = !ahead[i][j];
      end
    end
    places.who  = '0;
    places.some = {&visited, (&visited[1:0] && |visited[3:2]) || (&visited[3:2] && |visited[1:0]), two(visited), |visited};
    for (int unsigned k = 0; k < 4; k++) begin
      for (int unsigned i = 0; i < 4; i++) begin
        if ({two(ahead[i]), ^ahead[i]} == 2'(k)) places.who[k] |= 2'(i);   // so many are ahead, three at most
      end
    end
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      plane_q <= plane(dz_i, neg_i);
      ez_q    <= ez_i;
      neg_q   <= neg_i;
    end
    if (en_i[1]) begin
      place_q <= places();
      neg2_q  <= neg_q;
      for (int unsigned i = 0; i < 4; i++) z_q[i] <= plane_q + ticks(neg_q ? high_i[i] : low_i[i], ez_q);
    end
  end

  // ---- s3 ----
  function automatic visits_t entries();
    entry_t [3:0] child, entry;
    for (int unsigned i = 0; i < 4; i++) child[i] = '{least: least(z_q[i], neg2_q), target: target_i[i]};
    for (int unsigned k = 0; k < 4; k++) begin
      entry[k] = child[place_q.who[k]];
      if (!place_q.some[k]) entry[k].target.kind = RefNone;
    end
    return '{e0: entry[0], e1: entry[1], e2: entry[2], e3: entry[3]};
  endfunction
  assign out_o = entries();
endmodule
