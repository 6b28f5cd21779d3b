# SPDX-License-Identifier: Apache-2.0
"""Area: LUT cells that share a LUT of the device (tools/synth/sites.py), and budgets (tools/synth/synth.py)."""
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/synth"))
import sites  # noqa: E402
import synth  # noqa: E402


def netlist(*cells):
    """The text of a module: cells as (type, inputs, output)."""
    lines = []
    for number, (kind, inputs, output) in enumerate(cells):
        names = ["I"] if kind == "INV" else ["CI", "CYINIT", "DI", "S"] if kind == "CARRY4" else [f"I{i}" for i in range(len(inputs))]
        lines += [f"  cell \\{kind} $c{number}", *(f"    connect \\{n} {net}" for n, net in zip(names, inputs)), f"    connect \\O {output}", "  end"]
    return lines


class Sites(unittest.TestCase):
    def count(self, *cells):
        return sites.count(netlist(*cells))

    def test_two_small_ones_share_a_lut(self):
        self.assertEqual(self.count(("LUT3", ["\\a", "\\b", "\\c"], "\\x"), ("LUT2", ["\\d", "\\e"], "\\y")), 1)

    def test_six_inputs_between_two_take_two(self):
        self.assertEqual(self.count(("LUT3", ["\\a", "\\b", "\\c"], "\\x"), ("LUT3", ["\\d", "\\e", "\\f"], "\\y")), 2)

    def test_a_shared_net_counts_once(self):
        self.assertEqual(self.count(("LUT3", ["\\a", "\\b", "\\c"], "\\x"), ("LUT3", ["\\d", "\\e", "\\c"], "\\y")), 1)

    def test_five_inputs_share_with_what_they_hold(self):
        five = ("LUT5", ["\\a [0]", "\\a [1]", "\\a [2]", "\\a [3]", "\\a [4]"], "\\x")
        self.assertEqual(self.count(five, ("LUT2", ["\\a [4]", "\\a [0]"], "\\y")), 1)
        self.assertEqual(self.count(five, ("LUT2", ["\\a [4]", "\\b"], "\\y")), 2)

    def test_a_lut6_stands_alone(self):
        six = ("LUT6", [f"\\a [{i}]" for i in range(6)], "\\x")
        self.assertEqual(self.count(six, ("LUT2", ["\\a [0]", "\\a [1]"], "\\y")), 2)

    def test_what_drives_a_carry_or_a_wide_multiplexer_stands_alone(self):
        pair = [("LUT2", ["\\a", "\\b"], "\\s [0]"), ("LUT2", ["\\a", "\\b"], "\\y")]
        self.assertEqual(self.count(*pair), 1)
        self.assertEqual(self.count(*pair, ("CARRY4", ["1'0", "1'0", "\\d", "{ \\s [3:1] \\s [0] }"], "\\o")), 2)
        self.assertEqual(self.count(*pair, ("MUXF7", ["\\s [0]", "\\y", "\\sel"], "\\o")), 2)

    def test_an_inverter_is_a_function(self):
        self.assertEqual(self.count(("INV", ["\\a"], "\\x"), ("INV", ["\\b"], "\\y"), ("INV", ["\\c"], "\\z")), 2)

    def test_pairs_are_disjoint_and_fit(self):
        rng = random.Random(1)
        free = [frozenset(rng.sample(range(400), rng.randint(1, 5))) for _ in range(2000)]
        pairs = sites.pairs(free)
        self.assertEqual(len({i for pair in pairs for i in pair}), 2 * len(pairs))
        self.assertTrue(all(len(free[a] | free[b]) <= 5 for a, b in pairs))
        self.assertEqual(pairs, sites.pairs(free))
        self.assertGreater(len(pairs), 500)


class Budgets(unittest.TestCase):
    budget = {"dsp": 4, "bram36": 1.5, "lut": 100, "lut_cells": 120, "ff": 200}

    def test_what_was_measured_is_within(self):
        self.assertEqual(synth.over({"u": self.budget}, {"u": self.budget}), [])

    def test_each_overrun_is_named(self):
        for resource, most in {"dsp": 4, "bram36": 1.5, "lut": 120, "lut_cells": 142, "ff": 216}.items():
            self.assertEqual(synth.over({"u": self.budget | {resource: most}}, {"u": self.budget}), [])
            (line,) = synth.over({"u": self.budget | {resource: most + 0.5}}, {"u": self.budget})
            self.assertIn(f"u: {resource}", line)

    def test_a_unit_without_budget_and_a_budget_without_unit(self):
        self.assertEqual(len(synth.over({"new": self.budget}, {"old": self.budget})), 2)

    def test_a_resource_without_budget(self):
        (line,) = synth.over({"u": self.budget}, {"u": {k: v for k, v in self.budget.items() if k != "lut_cells"}})
        self.assertIn("lut_cells", line)


if __name__ == "__main__":
    unittest.main()
