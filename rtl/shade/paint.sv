// SPDX-License-Identifier: Apache-2.0
// Texture times facing ratio, as a pixel.
//   facing = |n . d|, at most one                        Q1.16
//   column = floor(s scale), row = floor(t scale)        odd sum: colour b, even: colour a
//   colour = c facing, round half up
// s and t of a sphere are its unit normal's x and y, from -1..1 to 0..1. Materials a and b force
// their colour; every other number is the checker.
//   s0    texture coordinates; of column and row only the lowest bit counts, so 25 bits of s do
//   s1    s scale, t scale             27x18, the scale as a signed number
//   s2    its lowest bit, what scale's top bit lost added back; which colour
//   s0..4 n . d + 1/2                  (dot3)
//   s5    floor, magnitude
//   s6    at most one; the colour
//   s7    c facing                     8x17
//   s8    round
// 8 DSPs. One a cycle, in order, latency 9. paint_i stands still while a frame is rendered.
// Model: cpp_model/shade/paint.hpp, equal bit for bit.
module paint
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  paint_t     paint_i,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  paint_req_t in_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output shaded_t    out_o
);
  localparam int unsigned Stages = 9;
  localparam int unsigned ScaleW = $bits(checker_t);
  localparam int unsigned CellAt = UnitFrac + CheckerFrac;      // a product's bit of weight one
  localparam int unsigned UnitW  = $bits(unit_t);

  typedef logic signed [CellAt:0]         column_t;    // a coordinate, as far as it counts
  typedef logic signed [UnitW*2+1:0]      dot_t;
  typedef logic [UnitFrac:0]              facing_t;    // Q1.16
  typedef logic [UnitW*2+1-UnitFrac:0]    mag_t;
  typedef logic [UnitFrac+8:0]            product_t;

  logic [Stages-1:0] load;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .load_o(load)
  );

  // ---- The checker ----
  function automatic column_t sphere_tex(unit_t n);
    logic signed [UnitW:0] shifted;
    shifted = ((UnitW+1)'(n) + (UnitW+1)'(1 << UnitFrac)) >>> 1;
    return column_t'(shifted);
  endfunction
  function automatic column_t mul_scale(column_t s, logic signed [ScaleW-1:0] scale);
    return s * column_t'(scale);
  endfunction
  // The bit of weight one; a scale whose top bit is set was taken for scale - 2^ScaleW.
  function automatic logic odd(column_t product, logic [CellAt-ScaleW:0] s_low, logic top);
    logic [CellAt-ScaleW:0] high;
    high = product[CellAt:ScaleW] + (top ? s_low : '0);
    return high[CellAt-ScaleW];
  endfunction
  function automatic logic use_b(logic [7:0] material, logic odd_s, logic odd_t);
    unique case (material)
      MaterialA: return 1'b0;
      MaterialB: return 1'b1;
      default:   return odd_s != odd_t;
    endcase
  endfunction

  column_t                s_q, t_q, s_product_q, t_product_q;
  logic [CellAt-ScaleW:0] s_low_q, t_low_q;
  logic                   sphere;
  assign sphere = in_i.kind == KindSphere;
  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      s_q <= sphere ? sphere_tex(in_i.normal.x) : column_t'(in_i.s);
      t_q <= sphere ? sphere_tex(in_i.normal.y) : column_t'(in_i.t);
    end
    if (load[1]) begin
      s_product_q <= mul_scale(s_q, paint_i.checker_scale);
      t_product_q <= mul_scale(t_q, paint_i.checker_scale);
      s_low_q     <= s_q[CellAt-ScaleW:0];
      t_low_q     <= t_q[CellAt-ScaleW:0];
    end
  end

  // ---- What goes along ----
  pixel_tag_t tag_q [Stages];
  logic [7:0] material_q [2];
  logic       use_b_q [2:5];
  always_ff @(posedge clk_i) begin
    if (load[0]) tag_q[0] <= in_i.tag;
    for (int unsigned i = 1; i < Stages; i++) if (load[i]) tag_q[i] <= tag_q[i-1];
    if (load[0]) material_q[0] <= in_i.material;
    if (load[1]) material_q[1] <= material_q[0];
    if (load[2]) begin
      use_b_q[2] <= use_b(material_q[1], odd(s_product_q, s_low_q, paint_i.checker_scale[ScaleW-1]),
                          odd(t_product_q, t_low_q, paint_i.checker_scale[ScaleW-1]));
    end
    for (int unsigned i = 3; i < 6; i++) if (load[i]) use_b_q[i] <= use_b_q[i-1];
  end

  // ---- Facing ----
  function automatic mag_t magnitude(dot_t dot);
    logic signed [UnitW*2+1-UnitFrac:0] x;
    x = dot[UnitW*2+1:UnitFrac];
    return x < 0 ? mag_t'(-x) : mag_t'(x);
  endfunction
  function automatic facing_t at_most_one(mag_t mag);
    return mag > mag_t'(1 << UnitFrac) ? facing_t'(1 << UnitFrac) : facing_t'(mag);
  endfunction

  dot_t    dot;
  mag_t    mag_q;
  facing_t facing_q;
  dot3 #(.AW(UnitW), .BW(UnitW), .Round(1 << (UnitFrac - 1))) u_dot (
    .clk_i, .load_i(load[4:0]),
    .a0_i(in_i.normal.x), .b0_i(in_i.view.x),
    .a1_i(in_i.normal.y), .b1_i(in_i.view.y),
    .a2_i(in_i.normal.z), .b2_i(in_i.view.z),
    .p_o(dot)
  );

  // ---- Colour ----
  function automatic product_t dim(logic [7:0] c, facing_t facing);
    return product_t'(c) * product_t'(facing);
  endfunction
  function automatic logic [7:0] round_colour(product_t x);
    return 8'((x + product_t'(1 << (UnitFrac - 1))) >> UnitFrac);
  endfunction

  rgb_t     full_q, colour_q;
  product_t r_q, g_q, b_q;
  always_ff @(posedge clk_i) begin
    if (load[5]) mag_q <= magnitude(dot);
    if (load[6]) begin
      facing_q <= at_most_one(mag_q);
      full_q   <= use_b_q[5] ? paint_i.colour_b : paint_i.colour_a;
    end
    if (load[7]) begin
      r_q <= dim(full_q.r, facing_q);
      g_q <= dim(full_q.g, facing_q);
      b_q <= dim(full_q.b, facing_q);
    end
    if (load[8]) colour_q <= '{r: round_colour(r_q), g: round_colour(g_q), b: round_colour(b_q)};
  end

  logic [31:0] word;
  pixel_word u_word (.colour_i(colour_q), .swap_rb_i(paint_i.swap_rb), .word_o(word));
  assign out_o = '{tag: tag_q[Stages-1], colour: word};
endmodule
