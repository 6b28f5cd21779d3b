#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The board's program, cross-compiled for arm64 and run under qemu-user: by the model it gives frames and hits of the
# SHA-256 that stands in scenes/frames.sha256, and of a list of rays the records of castray query; what it cannot do it
# refuses in one line. The same of the program for this machine.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "$1"; exit 1; }
arm64() { qemu-aarch64 build/arm64/castray_board "$@"; }
here() { build/castray_board "$@"; }
[[ $(od -An -tx1 -j18 -N2 build/arm64/castray_board) == " b7 00" ]] || fail "build/arm64/castray_board is not for arm64"

for scene in cube spheres teapot; do
  build/castray compile scenes/$scene.json --size 80x60 -o "$work/$scene.image" > "$work/log"
  for program in arm64 here; do
    $program "$work/$scene.image" --engine model --frame "$work/$scene.pixels" --hits "$work/$scene.hits" -o "$work/$program.ppm" > "$work/log"
    (cd "$work" && grep -E "  $scene\.(pixels|hits)\$" "$OLDPWD/scenes/frames.sha256" | sha256sum --quiet -c) || fail "$program: $scene is another frame"
  done
  cmp "$work/arm64.ppm" "$work/here.ppm"
done
build/castray render scenes/teapot.json --size 80x60 --engine model -o "$work/picture.png" > "$work/log"
build/castray compare "$work/arm64.ppm" "$work/picture.png" > "$work/log" || fail "the pixmap differs from castray's picture"
arm64 "$work/cube.image" --engine model --mode brute --frame "$work/cube.brute" > "$work/log"
cmp "$work/cube.brute" "$work/cube.pixels"

# A list: origins across the grid, directions of Q3.42, one record of 64 bytes each (docs/ray-list.md).
python3 - "$work/rays" << 'END'
import pathlib, random, sys
sys.path.insert(0, "tools")
import sv_records
packages = sv_records.Packages()
for line in open("rtl/castray.f"):
    if line.startswith("rtl/pkg/"):
        packages.read(pathlib.Path(line.strip()))
bits, _, fields = packages.types["ray_record_t"]
random.seed(5)
with open(sys.argv[1], "wb") as out:
    for _ in range(500):
        word = 0
        for name, _, width, _, _, at in fields:
            kind = name.split("_")[0]
            value = {"org": random.randrange(1 << 26), "dir": random.randrange(-1 << 42, 1 << 42) % (1 << width),
                     "tmax": (1 << (width - 1)) - 1, "ignore": (1 << width) - 1}.get(kind, 0)
            word |= value << at
        out.write(word.to_bytes(bits // 8, "little"))
END
for program in arm64 here; do $program "$work/teapot.image" --engine model --rays "$work/rays" --hits "$work/$program.answers" > "$work/log"; done
build/castray query scenes/teapot.json "$work/rays" --size 80x60 --raw --engine model -o "$work/answers" > "$work/log"
cmp "$work/arm64.answers" "$work/answers"
cmp "$work/here.answers" "$work/answers"

refuse() { # exit code, words, arguments
  local code=0
  arm64 "${@:3}" > "$work/log" 2> "$work/err" || code=$?
  [[ $code -eq $1 && $(wc -l < "$work/err") -eq 1 ]] || { cat "$work/err"; fail "${*:3}: exit code $code, not $1 and one line"; }
  grep -q -- "$2" "$work/err" || { cat "$work/err"; fail "${*:3}: does not say '$2'"; }
}
head -c 1000 "$work/cube.image" > "$work/short.image"
refuse 4 "no board" "$work/cube.image"
refuse 2 "no such file" "$work/none.image"
refuse 2 "section" "$work/short.image" --engine model
refuse 2 "no scene image" scenes/teapot.json --engine model
refuse 2 "--engine rtl" "$work/cube.image" --engine rtl
refuse 2 "--mode fast" "$work/cube.image" --engine model --mode fast
refuse 2 "--timeout -1" "$work/cube.image" --timeout -1
refuse 2 "records" "$work/cube.image" --engine model --rays "$work/err" --hits "$work/none"
refuse 2 "need --hits" "$work/cube.image" --engine model --rays "$work/rays"
for option in -o --frame; do
  refuse 2 "no picture" "$work/cube.image" --engine model --rays "$work/rays" --hits "$work/none" $option "$work/none.ppm"
done
for option in -o --frame --hits --rays; do refuse 2 "$option: the name is empty" "$work/cube.image" --engine model $option ""; done

# Outputs are judged before the job: none of them is there after a refusal, and no input is written over.
cp "$work/cube.image" "$work/kept.image"
refuse 2 "scene image as well" "$work/kept.image" --engine model --frame "$work/kept.image"
refuse 2 "file of --rays as well" "$work/cube.image" --engine model --rays "$work/rays" --hits "$work/rays"
refuse 2 "file of --frame as well" "$work/cube.image" --engine model --frame "$work/none" --hits "$work/../${work##*/}/none"
refuse 6 "none/a.ppm: cannot be written" "$work/cube.image" --engine model --frame "$work/none" -o "$work/none/a.ppm"
refuse 6 "cannot be written" "$work/cube.image" --engine model --hits "$work"
refuse 6 "No space left" "$work/cube.image" --engine model --hits /dev/full
[[ ! -e $work/none ]] || fail "a file was written though the job was refused"
cmp "$work/kept.image" "$work/cube.image"
code=0
arm64 "$work/cube.image" --engine model > /dev/full 2> "$work/err" || code=$?
[[ $code -eq 6 ]] && grep -q "standard output" "$work/err" || fail "a full standard output: exit code $code, not 6"
echo "arm64: the frames and hits are those of scenes/frames.sha256"
