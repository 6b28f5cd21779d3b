# SPDX-License-Identifier: Apache-2.0
"""The RTL at the points of the width study where it is built: a core of one lane whose frames equal the model's, and the
resources of the units whose formats change, each synthesised flat."""
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import time

import points
import set_widths

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "synth"))
import yosys  # noqa: E402

BUILD = pathlib.Path("build/width")
CORE = {"lanes": 1, "ports": 2, "l2": 0}
FRAMES = [("teapot", "bvh", "96x72"), ("teapot_tight", "bvh", "64x48"), ("teapot_interior", "bvh_root", "48x36"), ("spheres", "bvh", "96x72"),
          ("teapot", "brute", "24x18"), ("spheres", "brute", "48x36"), ("cube", "brute", "48x36")]
UNITS = ["isect/ray_prim", "isect/hit_unit", "isect/node_pipe", "camera/ray_setup"]


def folder_of(point):
    """Where it is built: the widths as they are in the build that there is."""
    return BUILD / f"rtl_{point.name}" if point.widths else pathlib.Path("build")


def package_of(point):
    return set_widths.write(folder_of(point), point.widths) if point.widths else set_widths.PACKAGE.relative_to(pathlib.Path.cwd())


def frames(point):
    """Builds the core, renders each frame; [(scene, mode, size, cycles)]. A frame that is not the model's ends the study."""
    folder = folder_of(point)
    package = package_of(point)
    flags = [] if not point.widths else [f"CXXFLAGS=-std=c++20 -O1 -march=native -Wall -Wextra -Wno-unused-parameter -MMD -MP -Icpp_model -Isim -I{folder}/gen -isystem /usr/include/Imath"]
    variant = "l{lanes}c32t3p{ports}m{l2}.so".format(**CORE)
    subprocess.run(["make", "-s", f"BUILD={folder}", f"CONFIG={package}", "CORE_OPT=-O1", *flags, f"{folder}/castray",
                    f"{folder}/cores/{variant}", f"{folder}/lint/castray_core.ok"], check=True, stdout=subprocess.DEVNULL)
    out = []
    for scene, mode, size in FRAMES:
        report = BUILD / "frame.json"
        subprocess.run([folder / "castray", "render", f"scenes/{scene}.json", "--mode", mode, "--size", size, "--check", "-o", BUILD / "frame.png",
                        "--json", report, *(text for name, value in CORE.items() for text in (f"--{name}", str(value)))],
                       check=True, stdout=subprocess.DEVNULL)
        out.append((scene, mode, size, json.loads(report.read_text())["cycles"]))
    return out


def resources(point, unit):
    """Counts of a unit, flat: then what a narrow operand leaves of a wide multiplier goes away."""
    files = [str(package_of(point)) if f == "rtl/pkg/castray_cfg_pkg.sv" else f for f in yosys.rtl_files()]
    design = yosys.elaborate([unit.split("/")[-1]], files=files, name=f"width_{unit.split('/')[-1]}_{point.name}")
    (top,) = design.tops.values()
    counts = yosys.synthesise_flat(design, [top], 1)[top]
    return {r: counts[r] for r in yosys.RESOURCES}


def study(jobs, wanted=None):
    """{point's label: {"frames": [...], "units": {unit: counts}}}."""
    start, out = time.monotonic(), {}
    for point in wanted or points.rtl_points():
        entry = out.setdefault(point.label, {"widths": points.defaults() | point.widths, "units": {}})
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            for unit, counts in zip(UNITS, pool.map(lambda unit: resources(point, unit), UNITS)):
                entry["units"][unit] = counts
                print(f"  width {time.monotonic() - start:4.0f} s  {point.label} {unit}: {counts}", flush=True)
                expected = points.dsps(point.widths).get(unit, 0)
                if counts["dsp"] != expected:
                    sys.exit(f"width: {unit} takes {counts['dsp']} DSPs at {point.label}; its operands say {expected}")
        entry["frames"] = frames(point)   # raises an error where one is not the model's
        print(f"  width {time.monotonic() - start:4.0f} s  {point.label}: a core of one lane equals the model on {len(FRAMES)} frames", flush=True)
    return out
