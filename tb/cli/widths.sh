#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The widths of rtl/pkg/castray_cfg_pkg.sv are parameters: in a copy of the sources with narrower ones
# the whole core is clean under lint, the units of the lane equal their models, and widths that are
# not possible are refused with a sentence. With --core a core of one lane is built too, and frames
# compared with the model: some minutes.
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
set_width SubPlane 5

# What is not possible: a sentence, and no result.
refuse() { # name, value, the legal value, words of the sentence
  set_width "$1" "$2"
  if make -s build/lint/isect/ray_prim.ok > refused.log 2>&1; then echo "$1 = $2 was not refused"; exit 1; fi
  grep -q "$1 is $2, it must be $4" refused.log || { echo "$1 = $2 was refused otherwise:"; cat refused.log; exit 1; }
  set_width "$1" "$3"
}
refuse CoordW 30 22 "20 to 26"
refuse ShearFrac 27 20 "16 to 26"
refuse HitDivW 16 19 "BaryFrac + 2 to 26"
refuse TFrac 1 2 "2 to 4"
refuse SubPlane 7 5 "2 to 6"

make -s build/lint/castray_core.ok
equal_their_models() { # units; cycles are counted at the usual widths
  make -s $(printf 'build/unit/%s_test ' "$@")
  for unit in "$@"; do
    "build/unit/${unit}_test" --gtest_brief=1 --gtest_filter=-*.TakesTheseCycles > unit.log || { cat unit.log; exit 1; }
  done
}
equal_their_models traverse/lane isect/ray_prim isect/hit_unit isect/node_pipe camera/slab_setup

if [[ ${1:-} == --core ]]; then
  equal_their_models traverse/lane_tree
  make -s build/castray build/cores/l1c32t3p1m0.so
  for scene in cube spheres; do
    for mode in bvh brute; do
      build/castray render "scenes/$scene.json" --mode $mode --lanes 1 --ports 1 --l2 0 --size 48x32 --check -o picture.png
    done
  done
fi
echo "widths: narrower ones work, impossible ones are refused"
