# SPDX-License-Identifier: Apache-2.0
"""What the package knows of registers and records is what C++ knows: both come from rtl/pkg."""
import re

import castray
from castray import _layout as layout
from conftest import ROOT

HEADER = (ROOT / "build/gen/castray_records.hpp").read_text()


def test_constants_are_those_of_the_header():
    theirs = {name: int(value) for name, value in re.findall(r"constexpr std::int64_t (\w+) = (-?\d+);", HEADER)}
    ours = {name: value for name, value in vars(layout).items() if isinstance(value, int)}
    assert len(theirs) > 150
    assert {name: ours.get(name) for name in theirs} == theirs


def test_error_codes_mean_the_same():
    theirs = re.findall(r'case (Err\w+): return "([^"]*)";', HEADER)
    assert len(theirs) > 10
    assert {getattr(layout, name): text for name, text in theirs} == layout.ERRORS


def test_counters_have_the_names_of_the_reports():
    names = (ROOT / "sim/counter_names.hpp").read_text()
    theirs = {getattr(layout, constant): name for constant, name in re.findall(r'\{(Cnt\w+), "(\w+)"\}', names)}
    assert theirs == dict(enumerate(layout.COUNTERS)) and len(theirs) == layout.Counters


def cpp_fields(record):
    """name -> (lowest bit, bits, signed) as each_field of the C++ struct has it."""
    text = HEADER.split(f"struct {record} ")[1].split("each_field(F&& f, int at = 0) {")[1].split("\n  }\n")[0]
    fields = {}
    for name, at, bits, signed in re.findall(r'f\(std::string_view\("(\w+)"\), \w+, at \+ (\d+), (\d+), (\w+)\)', text):
        fields[name] = int(at), int(bits), signed == "true"
    for name, at in re.findall(r'(\w+)\.each_field\(prefixed\("\w+\.", f\), at \+ (\d+)\)', text):   # a section_t
        for part, (low, bits, signed) in cpp_fields("section_t").items():
            fields[f"{name}.{part}"] = int(at) + low, bits, signed
    return fields


def test_records_have_the_fields_of_the_structs():
    for record, (size, fields) in layout.RECORDS.items():
        body = HEADER.split(f"struct {record} ")[1]
        assert int(re.search(r"kBits = (\d+)", body)[1]) == 8 * size
        ours = {name: (8 * at, 8 * int(kind[-1]), kind[-2] == "i") for name, kind, at in fields}
        assert ours == cpp_fields(record), record


def test_versions_and_the_vlnv():
    assert castray.__version__ == f"{layout.VersionMajor}.{layout.VersionMinor}.{layout.VersionPatch}"
    assert layout.VLNV == (ROOT / "fpga/ultra96/vlnv.txt").read_text().strip()


def test_the_page_lists_every_exception():
    page = (ROOT / "docs/python.md").read_text()
    table = set(re.findall(r"`(\w+Error)`", page.split("## What goes wrong")[1].split("##")[0]))
    ours = {name for name, value in vars(castray).items() if isinstance(value, type) and issubclass(value, castray.CastrayError)}
    assert table - {"castray.CastrayError"} == ours - {"CastrayError"}
