#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plant each fault of tb/faults/*.json in a copy of the tree: its unit's own test must catch it.

A fault is {"unit", "file", "old", "new", "why"}: in `file` the text `old`, which must stand there
exactly once, is replaced by `new`; then build/unit/<unit>_test is built and must fail when run.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile


def load(folder, only):
    """All faults, each with the file that lists it; `only` keeps the units named."""
    faults = []
    for path in sorted(folder.glob("*.json")):
        for fault in json.loads(path.read_text()):
            if not only or fault["unit"] in only:
                faults.append(dict(fault, listed=path.name))
    return faults


def run_test(tree, unit, jobs):
    """None if the unit's test does not build or end, else whether it passes; and a message."""
    test = f"build/unit/{unit}_test"
    built = subprocess.run(["make", "-s", f"-j{jobs}", test], cwd=tree, capture_output=True, text=True)
    if built.returncode:
        return None, "does not build: " + (built.stderr.strip().splitlines() or ["no message"])[-1]
    try:
        run = subprocess.run([f"./{test}"], cwd=tree, capture_output=True, timeout=300)
    except subprocess.TimeoutExpired:
        return None, "the test did not end"
    return run.returncode == 0, "passes" if run.returncode == 0 else "fails"


def verdict(tree, fault, jobs):
    """'caught', or what went wrong instead."""
    target = tree / fault["file"]
    text = target.read_text()
    if text.count(fault["old"]) != 1:
        return f"the text stands {text.count(fault['old'])} times in {fault['file']}"
    target.write_text(text.replace(fault["old"], fault["new"]))
    try:
        passed, message = run_test(tree, fault["unit"], jobs)
        return message if passed is None else "NOT caught" if passed else "caught"
    finally:
        target.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("units", nargs="*", help="units such as isect/ray_prim; none: all")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    args = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parent.parent
    faults = load(root / "tb/faults", args.units)
    if not faults:
        sys.exit("plant_faults: no fault is listed for " + " ".join(args.units))
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder) / "castray"
        shutil.copytree(root, tree, ignore=shutil.ignore_patterns("build", ".git"))
        for unit in sorted({fault["unit"] for fault in faults}):
            passed, message = run_test(tree, unit, args.jobs)
            if not passed:
                sys.exit(f"plant_faults: without any fault the test of {unit} {message}")
        for number, fault in enumerate(faults, 1):
            result = verdict(tree, fault, args.jobs)
            failed += result != "caught"
            print(f"[{number}/{len(faults)}] {fault['unit']:24} {result:12} {fault['why']}", flush=True)
    print(f"{len(faults) - failed} passed, {failed} failed")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
