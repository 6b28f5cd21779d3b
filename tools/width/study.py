#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The width study: errors and DSPs over the bits of each format; docs/width-study.md.

    study.py            the model at every point: table and plot
    study.py --rtl      the RTL at three of them too: built, compared with the model, synthesised
"""
import argparse
import json
import pathlib

import model
import page

RESULTS = pathlib.Path("docs/width-study.json")   # the last ones: the RTL's stay when the model's are made anew


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--rtl", action="store_true")
    args = parser.parse_args()
    results = json.loads(RESULTS.read_text()) if RESULTS.exists() else {}
    results["points"] = [{"curve": p.curve, "label": p.label, "bits": p.bits, "widths": p.widths, "found": found}
                         for p, found in model.study(args.jobs)]
    if args.rtl:
        import rtl
        results["rtl"] = rtl.study(args.jobs)
    RESULTS.write_text(json.dumps(results, indent=None, separators=(",", ":")).replace('{"curve"', '\n{"curve"') + "\n")
    page.write(results)


if __name__ == "__main__":
    main()
