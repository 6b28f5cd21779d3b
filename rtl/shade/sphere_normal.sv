// SPDX-License-Identifier: Apache-2.0
// The vector from a sphere's centre to the hit, in grid steps, not normalised:
//   z = (neg ? -t : t) to whole steps;  P = eye + z (Sx, Sy, 1) on permuted axes;  V = P - centre
// Sx z in one cycle, Sy z in the next, through one multiplier.
//   s0     signed t
//   s1     z: round half up, saturated to CoordW + 1 bits (a hit is nearer than that)
//   s2..4  S z                                        exact, 27x27 (mul27)
//   s5     to whole steps (round half up)
//   out    unpermuted, plus eye - centre              exact
// 2 DSPs. One hit every two cycles, in order, latency 8 cycles from a hit's first.
// Model: cpp_model/shade/sphere_normal.hpp, equal bit for bit.
module sphere_normal
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  point_t     eye_i,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  shade_req_t in_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output span3_t     out_o
);
  localparam int unsigned Stages = 6;
  if (CoordW > 26 || ShearFrac > 26) begin : g_check
    $error("sphere_normal: CoordW and ShearFrac must be at most 26, the multiplier's operands");
  end

  typedef logic signed [CoordW+TFrac+1:0] depth_t;  // t of either sign, 1/16 steps
  typedef logic signed [CoordW+1:0]       offset_t; // S z in steps

  // The only places where precision is dropped.
  function automatic delta_t round_depth(depth_t t);
    logic signed [CoordW+1:0] z;
    z = (CoordW+2)'((t + depth_t'(1 << (TFrac - 1))) >>> TFrac);
    if (z[CoordW+1] != z[CoordW]) return {z[CoordW+1], {CoordW{!z[CoordW+1]}}};
    return delta_t'(z);
  endfunction
  function automatic offset_t round_offset(mul54_t p);
    return offset_t'((p + mul54_t'(1 << (ShearFrac - 1))) >>> ShearFrac);
  endfunction
  function automatic depth_t signed_depth(logic neg, t_t t);
    return neg ? -depth_t'(t) : depth_t'(t);
  endfunction
  function automatic delta_t minus(coord_t a, coord_t b);
    return delta_t'({1'b0, a}) - delta_t'({1'b0, b});
  endfunction

  // ---- Two halves a hit ----
  logic [Stages-1:0] load;
  logic half_q;                        // 0: Sx z, 1: Sy z
  logic chain_ready, chain_valid, chain_taken;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(chain_ready),
    .valid_o(chain_valid), .ready_i(chain_taken), .load_o(load)
  );
  assign in_ready_o = chain_ready && half_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) half_q <= 1'b0;
    else if (load[0]) half_q <= !half_q;
  end

  // ---- S z ----
  depth_t             depth_q;
  delta_t             z_q [1:Stages-1];
  shear_t             shear_q [2];
  mul54_t product;
  offset_t            offset_q;
  mul27 u_mul (
    .clk_i, .en_i(load[4:2]), .a_i(mul27_t'(shear_q[1])), .b_i(mul27_t'(z_q[1])), .p_o(product)
  );
  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      depth_q    <= signed_depth(in_i.hit.neg, in_i.hit.t);
      shear_q[0] <= half_q ? in_i.hit.sy : in_i.hit.sx;
    end
    if (load[1]) begin
      shear_q[1] <= shear_q[0];
      z_q[1]     <= round_depth(depth_q);
    end
    for (int unsigned i = 2; i < Stages; i++) if (load[i]) z_q[i] <= z_q[i-1];
    if (load[5]) offset_q <= round_offset(product);
  end

  // ---- What goes along ----
  typedef struct packed {
    logic   half;
    axis_t  axis;
    delta_t dx, dy, dz;   // eye - centre
  } side_t;
  side_t side_q [Stages];
  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      side_q[0] <= '{
        half: half_q, axis: in_i.hit.axis,
        dx: minus(eye_i.x, in_i.attr.centre.x),
        dy: minus(eye_i.y, in_i.attr.centre.y),
        dz: minus(eye_i.z, in_i.attr.centre.z)
      };
    end
    for (int unsigned i = 1; i < Stages; i++) if (load[i]) side_q[i] <= side_q[i-1];
  end

  // ---- The halves meet ----
  side_t   side;
  span3_t  along, turned, sum;
  offset_t first_q;
  logic    out_ready;
  assign side        = side_q[Stages-1];
  assign chain_taken = !side.half || out_ready;
  always_ff @(posedge clk_i) begin
    if (chain_valid && !side.half) first_q <= offset_q;
  end

  function automatic span_t plus(span_t a, delta_t b);
    return a + span_t'(b);
  endfunction
  assign along = '{x: span_t'(first_q), y: span_t'(offset_q), z: span_t'(z_q[Stages-1])};
  unpermute u_turn (.axis_i(side.axis), .in_i(along), .out_o(turned));
  assign sum = '{x: plus(turned.x, side.dx), y: plus(turned.y, side.dy), z: plus(turned.z, side.dz)};

  pipe_stage #(.data_t(span3_t)) u_out (
    .clk_i, .rst_ni,
    .valid_i(chain_valid && side.half), .ready_o(out_ready), .data_i(sum),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_o)
  );
endmodule
