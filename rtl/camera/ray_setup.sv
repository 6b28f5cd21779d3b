// SPDX-License-Identifier: Apache-2.0
// From a request to the ray that it defines, once and for all: the line org + z (sx, sy, 1) on
// axes permuted so that the dominant one comes last.
//   dominant_axis   axis, neg, num0, num1, den             ShearDivW bits
//   div_pair        q = round(num / den)                   ShearFrac bits, halves up
//   s0              |S| = min(q, 1 - 2^-ShearFrac); sx, sy with their signs
//   s1-s3           sx^2, sy^2                             exact
//   s4              norm2 = round(1 + sx^2 + sy^2)         NormFrac bits, halves up
//   out             the origin permuted
// rx, ry are left zero: slab_setup's. What the divisions do not need waits in a queue beside them.
// A zero direction: valid 0, sx = sy = 0, norm2 = 1, axis 0, neg 0. A request not ok: valid 0.
// One ray a cycle, in order; 4 + 12 + 5 stages. 17 multipliers of 27x18.
// Model: cpp_model/camera/ray_setup.hpp, equal bit for bit.
module ray_setup
  import castray_cfg_pkg::*;
  import castray_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     in_valid_i,
  output logic     in_ready_o,
  input  ray_req_t in_i,

  output logic     out_valid_o,
  input  logic     out_ready_i,
  output ray_t     out_o
);
  // What travels beside the divisions.
  typedef struct packed {
    axis_t axis;
    logic  neg;
    logic  minus0;
    logic  minus1;
    logic  valid;
  } side_t;
  localparam int unsigned KeptRays = 32;   // at least as many as the stages hold
  typedef logic [ShearFrac:0]     quotient_t;
  typedef logic [2*ShearFrac+1:0] square_t;

  // ---- What the divisions do not need ----
  typedef struct packed {
    pixel_tag_t tag;
    point_t     org;
    t_t         tmin;
    t_t         tmax;
    logic       cull;
    logic       any_hit;
    logic       ok;
    prim_t      ignore;
  } kept_t;
  logic  kept_ready, first_ready;
  kept_t kept;
  stream_fifo #(.data_t(kept_t), .Depth(KeptRays)) u_kept (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(in_valid_i && first_ready), .ready_o(kept_ready),
    .data_i('{tag: in_i.tag, org: in_i.org, tmin: in_i.tmin, tmax: in_i.tmax, cull: in_i.cull,
              any_hit: in_i.any_hit, ok: in_i.ok, ignore: in_i.ignore}),
    .valid_o(), .ready_i(out_valid_o && out_ready_i), .data_o(kept)
  );
  assign in_ready_o = first_ready && kept_ready;

  // ---- Dominant axis ----
  logic                 axis_valid, axis_ready, axis_tag;
  logic [ShearDivW-1:0] num0, num1, den;
  side_t                axis_side;
  dominant_axis #(.tag_t(logic)) u_axis (
    .clk_i, .rst_ni,
    .in_valid_i(in_valid_i && kept_ready), .in_ready_o(first_ready), .in_dir_i(in_i.dir), .in_tag_i(1'b0),
    .out_valid_o(axis_valid), .out_ready_i(axis_ready),
    .out_num0_o(num0), .out_num1_o(num1), .out_den_o(den),
    .out_minus0_o(axis_side.minus0), .out_minus1_o(axis_side.minus1),
    .out_axis_o(axis_side.axis), .out_neg_o(axis_side.neg), .out_tag_o(axis_tag)
  );
  assign axis_side.valid = den[ShearDivW-1];

  // ---- Two divisions, shear and norm ----
  localparam int unsigned DivStages = 12;   // div_pair's, as many as its en_i has bits
  localparam int unsigned Stages    = DivStages + 5;
  logic [Stages-1:0] load_all;
  logic [4:0]        load;
  quotient_t [1:0]   quotient;
  side_t             side_q [DivStages];
  side_t             div_side;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(axis_valid), .ready_o(axis_ready),
    .valid_o(out_valid_o), .ready_i(out_ready_i),
    .load_o(load_all)
  );
  div_pair #(.DenW(ShearDivW), .QFrac(ShearFrac)) u_divide (
    .clk_i, .en_i(load_all[DivStages-1:0]), .num_i({num1, num0}), .den_i(den), .q_o(quotient)
  );
  always_ff @(posedge clk_i) begin
    if (load_all[0]) side_q[0] <= axis_side;
    for (int unsigned i = 1; i < DivStages; i++) if (load_all[i]) side_q[i] <= side_q[i-1];
  end
  assign div_side = side_q[DivStages-1];
  assign load     = load_all[Stages-1:DivStages];

  function automatic shear_t signed_shear(quotient_t q, logic minus, logic valid);
    logic [ShearFrac-1:0] below_one;
    below_one = !valid ? '0 : q[ShearFrac] ? '1 : q[ShearFrac-1:0];
    return minus ? -shear_t'({1'b0, below_one}) : shear_t'({1'b0, below_one});
  endfunction

  // Squares are not negative: their top bit is zero.
  function automatic norm2_t round_norm(square_t xx, square_t yy);
    localparam int unsigned Drop = 2 * ShearFrac - NormFrac;
    logic [2*ShearFrac+1:0] sum;
    sum = xx + yy + (square_t'(1) << (2 * ShearFrac)) + (square_t'(1) << (Drop - 1));
    return norm2_t'(sum >> Drop);
  endfunction

  typedef struct packed {
    axis_t axis;
    logic  neg;
    logic  valid;
  } rest_t;
  shear_t  sx_q [5], sy_q [5];
  rest_t   rest_q [5];
  norm2_t  norm2_q;
  mul54_t xx, yy;
  width_check u_widths ();
  mul27 u_xx (.clk_i, .en_i(load[3:1]), .a_i(mul27_t'(sx_q[0])), .b_i(mul27_t'(sx_q[0])), .p_o(xx));
  mul27 u_yy (.clk_i, .en_i(load[3:1]), .a_i(mul27_t'(sy_q[0])), .b_i(mul27_t'(sy_q[0])), .p_o(yy));

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      sx_q[0]   <= signed_shear(quotient[0], div_side.minus0, div_side.valid);
      sy_q[0]   <= signed_shear(quotient[1], div_side.minus1, div_side.valid);
      rest_q[0] <= '{axis: div_side.axis, neg: div_side.neg, valid: div_side.valid};
    end
    for (int unsigned i = 1; i < 5; i++) begin
      if (load[i]) begin
        sx_q[i]   <= sx_q[i-1];
        sy_q[i]   <= sy_q[i-1];
        rest_q[i] <= rest_q[i-1];
      end
    end
    if (load[4]) norm2_q <= round_norm(square_t'(xx), square_t'(yy));
  end

  assign out_o = '{
    tag: kept.tag, org: permute(kept.org, rest_q[4].axis), sx: sx_q[4], sy: sy_q[4], norm2: norm2_q,
    axis: rest_q[4].axis, neg: rest_q[4].neg, valid: rest_q[4].valid && kept.ok,
    cull: kept.cull, any_hit: kept.any_hit, tmin: kept.tmin, tmax: kept.tmax, ignore: kept.ignore, rx: '0, ry: '0
  };

  logic unused_tag;
  assign unused_tag = axis_tag;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (kept_ready || !first_ready) else $error("the queue beside the stages is shorter than they are");
  end
`endif
endmodule
