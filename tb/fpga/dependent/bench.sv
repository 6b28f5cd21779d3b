// SPDX-License-Identifier: Apache-2.0
// The still picture, beat for beat against the model's.
module bench (
  input  logic clk_i,
  input  logic rst_ni,
  output logic done_o,
  output logic failed_o
);
  localparam int unsigned Beats      = 2048;
  localparam int unsigned FrameAt    = 1024;
  localparam int unsigned FrameBeats = 48;      // 16 x 12 pixels of 4 bytes
  logic [127:0] expected [FrameBeats];
  initial $readmemh("frame.hex", expected);

  logic         ended, failed_q;
  logic [31:0]  error;
  logic [10:0]  beat_q;
  logic [127:0] got;

  still #(.Width(16), .Height(12), .Beats(Beats), .FrameAt(FrameAt), .Image("image.hex")) u_still (
    .clk_i, .rst_ni, .done_o(ended), .error_o(error), .look_i(11'(FrameAt) + beat_q), .look_o(got)
  );

  assign done_o   = beat_q == 11'(FrameBeats);
  assign failed_o = failed_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {beat_q, failed_q} <= '0;
    end else if (ended && !done_o) begin
      beat_q <= beat_q + 11'd1;
      if (error != '0 || got != expected[beat_q[5:0]]) begin
        $display("beat %0d is %h, expected %h; error code %0d", beat_q, got, expected[beat_q[5:0]], error);
        failed_q <= 1'b1;
      end
    end
  end
endmodule
