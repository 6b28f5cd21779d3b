// SPDX-License-Identifier: Apache-2.0
// unit = V / |V|, three components in Q2.16; V has signed components of SpanW bits. Zero gives zero.
//   s1          spread = |x| or |y| or |z|: its top one is that of the largest
//   s2          top = the place of that one
//   s3          v = V 2^(16 - top)                    18 bits, to the right rounded down
//   s4, s5      square = v . v                        36 bits, exact; 3 DSPs
//   cordic_sqrt odd = square >= 2^34; rad = square >> (odd ? 10 : 8), truncated
//               root = sqrt(rad)                      Q13.5
//   div_pipe    inverse = round(2^34 / root)          Q2.16 of 2^18 / root; root 0: 0
//   s6          operands; v and the tag come out of a queue in which they waited since s3
//   s7          v inverse                             37 bits, exact; 3 DSPs
//   s8          unit = round(v inverse / 2^(17 + odd)), halves upwards
// One vector a cycle, in order, 32 cycles. Each component is within 3 units of 2^-16.
// Model: cpp_model/shade/normalise.hpp, equal bit for bit.
module normalise
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter type tag_t = logic [7:0]
) (
  input  logic   clk_i,
  input  logic   rst_ni,

  input  logic   in_valid_i,
  output logic   in_ready_o,
  input  span_t  in_x_i,
  input  span_t  in_y_i,
  input  span_t  in_z_i,
  input  tag_t   in_tag_i,

  output logic   out_valid_o,
  input  logic   out_ready_i,
  output unit3_t out_o,
  output tag_t   out_tag_o
);
  // At least the vectors that s4, s5, cordic_sqrt and div_pipe hold: so it is never full.
  localparam int unsigned QueueDepth = 32;
  if (SpanW != 29 || UnitFrac != 16 || RootRadW != 26 || RootFrac != 5) begin : g_check
    $error("normalise: made for SpanW 29, UnitFrac 16, RootRadW 26 and RootFrac 5");
  end

  typedef logic [SpanW-1:0]          magnitude_t;
  typedef logic [$clog2(SpanW)-1:0]  place_t;
  localparam int unsigned SmallW  = UnitFrac + 2;
  localparam int unsigned SquareW = 2 * SmallW;
  localparam int unsigned RootW   = RootRadW / 2 + RootFrac;
  typedef logic signed [SmallW-1:0]  small_t;
  typedef logic [SquareW-1:0]        square_t;
  typedef logic [RootW-1:0]          root_t;
  typedef logic [InverseFrac:0]      inverse_t;
  typedef logic signed [SmallW+InverseFrac+1:0] product_t;
  typedef struct packed { small_t x, y, z; } small3_t;
  typedef struct packed {
    small3_t v;
    tag_t    tag;
  } waiting_t;

  function automatic magnitude_t magnitude(span_t v);
    return magnitude_t'((v < 0) ? -v : v);
  endfunction
  function automatic place_t place_of_top(magnitude_t m);
    place_of_top = '0;
    for (int unsigned i = 0; i < SpanW; i++) if (m[i]) place_of_top = place_t'(i);
  endfunction
  function automatic small_t scaled(span_t v, place_t top);
    logic signed [SpanW:0] wide;
    wide = (SpanW+1)'(v) <<< (place_t'(SpanW - 1) - top);
    return wide[SpanW -: SmallW];
  endfunction
  function automatic square_t square_of(small_t v);
    logic signed [SquareW-1:0] product;
    product = v * v;
    return product;
  endfunction

  // ---- s1 to s5: the squared length of the scaled vector ----
  logic [4:0]  load;
  logic        square_valid, square_ready;
  span_t       x1_q, y1_q, z1_q, x2_q, y2_q, z2_q;
  magnitude_t  spread_q;
  place_t      top_q;
  small_t      x3_q, y3_q, z3_q;
  tag_t        tag1_q, tag2_q, tag3_q;
  square_t     xx_q, yy_q, zz_q, square_q;

  pipe_chain #(.Stages(5)) u_front (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(square_valid), .ready_i(square_ready),
    .load_o(load)
  );

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      x1_q     <= in_x_i;
      y1_q     <= in_y_i;
      z1_q     <= in_z_i;
      spread_q <= magnitude(in_x_i) | magnitude(in_y_i) | magnitude(in_z_i);
      tag1_q   <= in_tag_i;
    end
    if (load[1]) begin
      x2_q   <= x1_q;
      y2_q   <= y1_q;
      z2_q   <= z1_q;
      top_q  <= place_of_top(spread_q);
      tag2_q <= tag1_q;
    end
    if (load[2]) begin
      x3_q   <= scaled(x2_q, top_q);
      y3_q   <= scaled(y2_q, top_q);
      z3_q   <= scaled(z2_q, top_q);
      tag3_q <= tag2_q;
    end
    if (load[3]) begin
      xx_q <= square_of(x3_q);
      yy_q <= square_of(y3_q);
      zz_q <= square_of(z3_q);
    end
    if (load[4]) square_q <= xx_q + yy_q + zz_q;
  end

  // ---- Its root, and the root's inverse ----
  logic        odd, root_valid, root_ready, root_odd, inverse_valid, inverse_ready, inverse_odd;
  logic [RootRadW-1:0] rad;
  root_t       root;
  inverse_t    inverse;
  assign odd = square_q[SquareW-1 -: 2] != '0;
  assign rad = odd ? square_q[SquareW-1 -: RootRadW] : square_q[SquareW-3 -: RootRadW];

  cordic_sqrt #(.tag_t(logic)) u_root (
    .clk_i, .rst_ni,
    .in_valid_i(square_valid), .in_ready_o(square_ready), .in_rad_i(rad), .in_tag_i(odd),
    .out_valid_o(root_valid), .out_ready_i(root_ready), .out_root_o(root), .out_tag_o(root_odd)
  );
  div_pipe #(.NumW(RootW), .QFrac(InverseFrac), .tag_t(logic)) u_inverse (
    .clk_i, .rst_ni,
    .in_valid_i(root_valid), .in_ready_o(root_ready), .in_num_i(root_t'(1 << InverseFrac)), .in_den_i(root),
    .in_tag_i(root_odd),
    .out_valid_o(inverse_valid), .out_ready_i(inverse_ready), .out_q_o(inverse),
    .out_tag_o(inverse_odd)
  );

  // ---- The scaled vector waits here ----
  waiting_t waiting;
  logic     queue_ready;
  stream_fifo #(.data_t(waiting_t), .Depth(QueueDepth)) u_waiting (
    .clk_i, .rst_ni,
    .valid_i(load[3]), .ready_o(queue_ready), .data_i('{v: '{x: x3_q, y: y3_q, z: z3_q}, tag: tag3_q}),
    .valid_o(), .ready_i(inverse_valid && inverse_ready), .data_o(waiting), .used_o()
  );

  // ---- s6 to s8 ----
  function automatic product_t times(small_t v, inverse_t r);
    logic signed [InverseFrac+1:0] factor;
    factor = {1'b0, r};
    return v * factor;
  endfunction
  function automatic unit_t rounded(product_t p, logic by_two);   // and halved
    return by_two ? unit_t'((p + product_t'(1 << InverseFrac)) >>> (InverseFrac + 1))
                  : unit_t'((p + product_t'(1 << (InverseFrac - 1))) >>> InverseFrac);
  endfunction

  logic [2:0]         back_load;
  small_t             x6_q, y6_q, z6_q;
  inverse_t           inverse_q;
  logic               odd6_q, odd7_q;
  product_t           px_q, py_q, pz_q;
  tag_t               tag6_q, tag7_q;

  pipe_chain #(.Stages(3)) u_back (
    .clk_i, .rst_ni,
    .valid_i(inverse_valid), .ready_o(inverse_ready),
    .valid_o(out_valid_o), .ready_i(out_ready_i),
    .load_o(back_load)
  );

  always_ff @(posedge clk_i) begin
    if (back_load[0]) begin
      x6_q      <= waiting.v.x;
      y6_q      <= waiting.v.y;
      z6_q      <= waiting.v.z;
      tag6_q    <= waiting.tag;
      inverse_q <= inverse;
      odd6_q    <= inverse_odd;
    end
    if (back_load[1]) begin
      px_q   <= times(x6_q, inverse_q);
      py_q   <= times(y6_q, inverse_q);
      pz_q   <= times(z6_q, inverse_q);
      odd7_q <= odd6_q;
      tag7_q <= tag6_q;
    end
    if (back_load[2]) begin
      out_o.x   <= rounded(px_q, odd7_q);
      out_o.y   <= rounded(py_q, odd7_q);
      out_o.z   <= rounded(pz_q, odd7_q);
      out_tag_o <= tag7_q;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && load[3]) assert (queue_ready) else $error("a vector has no place in the queue beside its root");
  end
`endif
endmodule
