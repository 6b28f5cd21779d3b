#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The core in someone else's hands: castray.core under FuseSoC, a design that depends on it, and the same design from the list of
# files alone. And the scripts for Vivado are clean under tclint.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tb/common/cases.sh
make -s build/venv/board/ok build/castray
venv=build/venv/board/bin
touch build/FUSESOC_IGNORE

fusesoc() { # target, core, options...
  local target=$1 core=$2
  shift 2
  # Built to run once, with the compiler that the rest is built with, as one file: most of the time goes into headers.
  env -u MAKELEVEL MAKEFLAGS="CXX=clang++ LINK=clang++ VM_PARALLEL_BUILDS=0 OPT_FAST=-O0 OPT_SLOW=-O0 OPT_GLOBAL=-O0" \
    $venv/fusesoc --cores-root . run --build-root "build/fpga/fusesoc/${core//:/_}" --target="$target" "$core" "$@"
}
simulates() {
  local said
  said=$(fusesoc sim "$1" 2>&1) || { tail -n 20 <<< "$said"; return 1; }
  grep -q "^bench: passed" <<< "$said"
}

case_of CastrayCore.ListsTheFilesOfTheOneList python3 tools/fusesoc_core.py --check
lists_nothing_else() {
  local copy
  copy=$(mktemp -d)
  cp -r --parents castray.core rtl tools/fusesoc_core.py "$copy"
  (cd "$copy" && sed -i '/rtl.mem.line_tags.sv/d' castray.core && ! python3 tools/fusesoc_core.py --check)
  rm -rf "$copy"
}
case_of CastrayCore.IsRefusedWithAFileLess lists_nothing_else
case_of CastrayCore.Lints fusesoc lint castray
case_of CastrayCore.Simulates simulates castray

case_of Dependent.HasThePictureOfTheModel python3 tb/fpga/dependent/data.py --check
case_of Dependent.RendersThePicture simulates castray:examples:still
from_the_list() {
  verilator --lint-only -Wall -Wno-PINCONNECTEMPTY -fno-const-bit-op-tree tools/waivers.vlt -f rtl/castray.f fpga/ultra96/castray_top.v \
    tb/fpga/bench/lite_master.sv tb/fpga/dependent/chip_memory.sv tb/fpga/dependent/still.sv --top-module still
}
case_of Dependent.LintsFromTheListOfFiles from_the_list

case_of Scripts.AreCleanUnderTclint $venv/tclint -c tb/fpga/tclint.toml fpga tb/fpga
ends
