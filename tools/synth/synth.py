#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What castray takes of a ZU3EG: DSPs, block RAMs, LUTs, flip-flops of every unit and of the whole core.

    synth.py                    the core for 1, 2, 3, 4 and 8 lanes, each unit in it: build/synth.json, docs/area.md
    synth.py UNIT...            some on their own, for example isect/ray_prim: a table of their parts
    synth.py --check            units and the core of three lanes against tools/synth/budgets.json
    synth.py --record           write these budgets anew
"""
import argparse
import collections
import json
import math
import pathlib
import sys

import page
import yosys

BUDGETS = pathlib.Path("tools/synth/budgets.json")
CORE = "castray_core"
# The levels of the core that are kept apart: each block below them is synthesised in one piece, as the whole core is too
# much for one process. What is the same in each number of lanes is so synthesised once.
FRAME = (CORE, "traversal")
CHECKED_LANES = 3
LANES = (1, 2, 3, 4, 8)
# A budget is what was measured. More DSPs or block RAMs than that fail; LUTs and flip-flops have this much room: a
# module takes up to 8% more or fewer LUTs with what else is synthesised in the same process.
ROOM = {"dsp": (1, 0), "bram36": (1, 0), "lut": (1.10, 10), "lut_cells": (1.10, 10), "ff": (1.03, 10)}


def record(name, lanes, counts):
    return {"name": name, "lanes": lanes, **{r: round(counts[r], 1) for r in yosys.RESOURCES}}


def whole(design, top, jobs):
    """The resources of a core: what is right below FRAME's modules in one piece each."""
    instances = design.instances(top)
    frame = [n for n in design.below(top) if design.modules[n].unit in FRAME]
    blocks = dict.fromkeys(child for n in frame for child in sorted(design.modules[n].children) if child not in frame)
    own = yosys.synthesise_own(design, frame, jobs)
    flat = yosys.synthesise_flat(design, blocks, jobs)
    sums = collections.Counter()
    for name, counts in (own | flat).items():
        for resource, number in counts.items():
            sums[resource] += instances[name] * number
    return sums


def core(lanes, jobs, files=None, units=True):
    """Records of the core of so many lanes, two ports, 128 KB of second cache, and of each unit in it, lanes 0."""
    design = yosys.elaborate([CORE], {"Lanes": lanes, "Ports": 2, "L2Kbytes": 128}, files, f"core{lanes}")
    top = design.tops[CORE]
    first = {**record(CORE, lanes, whole(design, top, jobs)), "instances": 1}
    if not units:
        return [first]
    counts = yosys.synthesise(design, [top], jobs)
    instances = design.instances(top)
    return [first] + [unit_record(name, design, instances, counts) for name in yosys.units() if name != CORE]


def unit_record(name, design, instances, counts):
    """A unit as it is in the core with all below it; of one with several widths the largest by LUTs."""
    of_unit = {n: times for n, times in instances.items() if design.modules[n].unit == name.split("/")[-1]}
    totals = [design.total(n, counts) for n in of_unit]
    largest = max(totals, key=lambda t: (t["lut"], t["ff"]), default={r: 0 for r in yosys.RESOURCES})
    return {**record(name, 0, largest), "instances": sum(of_unit.values())}


def parts(names, jobs):
    """Prints the parts of some units, the largest first."""
    for name in names:
        top = name.split("/")[-1]
        design = yosys.elaborate([top], name="parts")
        counts = yosys.synthesise(design, [design.tops[top]], jobs)

        def show(at, depth, times):
            total = design.total(at, counts)
            print(f"{'  ' * depth}{times:3} x {design.modules[at].unit:{32 - 2 * depth}}"
                  + "".join(f" {r} {total[r]:<7g}" for r in yosys.RESOURCES) + f" own lut {counts[at]['lut']}")
            below = design.modules[at].children
            for child in sorted(below, key=lambda c: -design.total(c, counts)["lut"] * below[c]):
                show(child, depth + 1, below[child])

        show(design.tops[top], 0, 1)


def measured(jobs, files=None):
    """What has a budget: {name: {resource: number}}."""
    return {r["name"]: {key: r[key] for key in yosys.RESOURCES} for r in core(CHECKED_LANES, jobs, files)}


def over(now, budgets):
    """What of {name: {resource: number}} is over its budget, a line each; and what has none, or is no unit."""
    wrong = [f"{name} has no budget; `make synth-record` writes it" for name in now if name not in budgets]
    wrong += [f"{name} has a budget and is no unit" for name in budgets if name not in now]
    for name, counts in now.items():
        for resource, number in counts.items():
            if resource not in budgets.get(name, counts):
                wrong.append(f"{name} has no budget of {resource}; `make synth-record` writes it")
                continue
            factor, more = ROOM[resource]
            most = math.floor(2 * (budgets.get(name, counts)[resource] * factor + more)) / 2
            if number > most:
                wrong.append(f"{name}: {resource} {number:g}, its budget is {budgets[name][resource]:g}")
    return wrong


def check(jobs, files=None):
    """Prints what is over its budget; True if nothing is."""
    now = measured(jobs, files)
    wrong = over(now, json.loads(BUDGETS.read_text()))
    for line in wrong:
        print(f"over budget: {line}" if ": " in line else f"budget: {line}")
    print(f"synth-check: {len(now) - len({w.split(':')[0] for w in wrong})} of {len(now)} within their budgets")
    return not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("units", nargs="*")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--file", action="append", default=[], metavar="FILE=INSTEAD", help="another text of a file of the RTL")
    args = parser.parse_args()
    instead = dict(f.split("=") for f in args.file)
    files = [instead.get(f, f) for f in yosys.rtl_files()]
    if args.units:
        parts(args.units, args.jobs)
    elif args.check:
        sys.exit(not check(args.jobs, files))
    elif args.record:
        BUDGETS.write_text("{\n" + ",\n".join(f'  "{n}": {json.dumps(c)}' for n, c in measured(args.jobs).items()) + "\n}\n")
    else:
        found = {}
        for lanes in LANES:
            found[lanes] = core(lanes, args.jobs, units=lanes == CHECKED_LANES)
            print("  synth: " + ", ".join(f"{k} {v}" for k, v in found[lanes][0].items()), flush=True)
        records = [found[lanes][0] for lanes in LANES] + found[CHECKED_LANES][1:]
        pathlib.Path("build/synth.json").write_text(json.dumps(records, indent=1) + "\n")
        page.write(records)


if __name__ == "__main__":
    main()
