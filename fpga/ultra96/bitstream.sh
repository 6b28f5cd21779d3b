#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bitstream.sh NAME=VALUE...: looks at what can be said before Vivado starts, then runs build.tcl. What was left by an earlier
# build of the board is removed first, so that a failed one leaves no bitstream.
set -euo pipefail
cd "$(dirname "$0")/../.."
declare -A asked
for argument in "$@"; do asked[${argument%%=*}]=${argument#*=}; done

stop() { echo "bitstream: $1" >&2; exit 1; }
whole() { # argument, lowest, highest
  local value=${asked[$1]}
  [[ $value =~ ^[0-9]+$ ]] && ((10#$value >= $2 && 10#$value <= $3)) || stop "${1^^}=$value: it must be $2 to $3"
}
constant() { sed -n "s/.*unsigned $1 *= \([0-9]*\);.*/\1/p" rtl/pkg/castray_pkg.sv rtl/pkg/castray_cfg_pkg.sv; }
version() { sed -n "s/^set $1 //p" fpga/ultra96/build.tcl; }

boards=$(sed -n 's/^  \([a-z0-9]*\) {part .*/\1/p' fpga/ultra96/settings.tcl | paste -sd ' ')
[[ " $boards " == *" ${asked[board]} "* ]] || stop "BOARD=${asked[board]} is not known; there are: $boards"
whole lanes 1 "$(constant MaxLanes)"
whole contexts 1 $((1 << $(constant CtxW)))
whole ports 1 2
whole clock_mhz 1 400
command -v vivado > /dev/null ||
  stop "Vivado is not installed, or its settings64.sh was not sourced; supported are Vivado $(version oldest) to $(version newest)"

out=${asked[out]}
rm -f "$out/castray_${asked[board]}".*
mkdir -p "$out/${asked[board]}"
vivado -mode batch -nojournal -log "$out/castray_${asked[board]}.log" -source fpga/ultra96/build.tcl -tclargs "root=$PWD" "$@"
