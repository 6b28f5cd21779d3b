#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Illegal parameters of the core fail at elaboration, with a sentence for each; the ends of what is legal do not.
set -euo pipefail
cd "$(dirname "$0")/../.."
log=build/log/parameters.lint
mkdir -p "$(dirname $log)"
mapfile -t files < <(grep -v '^//' rtl/castray.f)

elaborate() { # parameters
  verilator --lint-only -Wno-lint --top-module castray_core "${@/#/-G}" "${files[@]}" > $log 2>&1
}
refuse() { # parameters, all of them illegal; with one lane where they do not say, which elaborates fastest
  if elaborate Lanes=1 "$@"; then echo "$* was not refused"; exit 1; fi
  for parameter in "$@"; do
    grep -q "castray_core: ${parameter%=*} is ${parameter#*=}, it must be" $log || { echo "$parameter was refused otherwise:"; cat $log; exit 1; }
  done
}
refuse Lanes=0
refuse Lanes=9 TileLog2=1
refuse Contexts=0 AttrEntries=2 Ports=0
refuse Contexts=65 TileLog2=5 AttrEntries=96 Ports=3 L2Kbytes=96
elaborate Lanes=1 Contexts=64 TileLog2=4 AttrEntries=4 Ports=1 L2Kbytes=1
echo "parameters: illegal ones are refused with a sentence, legal ones are not"
