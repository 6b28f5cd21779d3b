// SPDX-License-Identifier: Apache-2.0
// Writes the record of each ray, hit or miss, to the hit buffer:
//   32 bytes at base + 32 (y width + x);  a miss: t = TMax, u = v = 0, numbers NoHit;
//   a hit of a ray that asked for any: t = u = v = 0, number AnyHit;
//   and the ray's nodes and tests where want_work_i asks for them
//   s0  row = y width        12x13, one DSP
//   s1  index = row + x
//   s2  address
// The largest width makes of a ray of a list the pixel that its number stands for.
// One record a cycle, in order, latency 3. base_i (a multiple of 32), width_i and want_work_i
// stand still.
// Model: cpp_model/mem/hit_writer.hpp, equal bit for bit.
module hit_writer
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic        clk_i,
  input  logic        rst_ni,

  input  addr_t       base_i,
  input  extent_t     width_i,
  input  logic        want_work_i,   // else the records say zero of it

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  cast_t       in_i,

  output logic        out_valid_o,
  input  logic        out_ready_i,
  output write_req_t  out_o,

  output logic        idle_o     // no record inside
);
  localparam int unsigned Stages = 3;
  typedef logic [2*PixelW-1:0] index_t;    // of a pixel of the largest frame

  // What a record holds of a hit.
  typedef struct packed {
    work_t work;
    logic  found;
    logic  any_hit;
    prim_t number;
    t_t    t;
    bary_t u;
    bary_t v;
  } kept_t;

  function automatic index_t row_start(pixel_t y, extent_t width);
    return index_t'(y) * index_t'(width);
  endfunction
  function automatic addr_t place(addr_t base, index_t index);
    return base + (addr_t'(index) << $clog2(HitBytes));
  endfunction
  function automatic hit_record_t record_of(kept_t hit);
    logic signed [31:0] t;
    logic               whole;   // where it was hit is told
    t     = 32'(hit.t);
    whole = hit.found && !hit.any_hit;
    return '{
      reserved:    '0,
      tests:       32'(hit.work.tests),
      nodes:       32'(hit.work.nodes),
      instance_id: hit.found ? '0 : NoHit,
      prim:        whole ? 32'(hit.number) : hit.found ? AnyHit : NoHit,
      v:           whole ? 32'(hit.v) : '0,
      u:           whole ? 32'(hit.u) : '0,
      t:           whole ? t : hit.found ? '0 : 32'(TMax)
    };
  endfunction

  logic [Stages-1:0] load;
  pipe_chain #(.Stages(Stages)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .load_o(load)
  );

  credit #(.Limit(Stages)) u_inside (
    .clk_i, .rst_ni,
    .take_i(in_valid_i && in_ready_o), .give_i(out_valid_o && out_ready_i), .available_o(), .idle_o
  );

  hit_t hit;
  assign hit = in_i.hit;

  index_t row_q, index_q;
  pixel_t x_q;
  addr_t  addr_q;
  kept_t  kept_q [Stages];
  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      row_q     <= row_start(hit.tag.y, width_i);
      x_q       <= hit.tag.x;
      kept_q[0] <= '{work: want_work_i ? in_i.work : '0, found: hit.found, any_hit: hit.any_hit, number: hit.number,
                     t: hit.t, u: hit.u, v: hit.v};
    end
    if (load[1]) index_q <= row_q + index_t'(x_q);
    if (load[2]) addr_q <= place(base_i, index_q);
    for (int unsigned i = 1; i < Stages; i++) if (load[i]) kept_q[i] <= kept_q[i-1];
  end

  assign out_o = '{
    addr:  addr_q,
    beats: 3'(HitBytes / StrbW),
    strb:  64'({HitBytes{1'b1}}),
    data:  512'(record_of(kept_q[Stages-1]))
  };
endmodule
