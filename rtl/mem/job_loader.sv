// SPDX-License-Identifier: Apache-2.0
// Reads the header and the frame record of the scene image, 256 bytes in one burst, and checks
// them; the first failure is the error, in the order of the steps below.
//   0  magic, version                                      ErrImage
//   1  parameters                                          ErrParameters
//   2  image_bytes fits the image's window                 ErrSection
//   3  lines, 4 attributes, 5 nodes: unused, or aligned,   ErrSection
//      behind the frame record and inside image_bytes
//   6  each primitive has attributes                       ErrSection
//      there are numbers for all primitives                ErrPrimitive
//   7  the root is nothing, a node or a leaf               ErrNode
//   8  a list: RayBytes * rays <= bytes of its window      ErrRayWindow
//              HitBytes * rays <= bytes of the hit buffer  ErrHitWindow
//      a frame: its record's size, stride, formats, ranges ErrFrameRecord
//   13 stride * height <= bytes of the frame buffer        ErrFrameWindow
//   14 width * height * HitBytes <= bytes of the hit       ErrHitWindow
//      buffer, if hits are wanted
// Of a list of rays nothing of a frame is checked.
// One step a cycle. The two products are made meanwhile, one bit of the height a cycle: exact.
// Latency: the memory's, and 17 cycles.
// Model: cpp_model/mem/image.hpp, check_records().
module job_loader
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic          clk_i,
  input  logic          rst_ni,

  input  logic          start_i,     // one cycle
  input  job_t          job_i,       // held from the start on
  output logic          done_o,      // level, until the next start: read and checked
  output error_t        error_o,     // with done_o; ErrNone: the image may be used
  output image_header_t header_o,
  output frame_record_t record_o,

  output logic          req_valid_o,
  input  logic          req_ready_i,
  output read_req_t     req_o,

  input  logic          rsp_valid_i,
  input  read_rsp_t     rsp_i
);
  localparam int unsigned HeaderBeats = HeaderBytes / StrbW;
  localparam int unsigned Beats       = HeaderBeats + FrameBytes / StrbW;
  if (Beats != 16 || $bits(image_header_t) != 8 * HeaderBytes || $bits(frame_record_t) != 8 * FrameBytes)
  begin : g_check
    $error("job_loader: header and frame record must be 128 bytes each, one burst together");
  end

  localparam int unsigned HeightW  = $bits(extent_t);
  localparam logic [3:0]  StepRow  = 4'(HeightW);      // both products are complete
  localparam logic [3:0]  StepLast = 4'(HeightW + 1);

  typedef enum logic [2:0] {Idle, Ask, Read, Check, Done} state_t;
  state_t        state_q;
  logic [3:0]    step_q;   // beat of the burst, then step of the checks
  image_header_t header_q;
  frame_record_t record_q;
  error_t        error_q;

  assign header_o    = header_q;
  assign record_o    = record_q;
  assign done_o      = state_q == Done;
  assign error_o     = error_q;
  assign req_valid_o = state_q == Ask;
  assign req_o       = '{addr: job_i.image, beats: BeatsW'(Beats)};

  // ---- The burst ----
  always_ff @(posedge clk_i) begin
    if (rsp_valid_i) begin
      if (step_q < 4'(HeaderBeats)) header_q[DataW*step_q[2:0] +: DataW] <= rsp_i.data;
      else record_q[DataW*step_q[2:0] +: DataW] <= rsp_i.data;
    end
  end

  // ---- The products, from the height's highest bit down ----
  logic [31+HeightW:0]        row_bytes_q;  // stride * height
  logic [2*HeightW-1:0]       pixels_q;     // width * height
  logic [HeightW-1:0]         height_q;     // the bits to come
  always_ff @(posedge clk_i) begin
    if (state_q == Read) begin
      row_bytes_q <= '0;
      pixels_q    <= '0;
      height_q    <= job_i.height;
    end else if (state_q == Check && step_q < StepRow) begin
      row_bytes_q <= (row_bytes_q << 1) + (height_q[HeightW-1] ? (32 + HeightW)'(record_q.stride) : '0);
      pixels_q    <= (pixels_q << 1) + (height_q[HeightW-1] ? (2 * HeightW)'(job_i.width) : '0);
      height_q    <= height_q << 1;
    end
  end

  // ---- The checks ----
  typedef logic [32+$clog2(AttrBytes):0] bytes_t;   // an offset of 32 bits and, behind it, 2^32 records
  function automatic logic section_bad(section_t section, int unsigned record_bytes);
    bytes_t finish;
    finish = bytes_t'(section.offset) + (bytes_t'(section.count) << $clog2(record_bytes));
    return section.count != '0 && (section.offset % ImageAlign != '0 || section.offset == '0 ||
                                   finish > bytes_t'(header_q.image_bytes));
  endfunction

  function automatic logic root_bad(logic [31:0] root);
    return root != '0 && (root[31:$bits(ref_t)] != '0 || !(root[$bits(ref_t)-1 -: 2] inside {RefNode, RefLeaf}));
  endfunction

  function automatic logic record_bad();
    return record_q.width != 16'(job_i.width) || record_q.height != 16'(job_i.height) ||
           record_q.stride % BufferAlign != '0 || record_q.stride < 32'(job_i.width) * PixelBytes ||
           record_q.pixel_format > PixelBgra8 ||
           (record_q.eye_x >> CoordW) != '0 ||
           (record_q.eye_y >> CoordW) != '0 ||
           (record_q.eye_z >> CoordW) != '0 ||
           (record_q.pitch >> ScaleFrac) != '0 || (record_q.focal >> ScaleFrac) != '0 ||
           (record_q.checker_scale >> $bits(checker_t)) != '0;
  endfunction

  function automatic error_t check_list();
    if (bytes_t'(job_i.ray_count) * RayBytes > bytes_t'(job_i.ray_bytes)) return ErrRayWindow;
    return (bytes_t'(job_i.ray_count) * HitBytes > bytes_t'(job_i.hits_bytes)) ? ErrHitWindow : ErrNone;
  endfunction

  function automatic error_t check_step(logic [3:0] step);
    unique case (step)
      4'd0: return (header_q.magic != ImageMagic || header_q.version != ImageVersion) ? ErrImage : ErrNone;
      4'd1: return (header_q.parameters != ImageParameters) ? ErrParameters : ErrNone;
      4'd2: return (header_q.image_bytes > job_i.image_bytes) ? ErrSection : ErrNone;
      4'd3: return section_bad(header_q.lines, LineBytes) ? ErrSection : ErrNone;
      4'd4: return section_bad(header_q.attributes, AttrBytes) ? ErrSection : ErrNone;
      4'd5: return section_bad(header_q.nodes, NodeBytes) ? ErrSection : ErrNone;
      4'd6: return (header_q.primitives > header_q.attributes.count) ? ErrSection :
                   (header_q.primitives > 32'(NoPrim)) ? ErrPrimitive : ErrNone;
      4'd7: return root_bad(header_q.root) ? ErrNode : ErrNone;
      4'd8: return job_i.is_list ? check_list() : record_bad() ? ErrFrameRecord : ErrNone;
      StepRow: return (!job_i.is_list && row_bytes_q > (32 + HeightW)'(job_i.frame_bytes)) ? ErrFrameWindow : ErrNone;
      StepLast: return (!job_i.is_list && job_i.want_hits && 32'(pixels_q) * HitBytes > job_i.hits_bytes) ?
                       ErrHitWindow : ErrNone;
      default: return ErrNone;
    endcase
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= Idle;
      step_q  <= '0;
      error_q <= ErrNone;
    end else begin
      unique case (state_q)
        Idle, Done: if (start_i) begin
          state_q <= Ask;
          step_q  <= '0;
          error_q <= ErrNone;
        end
        Ask: if (req_ready_i) state_q <= Read;
        Read: if (rsp_valid_i) begin
          step_q <= step_q + 1'b1;
          if (rsp_i.last) begin
            state_q <= Check;
            step_q  <= '0;
          end
        end
        Check: begin
          step_q <= step_q + 1'b1;
          if (error_q == ErrNone) error_q <= check_step(step_q);
          if (step_q == StepLast) state_q <= Done;
        end
        default: state_q <= Idle;
      endcase
    end
  end
endmodule
