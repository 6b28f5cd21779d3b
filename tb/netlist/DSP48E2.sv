// SPDX-License-Identifier: Apache-2.0
// The DSP48E2 as far as synthesis uses it here: a signed multiplier, 27 x 18 bits, without any of its
// registers. Everything else stops: another parameter at elaboration, another mode when it is seen.
module DSP48E2 #(
  parameter int ACASCREG = 0, ADREG = 0, ALUMODEREG = 0, AREG = 0, BCASCREG = 0, BREG = 0, CARRYINREG = 0,
                CARRYINSELREG = 0, CREG = 0, DREG = 0, INMODEREG = 0, MREG = 0, OPMODEREG = 0, PREG = 0,
  parameter     A_INPUT = "DIRECT", B_INPUT = "DIRECT", USE_MULT = "MULTIPLY", USE_SIMD = "ONE48",
                AMULTSEL = "A", BMULTSEL = "B"
) (
  input  logic [29:0] A,
  input  logic [17:0] B,
  input  logic [47:0] C,
  input  logic [26:0] D,
  input  logic [29:0] ACIN,
  input  logic [17:0] BCIN,
  input  logic [47:0] PCIN,
  input  logic        CARRYIN,
  input  logic [2:0]  CARRYINSEL,
  input  logic [4:0]  INMODE,
  input  logic [3:0]  ALUMODE,
  input  logic [8:0]  OPMODE,
  output logic [47:0] P
);
  if (ACASCREG + ADREG + ALUMODEREG + AREG + BCASCREG + BREG + CARRYINREG + CARRYINSELREG + CREG + DREG + INMODEREG
      + MREG + OPMODEREG + PREG != 0) begin : g_registers
    $error("DSP48E2: its registers are not modelled");
  end
  if (A_INPUT != "DIRECT" || B_INPUT != "DIRECT" || USE_MULT != "MULTIPLY" || USE_SIMD != "ONE48" || AMULTSEL != "A"
      || BMULTSEL != "B") begin : g_paths
    $error("DSP48E2: only the product of A and B is modelled");
  end
  always_comb begin
    if (OPMODE != 9'b000000101 || ALUMODE != '0 || INMODE != '0 || CARRYINSEL != '0 || CARRYIN || C != '0 || D != '0
        || ACIN != '0 || BCIN != '0 || PCIN != '0) begin
      $fatal(1, "DSP48E2: a mode that is not modelled, OPMODE %b", OPMODE);
    end
  end
  logic signed [26:0] a;
  logic signed [17:0] b;
  assign a = A[26:0];
  assign b = B;
  assign P = 48'(a * b);

  logic unused_a;   // A's upper bits pass the multiplier by
  assign unused_a = ^A[29:27];
endmodule
