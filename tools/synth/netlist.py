#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A synthesised netlist as Verilog, to be simulated in the RTL's place: cells of the device, flat vectors as ports.

    netlist.py isect/accept -o build/netlist/isect/accept.v
    netlist.py castray_core Lanes=1 Contexts=8 -o ...       parameters of the top

A test bench wrapper tb/<folder>/<unit>_tb.sv, where there is one, is the top, as it is in the unit's own test.
"""
import argparse
import pathlib
import re

import yosys

# Contents and reset values that are not given: nothing may depend on them.
UNKNOWN = re.compile(r"    parameter \\(INIT|SRVAL)\S* \d+'[0x]*x[0x]*$")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("unit")
    parser.add_argument("parameters", nargs="*", help="NAME=VALUE")
    parser.add_argument("-o", dest="out", type=pathlib.Path, required=True)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    args = parser.parse_args()
    top, files = args.unit.split("/")[-1], yosys.rtl_files()
    wrapper = pathlib.Path(f"tb/{args.unit}_tb.sv")
    if wrapper.exists():
        top, files = f"{top}_tb", [*files, str(wrapper)]
    name = f"netlist_{top}"
    design = yosys.elaborate([top], dict(p.split("=") for p in args.parameters), files, name)
    yosys.synthesise(design, [design.tops[top]], args.jobs, quiet=True)
    lines = []
    for module in design.below(design.tops[top]):
        text = (yosys.CELLS / f"{module}.il").read_text()
        lines += [line for line in text.splitlines(keepends=True) if not UNKNOWN.match(line)]
    source = yosys.BUILD / f"{name}.net.il"
    source.write_text("".join(lines))
    args.out.parent.mkdir(parents=True, exist_ok=True)
    yosys.run(f"read_rtlil {source}\nrename {design.tops[top]} {top}\nwrite_verilog -noattr {args.out}\n", f"{name}_write")


if __name__ == "__main__":
    main()
