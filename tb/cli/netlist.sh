#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The models of the device's cells stop on what they do not model: a register of a DSP, a width or an output register of a
# block RAM at elaboration, an operation of a DSP when it is seen.
set -euo pipefail
work=build/netlist/models
rm -rf $work
mkdir -p $work

# stops(cell, flags, what it says)
stops() {
  if verilator --lint-only -Wno-lint --top-module "$1" $2 tb/netlist/*.sv > $work/log 2>&1; then
    echo "$1 $2 was not refused"
    exit 1
  fi
  grep -q "$3" $work/log || { cat $work/log; exit 1; }
}
ram="-GWRITE_MODE_A=\"READ_FIRST\" -GWRITE_MODE_B=\"READ_FIRST\" -GDOA_REG=0 -GDOB_REG=0"
verilator --lint-only -Wno-lint --top-module DSP48E2 tb/netlist/*.sv
verilator --lint-only -Wno-lint --top-module RAMB18E2 $ram -GREAD_WIDTH_A=36 -GWRITE_WIDTH_B=36 tb/netlist/*.sv
stops DSP48E2 -GPREG=1 "registers are not modelled"
stops DSP48E2 -GUSE_SIMD=\"TWO24\" "only the product"
stops RAMB18E2 "$ram -GREAD_WIDTH_B=4 -GWRITE_WIDTH_A=4" "are not modelled"
stops RAMB36E2 "$ram -GREAD_WIDTH_B=36 -GWRITE_WIDTH_A=18" "are not modelled"
stops RAMB36E2 "-GREAD_WIDTH_A=72 -GWRITE_WIDTH_B=72" "only read-first"
stops RAMB36E2 "$ram -GREAD_WIDTH_A=72 -GWRITE_WIDTH_B=72 -GINIT_00=1" "INIT_00"

cat > $work/main.cpp <<'CPP'
#include "VDSP48E2.h"
int main(int, char** arguments) {
  VDSP48E2 dsp;
  dsp.OPMODE = arguments[1] ? 0b000110101 : 0b000000101;   // with an argument: C is added
  dsp.A = 3;
  dsp.B = 0x3ffff;
  dsp.eval();
  return dsp.P == 0xfffffffffffd ? 0 : 1;
}
CPP
verilator --cc --exe --build --assert -Wno-lint -Mdir $work/dsp --top-module DSP48E2 tb/netlist/DSP48E2.sv "$PWD/$work/main.cpp" > $work/log 2>&1 ||
  { cat $work/log; exit 1; }
$work/dsp/VDSP48E2 || { echo "a product is wrong"; exit 1; }
if $work/dsp/VDSP48E2 add > $work/log 2>&1; then
  echo "another mode was not noticed"
  exit 1
fi
grep -q "a mode that is not modelled" $work/log || { cat $work/log; exit 1; }
