# SPDX-License-Identifier: Apache-2.0
"""docs/pnr.md: the table of what `make pnr` measured."""
import pathlib

PAGE = pathlib.Path("docs/pnr.md")
START, END = "<!-- table: make pnr -->", "<!-- end of table -->"
HEAD = ("| unit | MHz | bar | | LUT | FF | MULT18X18D | block RAMs | wide products | worst path | through | ns, of it routing |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|")


def count(kind, number):
    plural = {"wide mux": "wide muxes", "LUT memory": "LUT memories"}
    return f"{number} {kind if number == 1 else plural.get(kind, kind + 's')}"


def row(entry):
    path = entry["path"]
    cells = [entry["name"] + (" (one lane)" if entry["lanes"] == 1 else ""), entry["mhz"], entry["bar"],
             "met" if entry["mhz"] >= entry["bar"] else "**missed**",
             *(f"{entry[kind]:,}" for kind in ("luts", "ff", "multipliers", "block_rams")), ", ".join(entry["wide"]),
             f"`{path['from']}` → `{path['to']}`", ", ".join(count(*pair) for pair in path["through"].items()),
             f"{path['ns']}, {path['routing_ns']}"]
    return "| " + " | ".join(map(str, cells)) + " |"


def write(records, missing=()):
    lines = [HEAD, *(row(entry) for entry in records if entry["mhz"])]
    lines += [""] + [f"Not placed yet: {', '.join(missing)}."] if missing else []
    before, rest = PAGE.read_text().split(START)
    PAGE.write_text(f"{before}{START}\n" + "\n".join(lines) + f"\n{END}{rest.split(END)[1]}")
    print(f"wrote build/pnr.json and {PAGE}")
