#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Programs beside castray. make_scene: what it writes castray renders; what it cannot write, or is not told, ends with
# castray's exit code, one line, and no file. make help: lists every target that has a comment.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tb/common/cases.sh

rendered() { # what make_scene is asked
  build/make_scene "$@" -o "$work/$1.json"
  build/castray render "$work/$1.json" --size 16x12 --engine model -o "$work/$1.png"
}
mesh_alone() {
  build/make_scene teapot --n 1 -o "$work/mesh.geo"
  [[ ! -e $work/mesh.json ]]
  build/castray render "$work/mesh.geo" --size 16x12 --engine model -o "$work/mesh.png"
}

refused() { # exit code, a word of the line, what make_scene is asked
  local code=0 before
  before=$(find "$work" | wc -l)
  build/make_scene "${@:3}" > "$work.out" 2> "$work.err" || code=$?
  [[ $code == "$1" ]] || { echo "exit code $code"; cat "$work.err"; return 1; }
  [[ $(wc -l < "$work.err") == 1 ]] && grep -q -- "$2" "$work.err" || { cat "$work.err"; return 1; }
  [[ $(find "$work" | wc -l) == "$before" ]]
  rm "$work.out" "$work.err"
}
full() {
  local code=0
  build/make_scene spheres --count 1 -o "$work/full.json" > /dev/full 2> /dev/null || code=$?
  [[ $code == 6 ]]
}

listed() {
  local wanted
  wanted=$(sed -n 's/^\([^ :=]*\):.*## .*/\1/p' Makefile tools/*.mk fpga/ultra96/board.mk | sort)
  [[ $wanted == *arm64* ]]
  diff <(echo "$wanted") <(make -s help | sed -n 's/^  \([^ ]*\) .*/\1/p' | grep -vx -e 'unit/FOLDER/NAME' -e 'JOBS=N' | sort)
}

case_of Teapot rendered teapot --n 2
case_of Field rendered field --columns 1 --rows 2 --n 1
case_of Spheres rendered spheres --count 5
case_of MeshAlone mesh_alone
mkdir "$work/folder.json"
case_of NoSuchFolder refused 6 "$work/none/a.geo: write" teapot --n 1 -o "$work/none/a.json"
case_of AFolder refused 6 "$work/folder.json" teapot --n 1 -o "$work/folder.json"
case_of NoName refused 2 output spheres
case_of NoCount refused 2 count spheres --count 0 -o "$work/a.json"
case_of NoScene refused 2 subcommand cube -o "$work/a.json"
case_of FullOutput full
case_of HelpListsEveryTarget listed
ends
