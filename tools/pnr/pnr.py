#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The clock of each unit and of a small core, placed and routed on an ECP5: another, slower family than the board's.

    pnr.py                      all of them: build/pnr.json, docs/pnr.md
    pnr.py UNIT...              some, for example isect/ray_prim: a line each; --seeds 1 for a first look
    pnr.py --kept               the page of what is kept already; what is not is named
    pnr.py --check              those that miss their bar, against the clocks in tools/pnr/budgets.json
    pnr.py --record             write these anew, from what is kept
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "synth"))
import yosys  # noqa: E402

import clocks_page  # noqa: E402
import place  # noqa: E402

BUDGETS = pathlib.Path("tools/pnr/budgets.json")
RECORDS = pathlib.Path("build/pnr.json")
CORE = "castray_core"
# Units are placed as they are in the core of three lanes; those that are larger than the device as they are in
# a core of one lane, whose contexts, queues and caches are few.
WHOLE = {"Lanes": 3, "Ports": 2, "L2Kbytes": 128}
SMALL = {"Lanes": 1, "Contexts": 4, "TileLog2": 2, "AttrEntries": 16, "Ports": 1, "L2Kbytes": 0}
LARGE = ("traverse/traversal", CORE)
# Of those the products of these units are made of LUTs: the device has 156 multipliers.
IN_LUTS = {CORE: ("slab_planes",)}
# At most so many units may miss their bar; a placement that comes so near to the clock that is kept counts as equal.
MAY_MISS = 3
ROOM = 0.97
LOGIC = re.compile(r"\s*(cell \$(?!buf )|switch |sync )")


def size(design, name):
    """Bits of the wires and memories of a module and all below it: larger instances have more."""
    lines = (line for n in design.below(name) for line in design.modules[n].lines)
    return sum(math.prod(map(int, re.findall(r" (?:width|size) (\d+)", line))) for line in lines if line.startswith(("  wire ", "  memory ")))


def is_wires(design, name):
    """Whether there is no logic in it: wires, or what exists in simulation only."""
    return not any(LOGIC.match(line) for n in design.below(name) for line in design.modules[n].lines)


def jobs_of(names, files=None):
    """[(unit, design, module)], the small ones first; of a unit with several widths the largest. files: another RTL."""
    def design_of(parameters, label):
        return yosys.elaborate([CORE], parameters, files, f"pnr_{label}")
    whole = design_of(WHOLE, "whole")
    small = design_of(SMALL, "small") if set(names) & set(LARGE) else None
    found = []
    for unit in names:
        design = small if unit in LARGE else whole
        modules = [m.name for m in design.modules.values() if m.unit == unit.split("/")[-1]]
        modules = [name for name in modules if not is_wires(design, name)]
        if modules:
            found.append((unit, design, max(modules, key=lambda name: size(design, name))))
    return sorted(found, key=lambda job: size(job[1], job[2]))


def record(job, **options):
    """The record of a unit; one that the tools stop on is not placed, and the others are."""
    unit, design, module = job
    try:
        return {"name": unit, "lanes": SMALL["Lanes"] if unit in LARGE else WHOLE["Lanes"],
                **place.clock(design, module, IN_LUTS.get(unit, ()), **options)}
    except SystemExit as stop:
        print(stop, flush=True)
        return {"name": unit, "mhz": 0, "bar": max(place.BAR.values())}


def misses(records):
    return [r for r in records if r["mhz"] < r["bar"]]


def line(entry):
    if not entry["mhz"]:
        return f"{entry['name']}: not placed"
    return (f"{entry['name']}: {entry['mhz']} MHz, bar {entry['bar']}{'' if entry['mhz'] >= entry['bar'] else ', missed'}; "
            f"{entry['path']['from']} -> {entry['path']['to']}")


