#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The bench's program: the runs that are asked for, their records as a list, their tables as a page. What the records and
# tables hold: tb/sim/bench_test.cpp.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

build/bench --json "$work/bench.json" --page "$work/bench.md" --only reference --match "cube base" > "$work/out" 2> "$work/log" || { cat "$work"/{out,log}; exit 1; }
grep -q "1 of 1  cube base" "$work/log"
python3 - "$work/bench.json" <<'CHECK'
import json, sys
records = json.load(open(sys.argv[1]))
assert [(r["part"], r["scene"], r["pixels"], r["cycles"]) for r in records] == [("reference", "cube", 76800, None)], records
CHECK
grep -q "^| cube | base | 320x240 |" "$work/bench.md"
[[ $(grep -c "^## " "$work/bench.md") -eq 1 ]]
cmp "$work/bench.md" "$work/out"
echo "the bench runs, with records and a page"
