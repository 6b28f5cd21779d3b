#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plant each fault of tb/faults in a copy of the tree: its unit's own test must catch it.

There are as many copies as jobs. A copy takes what is built with it, so that only what a fault
changes is built anew. Those of the proofs are planted by `make formal`.
"""
import argparse
import concurrent.futures
import os
import pathlib
import queue
import shutil
import subprocess
import sys
import tempfile
import time

import fault_list


def run_test(tree, unit, **environment):
    """None if the unit's test does not build or end, else whether it passes; and a message."""
    test = fault_list.test_of(tree, unit)
    if test.startswith("build/"):
        built = subprocess.run(["make", "-s", "-j1", "JOBS=1", test], cwd=tree, capture_output=True, text=True)
        if built.returncode:
            return None, "does not build: " + (built.stderr.strip().splitlines() or ["no message"])[-1]
    try:
        run = subprocess.run([f"./{test}"], cwd=tree, capture_output=True, timeout=300, env=os.environ | environment)
    except subprocess.TimeoutExpired:
        return None, "the test did not end"
    return run.returncode == 0, "passes" if run.returncode == 0 else "fails"


def verdict(tree, fault):
    """'caught', or what went wrong instead."""
    problem = fault_list.unplantable(tree, fault)
    if problem:
        return problem
    target = tree / fault["file"]
    text = target.read_text()
    target.write_text(text.replace(fault["old"], fault["new"]))
    try:
        passed, message = run_test(tree, fault["unit"], GTEST_FAIL_FAST="1")
        return message if passed is None else "NOT caught" if passed else "caught"
    finally:
        target.write_text(text)   # newer than what was built from the fault, which is so built again


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("units", nargs="*", help="units such as isect/ray_prim; none: all")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--trust", action="store_true", help="all tests are known to pass without a fault: don't run them first")
    args = parser.parse_args()
    faults = [fault for fault in fault_list.load()
              if fault["listed"] != "formal" and (not args.units or fault["unit"] in args.units)]
    if not faults:
        sys.exit("plant_faults: no fault is listed for " + " ".join(args.units))
    failed = 0
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        trees = queue.Queue()
        for job in range(args.jobs):
            trees.put(shutil.copytree(fault_list.ROOT, pathlib.Path(folder) / f"castray{job}", ignore=shutil.ignore_patterns(".git", "*.pch")))

        def in_a_tree(work, item):
            tree = trees.get()
            try:
                return work(tree, item)
            finally:
                trees.put(tree)

        units = [] if args.trust else sorted({fault["unit"] for fault in faults})
        for unit, (passed, message) in zip(units, pool.map(in_a_tree, [run_test] * len(units), units)):
            if not passed:
                pool.shutdown(cancel_futures=True)
                sys.exit(f"plant_faults: without any fault the test of {unit} {message}")
        results = pool.map(in_a_tree, [verdict] * len(faults), faults)
        for number, (fault, result) in enumerate(zip(faults, results), 1):
            failed += result != "caught"
            print(f"[{number}/{len(faults)}] {fault['unit']:24} {result:12} {fault['why']}", flush=True)
    print(f"planted for {time.monotonic() - start:.0f} s\n{len(faults) - failed} passed, {failed} failed")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
