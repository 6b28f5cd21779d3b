#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What fpga/ultra96/castray_top.v is once it is synthesised: its ports and parameters, a line each, as Tcl lists.

  source FILE                                       a file that went into it
  parameter NAME DEFAULT
  port NAME DIRECTION WIDTH X_INTERFACE_INFO X_INTERFACE_PARAMETER

The whole core is elaborated below it (one lane), so a port that the core does not have is an error here. The wrapper is also read
as plain Verilog, which is what Vivado's packager wants: that gives the parameters.
"""
import argparse
import json
import pathlib
import subprocess
import sys

TOP = "fpga/ultra96/castray_top.v"

SCRIPT = """
read_verilog {top}
write_json {folder}/top_verilog.json
design -reset
read_slang --threads 1 -D SYNTHESIS --top castray_top -G Lanes=1 {sources}
hierarchy -check -top castray_top
design -reset
read_slang --threads 1 -D SYNTHESIS --top castray_top --blackboxed-module castray_core {sources}
synth -top castray_top
write_json {folder}/top_netlist.json
"""


def run_yosys(yosys, folder, sources):
    """The wrapper as plain Verilog and as a netlist above the elaborated core, as Yosys describes them."""
    script = folder / "top_facts.ys"
    script.write_text(SCRIPT.format(top=TOP, folder=folder, sources=" ".join(sources)))
    done = subprocess.run([yosys, "-q", "-s", script], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"top_facts: {done.stdout}{done.stderr}")
    return [json.loads((folder / name).read_text())["modules"]["castray_top"] for name in ("top_verilog.json", "top_netlist.json")]


def facts(verilog, netlist, sources):
    for source in sources:
        yield f"source {source}"
    for name, value in verilog["parameter_default_values"].items():
        yield f"parameter {name} {int(value, 2)}"
    for name, port in netlist["ports"].items():
        attributes = netlist["netnames"][name]["attributes"]
        info, parameter = (attributes.get(f"X_INTERFACE_{kind}", "") for kind in ("INFO", "PARAMETER"))
        yield f"port {name} {port['direction']} {len(port['bits'])} {{{info}}} {{{parameter}}}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("yosys")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    args = parser.parse_args()
    listed = pathlib.Path("rtl/castray.f").read_text().splitlines()
    sources = [line for line in listed if line and not line.startswith("//")] + [TOP]
    args.output.parent.mkdir(parents=True, exist_ok=True)
    args.output.write_text("\n".join(facts(*run_yosys(args.yosys, args.output.parent, sources), sources)) + "\n")


if __name__ == "__main__":
    main()
