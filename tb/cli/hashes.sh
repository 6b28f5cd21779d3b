#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The picture and the raw hits of every scene at 80x60, by the model, have the SHA-256 that stands
# in scenes/frames.sha256; with --write they are written anew. The RTL, in the hierarchy, renders the same.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

render() { # engine, scene
  build/castray render "$2" --engine "$1" --size 80x60 --frame "$work/$(basename "$2" .json).pixels" \
    --hits "$work/$(basename "$2" .json).hits" -o "$work/picture.png" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
}

for scene in scenes/*.json; do render model "$scene"; done
if [[ ${1:-} == --write ]]; then
  (cd "$work" && sha256sum -- *.pixels *.hits) > scenes/frames.sha256
  exit 0
fi
(cd "$work" && sha256sum --quiet -c) < scenes/frames.sha256
if [[ $(wc -l < scenes/frames.sha256) -ne $(($(ls scenes/*.json | wc -l) * 2)) ]]; then
  echo "scenes/frames.sha256 does not list every scene: make hashes"
  exit 1
fi
rm "$work"/*.pixels "$work"/*.hits
for scene in scenes/*.json; do render rtl "$scene"; done
(cd "$work" && sha256sum --quiet -c) < scenes/frames.sha256
echo "every frame is what it was"
