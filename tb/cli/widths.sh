#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The widths of rtl/pkg/castray_cfg_pkg.sv are parameters: with narrower ones the whole core is clean
# under lint, the units of the lane equal their models, no box is dropped wrongly and the hierarchy finds
# what brute force finds; widths that are not possible are refused with a sentence. With --core a core of
# one lane is built too, and frames compared with the model: some minutes.
set -euo pipefail
cd "$(dirname "$0")/../.."
narrow="CoordW=22 ShearFrac=20 BaryFrac=15 TFrac=2 HitDivW=19 ShearDivW=24 SubPlane=5"
coarse="CoordW=25 ShearFrac=16 BaryFrac=12 TFrac=3 HitDivW=26 ShearDivW=28 SubPlane=4"   # large errors beside large boxes; odd

widths() { python3 tools/width/set_widths.py "build/width/$1" "${@:2}"; }
lint() { # folder under build/width, top: at its widths
  mapfile -t files < <(grep -v '^//' rtl/castray.f | sed "s,^rtl/pkg/castray_cfg_pkg.sv,build/width/$1/castray_cfg_pkg.sv,")
  verilator --lint-only -Wall -fno-const-bit-op-tree --top-module "$2" tools/waivers.vlt "${files[@]}"
}
# One make for each folder, for the reading of the makefiles takes longer than a lint; Verilator's own code is of no width.
runtime="build/obj/verilated-pic/verilated.o build/obj/verilated-pic/verilated_threads.o" headers="build/gen/verilated-O0.pch build/gen/verilated-O1.pch"
for object in $runtime $headers; do [[ -e $object ]] || make -s $object; done
at() { # folder, goals in it: made there
  local folder=build/width/$1
  make -s OPT=-O1 VERILATED_OBJ="$runtime" VERILATED_PCHS="$headers" BUILD="$folder" CONFIG="$folder/castray_cfg_pkg.sv" "${@:2}"
}
build() { at "$1" "${library[@]}" $(printf "build/width/$1/unit/%s_test " "${@:2}"); }   # folder, units
passes() { # folder, units: their tests pass; cycles are counted at the usual widths
  local folder=build/width/$1
  for unit in "${@:2}"; do
    "$folder/unit/${unit}_test" --gtest_brief=1 "--gtest_filter=${filter:--*.TakesTheseCycles}" > "$folder/unit.log" || { cat "$folder/unit.log"; exit 1; }
  done
}
# Of the library what makes images of scenes.
library=("LIB_SOURCES=$(echo cpp_model/{core,loaded,ray_list}.cpp cpp_model/scene/{binary_tree,bvh,camera,collapse,compile,frame,grid,scene_image}.cpp)")

# What is not possible: a sentence, and no result.
refuse() { # name, value, words of the sentence
  widths refused $narrow "$1=$2"
  if lint refused ray_prim > build/width/refused.log 2>&1; then echo "$1 = $2 was not refused"; exit 1; fi
  grep -q "$1 is $2, it must be $3" build/width/refused.log || { echo "$1 = $2 was refused otherwise:"; cat build/width/refused.log; exit 1; }
}
refuse CoordW 30 "20 to 26"
refuse ShearFrac 27 "16 to 26"
refuse HitDivW 16 "BaryFrac + 2 to 26"
refuse TFrac 1 "2 to 4"
refuse SubPlane 7 "2 to 6"

widths narrow $narrow
lint narrow castray_core
units=(traverse/lane isect/ray_prim isect/hit_unit isect/node_pipe camera/slab_setup isect/box_margin isect/node_culls)
build narrow "${units[@]}"
passes narrow "${units[@]}"
widths narrowest $narrow CoordW=20
lint narrowest node_order
widths coarse $coarse
units=(isect/box_margin isect/node_culls scene/random_hierarchy)
build coarse isect/hit_unit "${units[@]}"
filter="*MatchesModel*" passes coarse isect/hit_unit   # the distances that it names elsewhere are lost here
passes coarse "${units[@]}"

if [[ ${1:-} == --core ]]; then
  build narrow traverse/lane_tree scene/random_hierarchy
  passes narrow traverse/lane_tree scene/random_hierarchy
  library=()
  at narrow build/width/narrow/castray build/width/narrow/cores/l1c32t3p1m0.so
  for scene in cube spheres; do
    for mode in bvh brute; do
      build/width/narrow/castray render "scenes/$scene.json" --mode $mode --lanes 1 --ports 1 --l2 0 --size 48x32 --check -o build/width/narrow/picture.png
    done
  done
fi
echo "widths: narrower ones work, impossible ones are refused"
