#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pass on what a build prints, its steps numbered: "[12/57]   CXX   sim/bench.cpp".

    make -n GOALS | steps.py --count       how many steps GOALS would take
    make GOALS | steps.py N                number them
    make ... | steps.py --compiled N NAME  of the compiler's command lines, only how many of N have begun, now and then
"""
import re
import sys
import time

STEP = re.compile(r"  [A-Z]{3,} ")


def main():
    if sys.argv[1] == "--count":
        print(sum(line.startswith('echo "') and STEP.match(line[6:]) is not None for line in sys.stdin))
        return
    if sys.argv[1] == "--compiled":
        total, name = int(sys.argv[2]), sys.argv[3]
        done, last = 0, time.monotonic()
        for line in sys.stdin:
            if " -c " not in line:
                continue
            done += 1
            if time.monotonic() - last >= 2:
                last = time.monotonic()
                print(f"          {name}: {done} of {total} files", flush=True)
        return
    total, done = int(sys.argv[1]), 0
    for line in sys.stdin:
        if STEP.match(line):
            done += 1
            line = f"[{done}/{max(total, done)}] {line}"
        print(line, end="", flush=True)


if __name__ == "__main__":
    main()
