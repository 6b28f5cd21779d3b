#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The faults of tb/faults/*.json; run as a program: is there one for every RTL file, and can each be planted?

A fault is {"unit", "file", "old", "new", "why"}: in `file` the text `old`, which stands there exactly
once, becomes `new`, and the test of `unit` must fail. tb/faults/<folder>.json lists those of the units
of that folder. A file that has a test of its own is tried by that test, another by one that contains it.
Those of formal.json are for the proofs of tb/formal, which plant them themselves: tools/formal/prove.py.
"""
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def load(root=ROOT):
    """All faults, each with the list that it stands in."""
    return [dict(fault, listed=path.stem)
            for path in sorted((root / "tb/faults").glob("*.json")) for fault in json.loads(path.read_text())]


def test_of(root, unit):
    """What runs as the unit's test: the program that is built from it, a script or a proof; None: there is none."""
    if (root / f"tb/{unit}_proof.sv").exists():
        return f"tb/{unit}_proof.sv"
    if (root / f"tb/{unit}_test.cpp").exists():
        return f"build/unit/{unit}_test"
    return f"tb/{unit}.sh" if (root / f"tb/{unit}.sh").exists() else None


def unplantable(root, fault):
    """What is wrong with a fault, or None."""
    target = root / fault["file"]
    stands = target.read_text().count(fault["old"]) if target.exists() else 0
    if stands != 1:
        return f"the text stands {stands} times in {fault['file']}"
    if fault["old"] == fault["new"]:
        return "nothing is changed"
    if not test_of(root, fault["unit"]):
        return f"{fault['unit']} has no test"
    if fault["unit"].split("/")[0] != fault["listed"]:
        return f"its place is tb/faults/{fault['unit'].split('/')[0]}.json"
    return None


def uncovered(root, faults):
    """RTL files that no fault is planted in, or none that their own test must catch."""
    for line in (root / "rtl/castray.f").read_text().splitlines():
        if not line.startswith("rtl/") or line.startswith("rtl/pkg/"):
            continue
        units = {fault["unit"] for fault in faults if fault["file"] == line}
        own = line.removeprefix("rtl/").removesuffix(".sv")
        if not units:
            yield f"{line}: no fault is planted in it"
        elif test_of(root, own) and own not in units:
            yield f"{line}: none of its faults is for its own test, {own}"


def main():
    faults = load()
    wrong = list(uncovered(ROOT, faults))
    for fault in faults:
        problem = unplantable(ROOT, fault)
        if problem:
            wrong.append(f"tb/faults/{fault['listed']}.json, {fault['why']}: {problem}")
    print("\n".join(wrong + [f"{len(faults)} faults, {len(wrong)} problems"]))
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
