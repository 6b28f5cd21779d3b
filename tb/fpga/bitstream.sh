#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `make bitstream` from end to end, with a stand-in in Vivado's place (tb/fpga/vivado), and what it says where it cannot build.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tb/common/cases.sh
make -s build/fpga/top.facts build/ultra96/registers.tcl build/venv/python/ok
out=$PWD/build/fpga/out
rm -rf "$out"
export CASTRAY_FACTS=$PWD/build/fpga/top.facts

bitstream() { env PATH="$PWD/tb/fpga/vivado:$PATH" make -s bitstream BOARD_OUT="$out" "$@" 2>&1; }
without_vivado() { make -s bitstream BOARD_OUT="$out" 2>&1; }
# The same without the make around it, which takes most of the time.
script() { # name=value...
  env PATH="$PWD/tb/fpga/vivado:$PATH" fpga/ultra96/bitstream.sh board=ultra96v2 out="$out" registers="$PWD/build/ultra96/registers.tcl" \
    clock_mhz=100 lanes=3 contexts=32 tile_log2=3 ports=2 l2_kbytes=128 jobs=1 board_files= "$@" 2>&1
}
refuses() { # words of the message, command...
  local words=$1 said
  shift
  if said=$("$@"); then echo "it did not fail: $said"; return 1; fi
  grep -q -- "$words" <<< "$said" || { echo "it said otherwise: $said"; return 1; }
  [[ $(grep -vc '^make' <<< "$said") -eq 1 ]] || { echo "more than a line: $said"; return 1; }
}
holds() { grep -q -- "$2" "$1" || { echo "$1 has no line '$2':"; cat "$1"; return 1; }; }
lacks() { ! grep -q -- "$2" "$1" || { echo "$1 has a line '$2'"; return 1; }; }

whole_flow() { # board, ports
  bitstream BOARD="$1" PORTS="$2"
  for kind in bit hwh utilization.txt timing.txt; do [[ -f $out/castray_$1.$kind ]]; done
  [[ -z $(find "$out" -name '*.sv' -o -name castray_top.v) ]]
  holds "$out/castray_$1.hwh" "INSTANCE=\"castray\".*VLNV=\"$(cat fpga/ultra96/vlnv.txt)\""
  holds "$out/castray_$1.hwh" "castray/m_axi_0 sees ps/SAXIGP3/HP1_DDR_LOW at 0x0"
  if (($2 == 2)); then local second=holds; else local second=lacks; fi
  $second "$out/castray_$1.hwh" "castray/m_axi_1 sees ps/SAXIGP4/HP2_DDR_LOW at 0x0"
}
for board in ultra96v1 ultra96v2; do
  for ports in 1 2; do case_of "Bitstream.${board}With${ports}Ports" whole_flow $board $ports; done
done

bare_packager() { FAKE_BARE_PACKAGER=1 script; }
case_of Bitstream.MakesMapsAndSpacesWhereThePackagerDoesNot bare_packager

missed_timing() {
  FAKE_WNS=0.3 FAKE_WHS=-0.05 refuses "timing failed at 125 MHz: the worst slack of hold is -0.05" script clock_mhz=125
  FAKE_WNS=-0.3 refuses "timing failed at 100 MHz: the worst slack of setup is -0.3" script
  FAKE_WNS="" refuses "timing failed" script
  [[ ! -e $out/castray_ultra96v2.bit && ! -e $out/castray_ultra96v2.hwh && -e $out/castray_ultra96v2.timing.txt ]]
}
case_of Bitstream.FailsWhereTimingFails missed_timing

board_files() {
  FAKE_BOARDS="avnet.com:zedboard:part0:1.4" refuses "no board files for ultra96v2.*github.com/Avnet/bdf" script
  refuses "BOARD_FILES=/no/such is no folder" script board_files=/no/such
  script board_files=docs
  FAKE_BOARDS="em.avnet.com:ultra96v1:part0:1.2" script board=ultra96v1
}
case_of Bitstream.SaysHowToAddBoardFiles board_files

no_vivado() { refuses "Vivado is not installed.*supported are Vivado 2022.1 to 2024.2" without_vivado; }
case_of Bitstream.SaysWhichVivadoItWants no_vivado
versions() {
  FAKE_VERSION=2021.2 refuses "this is Vivado 2021.2; supported are 2022.1 to 2024.2" script
  FAKE_VERSION=2024.2.1 script
  FAKE_VERSION=2025.1 script
}
case_of Bitstream.RefusesAnOldVivado versions

bad_arguments() {
  refuses "BOARD=zcu104 is not known; there are: ultra96v1 ultra96v2" bitstream BOARD=zcu104
  refuses "BOARD= is not known" script board=
  refuses "PORTS=3: it must be 1 to 2" script ports=3
  refuses "LANES=9: it must be 1 to 8" script lanes=9
  refuses "LANES=two: it must be 1 to 8" script lanes=two
  refuses "CONTEXTS=0: it must be 1 to 64" script contexts=0
  refuses "CLOCK_MHZ=0: it must be 1 to 400" script clock_mhz=0
}
case_of Bitstream.RefusesWhatItDoesNotKnow bad_arguments

# PYNQ's own reader takes the registers, the address, the interrupt and the name that the driver binds to from the handoff.
register_map() { build/venv/python/bin/python tb/fpga/register_map.py "$out/castray_ultra96v2.hwh" build/ultra96/registers.tcl; }
case_of Bitstream.GivesPynqARegisterMap register_map

# The wrapper's defaults are those of the package, which Verilog cannot read.
defaults() {
  while read -r _ name value; do
    grep -q "unsigned Default$name *= $value;" rtl/pkg/castray_cfg_pkg.sv || { echo "castray_top: $name = $value"; return 1; }
  done < <(grep '^parameter' "$CASTRAY_FACTS")
  [[ $(grep -c '^parameter' "$CASTRAY_FACTS") -eq $(grep -c '^  parameter int unsigned' rtl/castray_core.sv) ]]
}
case_of CastrayTop.HasTheDefaultsOfThePackage defaults
ends
