#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run test programs side by side and end with a line `N passed, N failed`.

A GoogleTest program counts each of its tests; any other counts as one, by its exit code. A test
that was not built counts as failed. Logs go to build/log; those of failed tests are printed.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import time

# A script that calls make does so as from a shell: the jobs of the make that runs the tests are not passed on.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}


def run(program, log_dir, limit):
    """(program, passed, failed, seconds, log) of one test program."""
    name = str(program).removeprefix("build/unit/").replace("/", "-")
    log = log_dir / f"{name}.log"
    if not os.access(program, os.X_OK):
        log.write_text(f"{program} was not built\n")
        return program, 0, 1, 0.0, log
    start = time.monotonic()
    with log.open("w") as out:
        try:
            code = subprocess.run([f"./{program}"], stdout=out, stderr=subprocess.STDOUT,
                                  stdin=subprocess.DEVNULL, timeout=limit, env=ENVIRONMENT).returncode
        except subprocess.TimeoutExpired:
            out.write(f"\nstopped after {limit} s\n")
            code = 1
    seconds = time.monotonic() - start
    text = log.read_text(errors="replace")
    passed = len(re.findall(r"^\[       OK \]", text, re.M))
    failed = len(set(re.findall(r"^\[  FAILED  \] (\S+?),?(?: |$).*\(\d+ ms\)", text, re.M)))
    if "[==========]" not in text:
        passed, failed = int(code == 0), int(code != 0)
    elif code != 0 and failed == 0:
        failed = 1
    elif passed + failed == 0:
        failed = 1
    return program, passed, failed, seconds, log


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", nargs="+", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--limit", type=int, default=900, help="seconds a program may take")
    parser.add_argument("--passed", type=int, default=0, help="checks that passed before (lint)")
    parser.add_argument("--failed", type=int, default=0, help="checks that failed before")
    args = parser.parse_args()
    log_dir = pathlib.Path("build/log")
    log_dir.mkdir(parents=True, exist_ok=True)
    passed, failed = args.passed, args.failed
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        jobs = [pool.submit(run, p, log_dir, args.limit) for p in args.programs]
        for job in concurrent.futures.as_completed(jobs):
            program, ok, bad, seconds, log = job.result()
            passed += ok
            failed += bad
            print(f"  {'FAIL' if bad else 'ok':4} {seconds:6.1f} s  {ok:4} passed  {program}", flush=True)
            if bad:
                print("\n".join(log.read_text(errors="replace").splitlines()[-60:]), flush=True)
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
