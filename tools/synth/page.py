# SPDX-License-Identifier: Apache-2.0
"""docs/area.md: the tables of what `make synth` measured."""
import pathlib

PAGE = pathlib.Path("docs/area.md")
START, END = "<!-- tables: make synth -->", "<!-- end of tables -->"
CAPACITY = {"dsp": 360, "bram36": 216, "lut": 70560, "lut_cells": 70560, "ff": 141120}
NAMES = {"dsp": "DSP48E2", "bram36": "BRAM36", "lut": "LUT", "lut_cells": "LUT cells", "ff": "FF"}
# Table II of the report, its last row: three lanes on the same part, percent.
REPORT = {"dsp": 92, "bram36": 91, "lut": 52, "lut_cells": 52, "ff": 31}
BAR = 0.75


def row(name, counts):
    return f"| {name} | " + " | ".join(f"{counts[r]:,g} ({100 * counts[r] / CAPACITY[r]:.0f}%)" for r in CAPACITY) + " |"


def tables(records):
    head = "| | " + " | ".join(NAMES[r] for r in CAPACITY) + " |\n|---|" + "---|" * len(CAPACITY)
    cores = [r for r in records if r["lanes"]]
    lines = [head]
    lines += [row(f"castray, {r['lanes']} lane{'s' if r['lanes'] > 1 else ''}", r) for r in cores]
    lines += ["| the report, 3 lanes | " + " | ".join(f"{REPORT[r]}%" for r in CAPACITY) + " |"]
    lines += ["| ZU3EG | " + " | ".join(f"{n:,}" for n in CAPACITY.values()) + " |"]
    lines += [f"| {BAR:.0%} of it | " + " | ".join(f"{BAR * n:,g}" for n in CAPACITY.values()) + " |"]
    lines += ["", "| unit, with all below it | in three lanes | " + " | ".join(NAMES[r] for r in CAPACITY) + " |\n|---|---|" + "---|" * len(CAPACITY)]
    lines += [f"| {r['name']} | {r['instances']} | " + " | ".join(f"{r[k]:,g}" for k in CAPACITY) + " |"
              for r in records if not r["lanes"] and r["instances"]]
    return "\n".join(lines)


def write(records):
    before, rest = PAGE.read_text().split(START)
    PAGE.write_text(f"{before}{START}\n{tables(records)}\n{END}{rest.split(END)[1]}")
    print(f"wrote build/synth.json and {PAGE}")
