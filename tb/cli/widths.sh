#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The widths of rtl/pkg/castray_cfg_pkg.sv are parameters: in a copy of the sources with narrower ones
# the units of the lane equal their models, the core renders what the model renders, and a width
# that is not possible is refused with a sentence.
set -euo pipefail
cd "$(dirname "$0")/../.."
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
tar -c --exclude=./build --exclude=./.git . | tar -x -C "$copy"
cd "$copy"
config=rtl/pkg/castray_cfg_pkg.sv

set_width() { # name, value
  grep -q "unsigned $1 = [0-9]*;" $config || { echo "$config has no width $1"; exit 1; }
  sed -i "s/unsigned $1 = [0-9]*;/unsigned $1 = $2;/" $config
}

set_width CoordW 22
set_width ShearFrac 20
set_width BaryFrac 15
set_width TFrac 2
set_width HitDivW 19
set_width ShearDivW 24

# What is not possible: the sentence, and no other outcome.
refuse() { # name, value, legal value, words of the sentence
  set_width "$1" "$2"
  ! make lint-one > refused.log 2>&1 || { echo "$1 = $2 was not refused"; exit 1; }
  grep -q "$1 is $2, it must be $4" refused.log || { echo "$1 = $2 was refused otherwise:"; cat refused.log; exit 1; }
  set_width "$1" "$3"
}
