# SPDX-License-Identifier: Apache-2.0
"""The points of the width study: on each curve some widths change, all others are as rtl/pkg/castray_cfg_pkg.sv has them.

The report's notation is (total bits, integer bits), the sign's among them. A position that needs CoordW bits of a teapot's
scene, 16 units wide, has CoordW - 4 fraction bits; with 16 integer bits, as the report's, it is (CoordW + 12, 16).
"""
import dataclasses
import re

import set_widths

INTEGER = 16                 # bits, as the report's
SCENE = 4                    # of them those that a teapot's scene needs


@dataclasses.dataclass
class Point:
    curve: str
    label: str               # in the report's notation where it is a format
    bits: int                # on the plot's axis
    widths: dict

    @property
    def name(self):
        """Of the folder under build/width."""
        return "".join(f"{n}{v}" for n, v in self.widths.items()) or "default"


def defaults():
    text = set_widths.PACKAGE.read_text()
    return {n: int(v) for n, v in re.findall(r"unsigned (CoordW|ShearFrac|BaryFrac|HitDivW|ShearDivW|RecipW|SubPlane|TFrac) *= (\d+);", text)}


def together(total):
    """Positions, shear, u and v with the fraction bits of the report's (total, 16), and dividers as wide as these need."""
    fraction = total - INTEGER
    return {"CoordW": fraction + SCENE, "ShearFrac": fraction, "BaryFrac": fraction, "HitDivW": fraction + 2, "ShearDivW": fraction + 6}


def points():
    usual = defaults()

    def changed(**widths):
        return {n: v for n, v in widths.items() if v != usual[n]}

    out = []
    for total in (24, 28, 32, 36, 38, 40, 44, 48):
        out.append(Point("together", f"({total},{INTEGER})", total, changed(**together(total))))
    for coord in (14, 16, 18, 20, 22, 24, 26, 28, 32, 36):
        out.append(Point("coordinates", f"({coord + INTEGER - SCENE},{INTEGER})", coord, changed(CoordW=coord)))
    for shear in (8, 10, 12, 14, 16, 17, 18, 20, 22, 24, 26, 28, 32):
        out.append(Point("shear", f"({shear + 1},1)", shear + 1, changed(ShearFrac=shear, ShearDivW=max(usual["ShearDivW"], shear + 6))))
    for bary in (8, 10, 12, 14, 16, 20, 24, 28, 32):
        out.append(Point("hit divider", f"({bary + 1},1)", bary + 1, changed(BaryFrac=bary, HitDivW=bary + 2)))
    for operand in (18, 20, 22, 24, 26, 28, 32, 40):
        out.append(Point("shear divider", str(operand), operand, changed(ShearDivW=operand)))
    return out


def slab_points():
    usual = defaults()
    out = [Point("reciprocal", str(r), r, {} if r == usual["RecipW"] else {"RecipW": r}) for r in (10, 11, 12, 14, 16, 17, 18, 20)]
    out += [Point("ticks", str(s), s, {} if s == usual["SubPlane"] else {"SubPlane": s}) for s in (2, 3, 4, 5, 6)]
    return out


def rtl_points():
    """What the RTL is built for."""
    return [p for p in points() if p.curve == "together" and p.bits in (32, 36)] + [Point("together", "as it is", 38, {})]


def legal(widths):
    """May the RTL have these? As math/width_check."""
    w = defaults() | widths
    return (20 <= w["CoordW"] <= 26 and 16 <= w["ShearFrac"] <= 26 and 12 <= w["BaryFrac"] <= 24 and w["BaryFrac"] + 2 <= w["HitDivW"] <= 26
            and w["ShearFrac"] + 2 <= w["ShearDivW"] <= 45 and 2 <= w["SubPlane"] <= 6 and w["RecipW"] == 17)


def dsp(a, b):
    """DSPs for a signed product of a x b bits: each takes 27 x 18, so all but the last part of an operand 26 or 17 bits of it."""
    def parts(x, y):
        return -(-max(x - 1, 1) // 26) * -(-max(y - 1, 1) // 17)
    return min(parts(a, b), parts(b, a))


def unsigned_dsp(a, b, out):
    """Of a product cut to its lower `out` bits; a short one is made of LUTs."""
    return 0 if min(a, b) < 2 or min(a + b, out) < 9 else -(-min(a, b) // 17) * -(-max(a, b) // 26)


def division(den, fraction):
    """Of math/div_pair: the table's guess, three products with it, the two steps, and the two checks."""
    middle, above = max(fraction + 2, 18) - 17, max(den - 26, 0)
    low = den + 2
    guess = 1 + 3 * (1 + (unsigned_dsp(above, 17, 64) if above else 0))
    check = 1 + unsigned_dsp(middle, min(den, low - 17), low - 17) + (unsigned_dsp(min(17, low - 26), above, low - 26) if above else 0)
    return guess + 2 + 2 * check


def dsps(widths):
    """By unit, from the operands of its products."""
    w = defaults() | widths
    position, shear, quotient, recip = w["CoordW"] + 1, w["ShearFrac"] + 1, w["BaryFrac"] + 2, w["RecipW"] + 1
    return {
        "isect/ray_prim": 6 * dsp(position, shear) + 4 * dsp(position, position) + 4 * dsp(position, max(position, shear)),
        "isect/hit_unit": 2 * dsp(position, quotient) + division(w["HitDivW"], w["BaryFrac"]),
        "isect/node_pipe": 4 * dsp(position, recip) + 16,
        "camera/ray_setup": 2 * dsp(shear, shear) + division(w["ShearDivW"], w["ShearFrac"]),
    }


LANE = ("isect/ray_prim", "isect/hit_unit", "isect/node_pipe")   # what each lane has; ray_setup is shared
