#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/integrate.md: writes the units' area into its table, from tools/synth/budgets.json; with --check FACTS it writes nothing
and compares the page with the RTL: the instantiation's ports and parameters, the error codes, the units, and the numbers of
their rates and latencies with those in their headers.
"""
import argparse
import json
import pathlib
import re
import sys

PAGE = pathlib.Path("docs/integrate.md")
BUDGETS = pathlib.Path("tools/synth/budgets.json")
RESOURCES = ("dsp", "bram36", "lut", "ff")
WORDS = {word: str(n) for n, word in enumerate(
    "zero one two three four five six seven eight nine ten eleven twelve thirteen".split())}
WORDS |= {"second": "2", "fourth": "4"}


def rows(page, title):
    """The rows of the table under a heading, as lists of cells."""
    section = page.split(f"\n## {title}\n")[1].split("\n## ")[0]
    table = [[cell.strip() for cell in line[1:-1].split("|")] for line in section.splitlines() if line.startswith("| ")]
    return table[1:]


def units():
    names = [line for line in pathlib.Path("rtl/castray.f").read_text().splitlines() if line.startswith("rtl/")]
    return [name.removeprefix("rtl/").removesuffix(".sv") for name in names if "/pkg/" not in name]


def header(unit):
    return pathlib.Path(f"rtl/{unit}.sv").read_text().split("\nmodule ")[0].split("\n", 1)[1]


def numbers(text):
    """The numbers of a text, written as digits or as words, without those of names and links."""
    found = re.findall(r"(?<![\w.])(\d+)(?![\w.]*\.md)", re.sub(r"\([^)]*\.md[^)]*\)", "", text))
    return set(found) | {WORDS[word] for word in re.findall(r"[a-z]+", text.lower()) if word in WORDS}


def timing(unit):
    """The numbers of those sentences of a header that speak of time; where there are none, of its stages."""
    text = re.sub(r"\n// ?", "\n", "\n" + header(unit))
    sentences = re.split(r"(?<=[.:])\s|\n(?=  )|\n(?=[A-Z])", text)
    said = numbers(" ".join(s for s in sentences if re.search(r"cycle|latency|stages|every|each", s, re.I)))
    return said if said - {"1"} else said | set(re.findall(r"\bs(\d+)\b", text))


def with_areas(page):
    """The page with the area of each unit as it is recorded."""
    budgets = json.loads(BUDGETS.read_text()) if BUDGETS.exists() else {}
    for name, *cells in rows(page, "Units: rate, latency, area"):
        area = [f"{budgets[name][key]:,g}" if name in budgets else "–" for key in RESOURCES]
        page = page.replace("| " + " | ".join([name, *cells]) + " |", "| " + " | ".join([name, *cells[:2], *area]) + " |")
    return page


def differences(page, facts):
    code = page.split("```verilog\n")[1].split("```")[0]
    parameters, ports = (re.findall(r"\.(\w+)\(", part) for part in code.split(") u_castray ("))
    for what, given, wanted in (("port", ports, [f[1] for f in facts if f[0] == "port"]),
                                ("parameter", parameters, [f[1] for f in facts if f[0] == "parameter"]),
                                ("parameter (table)", [row[0] for row in rows(page, "Instantiation")], parameters),
                                ("unit", [row[0] for row in rows(page, "Units: rate, latency, area")], units())):
        yield from (f"{what} {name} is not in the RTL" for name in given if name not in wanted)
        yield from (f"{what} {name} is missing" for name in wanted if given.count(name) != 1)
    package = pathlib.Path("rtl/pkg/castray_pkg.sv").read_text()
    codes = {name: number for name, number in re.findall(r"\b(Err\w+)\s*=\s*8'd(\d+)", package)}
    said = {name: number for number, name, _ in rows(page, "Error codes")}
    yield from (f"error code {name}: {said.get(name)} here, {codes.get(name)} in castray_pkg"
                for name in codes | said if codes.get(name) != said.get(name))
    for name, rate, latency, *_ in rows(page, "Units: rate, latency, area"):
        unknown = numbers(f"{rate} {latency}") - {"1"} - timing(name) if name in units() else None
        if unknown:
            yield f"unit {name}: '{rate}', '{latency}', but its header has no {unknown}"
    if with_areas(page) != page:
        yield "the areas are not those of tools/synth/budgets.json: run tools/integrate_page.py"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split(":")[0])
    parser.add_argument("--check", type=pathlib.Path, metavar="FACTS", help="what tb/fpga/top_facts.py wrote")
    args = parser.parse_args()
    if not args.check:
        PAGE.write_text(with_areas(PAGE.read_text()))
        return
    facts = [line.split() for line in args.check.read_text().splitlines()]
    wrong = [f"{PAGE}: {line}" for line in differences(PAGE.read_text(), facts)]
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
