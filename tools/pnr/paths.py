# SPDX-License-Identifier: Apache-2.0
"""The worst path of a report of nextpnr, in words."""
import collections
import re

# What synthesis and packing add to the name of a register or a memory.
ADDED = re.compile(r"(_(TRELLIS_FF|TRELLIS_DPR16X4|DP16KD|PDPW16KD|MULT18X18D|LUT4|PFUMX|L6MUX21|CCU2C)_[A-Z].*|\$[A-Z].*|(\.\d+)+(_?[A-Z]{2,3}\d*)?)$")
MEMORIES = {"DO": "block RAM", "AD": "block RAM", "DI": "block RAM"}


def plain(cell):
    """The name of a cell as it is in the RTL: the unit's own, not the wrapper's."""
    name = ADDED.sub("", ADDED.sub("", cell))
    return {"rst_q": "rst_ni"}.get(name, name.removeprefix("u.").split(":")[0])


def kind(step):
    """What a signal passes in one step."""
    cell, out = step["from"]["cell"], step["to"]["port"]
    if re.fullmatch(r"P\d+", out):
        return "multiplier"
    if out == "FCO" or step["from"]["port"] == "FCI":
        return "carry chain"
    if "DPRAM" in cell or "DPR16X4" in cell:
        return "LUT memory"
    return "wide mux" if out.startswith("OFX") else "LUT"


def through(steps):
    """{kind: number} of what is between the registers; a carry chain counts once, where it is entered."""
    entered = (s for s in steps if s["type"] == "logic" and s["from"]["port"] != "FCI")
    return dict(collections.Counter(kind(s) for s in entered))


def end(step_end):
    """A register by its name, with what it is where it is no flip-flop."""
    port = re.sub(r"\d+$", "", step_end["port"])
    what = next((text for head, text in MEMORIES.items() if port in (head + "A", head + "B", "WEA", "WEB", "CEA", "CEB", "OCEA", "OCEB")), None)
    if "RAMW" in step_end["cell"] or port in ("WCK", "WRE", "WD", "WAD"):
        what = "LUT memory"
    return plain(step_end["cell"]) + (f" ({what})" if what else "")


def worst(report):
    """{from, to, through, ns, routing_ns} of the path that decides the clock."""
    clock = max(report["fmax"], key=lambda name: "clk" in name)
    path = next(p["path"] for p in report["critical_paths"] if p["from"] == p["to"] == f"posedge {clock}")
    return {"from": end(path[0]["from"]), "to": end(path[-1]["to"]), "through": through(path),
            "ns": round(sum(s["delay"] for s in path), 2),
            "routing_ns": round(sum(s["delay"] for s in path if s["type"] == "routing"), 2)}


def mhz(report):
    return round(min(entry["achieved"] for entry in report["fmax"].values()), 1)
