# SPDX-License-Identifier: Apache-2.0
"""Clocks: a unit slower than its budget fails `make pnr-check` (tools/pnr/pnr.py); placed with the tools themselves."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "tools" / folder) for folder in ("pnr", "synth")]
import pnr  # noqa: E402
import yosys  # noqa: E402

UNIT, FILE = "prim/credit", pathlib.Path("rtl/prim/credit.sv")
PLANTED = ("counted = used +", "counted = CntW'(32'(used) % 32'd7 * 32'(used) % 32'd5) +")   # dividers before the register


class Budgets(unittest.TestCase):
    kept = {"u": {"mhz": 90.0, "bar": 100, "seed": 1}}

    def test_equal_and_a_little_slower_are_within(self):
        for mhz in (90.0, 95.0, 90.0 * pnr.ROOM):
            self.assertEqual(pnr.slower([{"name": "u", "mhz": mhz}], self.kept), [])

    def test_slower_and_not_placed_are_named(self):
        for mhz in (90.0 * pnr.ROOM - 0.1, 0):
            (line,) = pnr.slower([{"name": "u", "mhz": mhz}], self.kept)
            self.assertIn("u: ", line)


class Check(unittest.TestCase):
    def check(self, budgets, files=None):
        """What pnr-check says, and what it prints."""
        with contextlib.redirect_stdout(io.StringIO()) as out:
            return pnr.check(1, budgets, files), out.getvalue()

    def test_a_unit_that_got_slower_fails(self):
        measured = pnr.record(pnr.jobs_of([UNIT])[0])
        budgets = {UNIT: {name: measured[name] for name in ("key", "mhz", "bar", "seed")}}
        passes, said = self.check(budgets)
        self.assertTrue(passes, said)

        text = FILE.read_text()
        self.assertEqual(text.count(PLANTED[0]), 1)
        with tempfile.TemporaryDirectory(dir="build") as folder:
            slower = pathlib.Path(folder, FILE.name)
            slower.write_text(text.replace(*PLANTED))
            passes, said = self.check(budgets, [str(slower) if f == str(FILE) else f for f in yosys.rtl_files()])
        self.assertFalse(passes, said)
        self.assertIn(f"slower: {UNIT}: ", said)
        self.assertIn(f"changed since they were placed, `make pnr` places them: {UNIT}", said)


if __name__ == "__main__":
    unittest.main()
