// SPDX-License-Identifier: Apache-2.0
// The camera of a frame from its frame record: what one column, one row and the axis add to a
// ray's direction. Elements are Q2.30, pitch and focal Q0.44, steps Q2.42:
//   right[i] =  round(pitch * right_i)      round: add half, floor
//   up[i]    =  round(pitch * up_i)
//   ahead[i] = -round(focal * back_i)
// Three shift-and-add multipliers, one for each axis, take the vectors in turn: 45 cycles each.
// record_i is held from the start on to the end of the frame; eye and size pass through.
// done_o: a level from 136 cycles after start_i until the next start.
// Model: cpp_model/camera/frame_setup.hpp, equal bit for bit.
module frame_setup
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
(
  input  logic          clk_i,
  input  logic          rst_ni,

  input  logic          start_i,
  input  frame_record_t record_i,
  output logic          done_o,
  output camera_t       camera_o
);
  localparam int unsigned ElemW  = $bits(rot_t);
  localparam int unsigned AccW   = ElemW;
  localparam int unsigned StepW  = $bits(dir_step_t);
  localparam int unsigned Drop   = ScaleFrac + RotFrac - DirFrac; // fraction bits rounded away
  localparam int unsigned LowW   = ScaleFrac - Drop + 1;    // what is kept below the accumulator
  localparam int unsigned CntW   = $clog2(ScaleFrac);
  if (AccW + LowW != StepW + 1) begin : g_check
    $error("frame_setup: DirFrac must be 42");
  end

  // The vector under way: 1 right, 2 up, 3 ahead; 0 none.
  logic [1:0]        vector_q;
  logic [CntW-1:0]   count_q;
  logic              store_q, done_q;
  logic [ScaleFrac-1:0] scale_q;
  logic signed [ElemW-1:0] elem_q [3];
  logic signed [AccW-1:0]  acc_q [3];   // the product above the bits already shifted out
  logic [LowW-1:0]         low_q [3];
  dir_step3_t        right_q, up_q, ahead_q;

  // One bit of the scale: add the element where it is one, then shift right by one.
  function automatic logic [AccW+LowW-1:0] add_shift(
    logic signed [AccW-1:0] acc, logic [LowW-1:0] low, logic signed [ElemW-1:0] elem, logic take);
    logic signed [AccW:0] sum;
    sum = (AccW + 1)'(acc) + (take ? (AccW + 1)'(elem) : '0);
    return {sum, low[LowW-1:1]};
  endfunction

  // The only place precision is dropped: half of the last bit kept, and -round(x) = round-down(-x).
  function automatic dir_step_t round_step(logic [AccW+LowW-1:0] product, logic negate);
    logic signed [AccW+LowW-1:0] x;
    x = negate ? ~product : product;
    return dir_step_t'((x + 1) >>> 1);
  endfunction

  function automatic dir_step3_t round_step3(
    logic [AccW+LowW-1:0] x, logic [AccW+LowW-1:0] y, logic [AccW+LowW-1:0] z, logic negate);
    return '{x: round_step(x, negate), y: round_step(y, negate), z: round_step(z, negate)};
  endfunction

  logic load;   // begin a vector
  assign load = start_i || (store_q && vector_q != 2'd3);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      vector_q <= 2'd0;
      store_q  <= 1'b0;
      done_q   <= 1'b0;
    end else if (load) begin
      vector_q <= start_i ? 2'd1 : vector_q + 1'b1;
      count_q  <= '0;
      store_q  <= 1'b0;
      done_q   <= 1'b0;
    end else if (vector_q != 2'd0) begin
      count_q <= count_q + 1'b1;
      store_q <= count_q == CntW'(ScaleFrac - 1);
      if (store_q) begin
        vector_q <= 2'd0;
        done_q   <= 1'b1;
      end
    end
  end

  logic [1:0] next;
  assign next = start_i ? 2'd1 : vector_q + 1'b1;

  dir_step3_t rounded;
  assign rounded = store_q ? round_step3({acc_q[0], low_q[0]}, {acc_q[1], low_q[1]}, {acc_q[2], low_q[2]}, vector_q == 2'd3) : '0;

  always_ff @(posedge clk_i) begin
    if (load) begin
      scale_q <= (next == 2'd3) ? record_i.focal[ScaleFrac-1:0] : record_i.pitch[ScaleFrac-1:0];
      unique case (next)
        2'd1:    elem_q <= '{record_i.right_x, record_i.right_y, record_i.right_z};
        2'd2:    elem_q <= '{record_i.up_x, record_i.up_y, record_i.up_z};
        default: elem_q <= '{record_i.back_x, record_i.back_y, record_i.back_z};
      endcase
      for (int unsigned i = 0; i < 3; i++) acc_q[i] <= '0;
    end else if (vector_q != 2'd0) begin
      scale_q <= scale_q >> 1;
      for (int unsigned i = 0; i < 3; i++)
        {acc_q[i], low_q[i]} <= add_shift(acc_q[i], low_q[i], elem_q[i], scale_q[0]);
    end
    if (store_q) begin
      unique case (vector_q)
        2'd1:    right_q <= rounded;
        2'd2:    up_q    <= rounded;
        default: ahead_q <= rounded;
      endcase
    end
  end

  assign done_o   = done_q;
  assign camera_o = '{
    eye: '{x: coord_t'(record_i.eye_x[CoordW-1:0]), y: coord_t'(record_i.eye_y[CoordW-1:0]),
           z: coord_t'(record_i.eye_z[CoordW-1:0])},
    right: right_q, up: up_q, ahead: ahead_q,
    width: extent_t'(record_i.width), height: extent_t'(record_i.height)
  };

  logic unused_record;  // the paint is the shader's
  assign unused_record = ^record_i;
endmodule