def all_of(jobs, workers, seeds=place.SEEDS):
    """The records, in the order of rtl/castray.f. Prints progress."""
    records, done = [], 0
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for ready in concurrent.futures.as_completed([pool.submit(record, job, seeds=seeds) for job in jobs]):
            records.append(ready.result())
            done += 1
            print(f"  pnr: {done} of {len(jobs)}  {line(records[-1])}", flush=True)
    order = yosys.units()
    return sorted(records, key=lambda r: order.index(r["name"]))


def of_kept(jobs):
    """The records that are kept, and the names of the others."""
    known = {unit for unit, design, module in jobs if place.kept(place.key(design, module, IN_LUTS.get(unit, ())))}
    return all_of([job for job in jobs if job[0] in known], 1), [job[0] for job in jobs if job[0] not in known]


def write(records, missing=()):
    RECORDS.write_text(json.dumps(records, indent=1) + "\n")
    clocks_page.write(records, missing)
    few = misses(records)
    print(f"pnr: {len(records) - len(few)} of {len(records)} reach their bar" + "".join(f"\n  {line(r)}" for r in few))
    return len(few) <= MAY_MISS


def budgets(records):
    """The text of the file: of each unit the key of what was placed; of one that misses its bar its clock too."""
    lines = []
    for entry in records:
        late = {k: entry[k] for k in ("mhz", "bar", "seed")} if entry["mhz"] < entry["bar"] else {}
        late |= {"path": f"{entry['path']['from']} -> {entry['path']['to']}"} if late else {}
        lines.append(f"  {json.dumps(entry['name'])}: {json.dumps({'key': entry['key'], **late})}")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def slower(records, kept):
    """Which of the records are slower than their budgets, a line each."""
    return [f"{r['name']}: {r['mhz']} MHz, it was {kept[r['name']]['mhz']}" for r in records if r["mhz"] < kept[r["name"]]["mhz"] * ROOM]


def check(workers, kept, files=None):
    """Places those of the budgets that miss their bar again and prints which are slower than they were; True if none is."""
    late = [unit for unit, entry in kept.items() if "mhz" in entry]
    jobs = jobs_of(list(kept), files)
    changed = [unit for unit, design, module in jobs if place.key(design, module, IN_LUTS.get(unit, ())) != kept[unit]["key"]]
    records = []
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for entry in pool.map(lambda job: record(job, seeds=(kept[job[0]]["seed"],)), [job for job in jobs if job[0] in late]):
            print(f"  pnr: {line(entry)}", flush=True)
            records.append(entry)
    wrong = slower(records, kept) + [f"{unit} has a budget and is no unit" for unit in late if unit not in {r["name"] for r in records}]
    for text in wrong:
        print(f"slower: {text}")
    if len(late) > MAY_MISS:
        print(f"pnr-check: {len(late)} units miss their bar, more than {MAY_MISS}")
    if changed:
        print(f"pnr-check: changed since they were placed, `make pnr` places them: {' '.join(changed)}")
    print(f"pnr-check: {len(late) - len(wrong)} of {len(late)} units that miss their bar are as fast as they were, {len(kept) - len(late)} units reach it")
    return not wrong and len(late) <= MAY_MISS


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("units", nargs="*")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--seeds", type=int, default=len(place.SEEDS), help="placements tried where a unit nearly reaches its bar")
    parser.add_argument("--kept", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--record", action="store_true")
    args = parser.parse_args()
    if args.check:
        sys.exit(not check(args.jobs, json.loads(BUDGETS.read_text())))
    jobs = jobs_of(args.units or yosys.units())
    if args.units:
        all_of(jobs, args.jobs, place.SEEDS[:args.seeds])
    elif args.kept or args.record:
        records, missing = of_kept(jobs)
        if args.record:
            BUDGETS.write_text(budgets(records))
        write(records, missing)
    else:
        sys.exit(not write(all_of(jobs, args.jobs, place.SEEDS[:args.seeds])))


if __name__ == "__main__":
    main()
