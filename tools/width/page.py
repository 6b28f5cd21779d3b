# SPDX-License-Identifier: Apache-2.0
"""docs/width-study.md: the tables of the width study and its plot."""
import pathlib

import matplotlib
matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402

import points  # noqa: E402

PAGE = pathlib.Path("docs/width-study.md")
PLOT = pathlib.Path("docs/pictures/width_study.png")
VIEWS = ("teapot", "teapot_tight", "teapot_interior", "spheres")
AXES = {"together": "total bits, 16 of them integer", "coordinates": "bits of a position", "shear": "bits of Sx, Sy",
        "hit divider": "bits of u, v", "shear divider": "bits of the shear divider's operands"}


def lane_dsps(widths):
    return sum(points.dsps(widths)[unit] for unit in points.LANE)


def mark(point):
    """Whether a point is what the core has, or may have."""
    return "**as it is**" if not point["widths"] else "yes" if points.legal(point["widths"]) else "no"


def error_table(found):
    textbook = found[0]["curve"] in ("together", "coordinates")
    head = ["bits", "wrong pixels: base", "tight", "inside", "spheres", "PSNR, dB: base", "tight", "inside", "spheres", "cracks"]
    head += ["textbook: wrong pixels", "rays lost", "doubled"] if textbook else []
    head += ["DSPs of a lane", "of the ray setup", "RTL"]
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    for p in found:
        f = p["found"]
        row = [p["label"]] + [f"{f['views'][v]['wrong']:,}" for v in VIEWS] + [f"{f['views'][v]['psnr']:.1f}" for v in VIEWS]
        row += [f"{f['none'] + f['several']:,}"]
        if textbook:
            row += [f"{f['textbook']['wrong']:,}", f"{f['textbook']['none']:,}", f"{f['textbook']['several']:,}"]
        row += [str(lane_dsps(p["widths"])), str(points.dsps(p["widths"])["camera/ray_setup"]), mark(p)]
        lines.append("| " + " | ".join(row) + " |")
    return lines


def work_table(found):
    base = next(p for p in found if not p["widths"])["found"]["views"]
    lines = ["| bits | nodes of the frame: base | tight | inside | spheres | tests of primitives, all four | hits that differ from brute force | DSPs of a lane | RTL |",
             "|---" * 9 + "|"]
    for p in found:
        views = p["found"]["views"]
        more = [f"{views[v]['nodes']:,} ({100 * (views[v]['nodes'] / base[v]['nodes'] - 1):+.2f}%)" for v in VIEWS]
        tests = sum(views[v]["tests"] for v in VIEWS)
        lines.append("| " + " | ".join([p["label"], *more, f"{tests:,}", str(sum(v["differ"] for v in views.values())),
                                        str(lane_dsps(p["widths"])), mark(p)]) + " |")
    return lines


def rtl_tables(rtl):
    lines = []
    for label, entry in rtl.items():
        w = entry["widths"]
        lines += [f"**{label}**: CoordW {w['CoordW']}, ShearFrac {w['ShearFrac']}, BaryFrac {w['BaryFrac']}, HitDivW {w['HitDivW']}, ShearDivW {w['ShearDivW']}.",
                  "", "| unit, synthesised flat | DSP | from its operands | LUT | FF |", "|---|---|---|---|---|"]
        lines += [f"| {unit} | {c['dsp']} | {points.dsps(w).get(unit, 0)} | {c['lut']:,} | {c['ff']:,} |" for unit, c in entry["units"].items()]
        total = {k: sum(c[k] for c in entry["units"].values()) for k in ("dsp", "lut", "ff")}
        lines += [f"| together | {total['dsp']} | | {total['lut']:,} | {total['ff']:,} |", ""]
        if "frames" not in entry:
            lines += ["Frames of it were not rendered in this run.", ""]
            continue
        lines += ["| frame on a core of one lane, equal to the model's in every pixel and raw hit | cycles |", "|---|---|"]
        lines += [f"| {scene}, {mode}, {size} | {cycles:,} |" for scene, mode, size, cycles in entry["frames"]] + [""]
    return lines


def plot(results):
    plt.rcParams.update({"font.size": 8})
    figure, rows = plt.subplots(3, len(AXES) + 1, figsize=(17, 7.5), sharex="col")
    curves = {curve: [p for p in results["points"] if p["curve"] == curve] for curve in [*AXES, "reciprocal"]}
    for column, (curve, found) in enumerate(curves.items()):
        bits = [p["bits"] for p in found]
        rows[0][column].set_title(curve)
        rows[2][column].step(bits, [lane_dsps(p["widths"]) for p in found], "k", where="mid", label="DSPs of a lane")
        rows[2][column].set_ylim(-2, 130)
        for row in rows:   # the core as it is; together it has 22 to 26 fraction bits
            row[column].axvline(next((p["bits"] for p in found if not p["widths"]), 38), color="0.8", zorder=0)
    for column, (curve, axis) in enumerate(AXES.items()):
        found = curves[curve]
        bits = [p["bits"] for p in found]
        for view in VIEWS:
            rows[0][column].plot(bits, [p["found"]["views"][view]["wrong"] for p in found], "o-", ms=3, lw=1, label=view)
            rows[1][column].plot(bits, [p["found"]["views"][view]["psnr"] for p in found], "o-", ms=3, lw=1)
        if curve in ("together", "coordinates"):
            rows[0][column].plot(bits, [p["found"]["textbook"]["wrong"] for p in found], "k:", lw=1, label="textbook test, base")
        rows[2][column].plot(bits, [p["found"]["none"] + p["found"]["several"] for p in found], "r.", label="cracks")
        rows[0][column].set_yscale("symlog", linthresh=1)
        rows[0][column].set_ylim(bottom=-0.1)
        rows[2][column].set_xlabel(axis)
    boxes = curves["reciprocal"]
    base = next(p for p in boxes if not p["widths"])["found"]["views"]
    for view in VIEWS:
        bits = [p["bits"] for p in boxes]
        rows[0][-1].plot(bits, [p["found"]["views"][view]["differ"] for p in boxes], "o-", ms=3, lw=1)
        rows[1][-1].plot(bits, [100 * (p["found"]["views"][view]["nodes"] / base[view]["nodes"] - 1) for p in boxes], "o-", ms=3, lw=1)
    rows[0][-1].set_ylim(-0.1, 10)
    rows[0][-1].set_ylabel("hits not those of brute force")
    rows[1][-1].set_ylabel("nodes visited, % more")
    rows[2][-1].set_xlabel("bits of 1 / |S|, for the test of boxes")
    for row, name in zip(rows, ("wrong pixels of 76,800", "PSNR, dB", "DSPs; cracks")):
        row[0].set_ylabel(name)
    rows[0][1].legend(fontsize=6)
    rows[2][0].legend(fontsize=6)
    figure.tight_layout()
    figure.savefig(PLOT, metadata={"Software": None})


def write(results):
    text = PAGE.read_text()
    curves = list(dict.fromkeys(p["curve"] for p in results["points"]))
    tables = {curve: [p for p in results["points"] if p["curve"] == curve] for curve in curves}
    for curve, found in tables.items():
        text = between(text, curve, work_table(found) if curve in ("reciprocal", "ticks") else error_table(found))
    if "rtl" in results:
        text = between(text, "rtl", rtl_tables(results["rtl"]))
    PAGE.write_text(text)
    plot(results)
    print(f"wrote {PAGE} and {PLOT}")


def between(text, name, lines):
    before, rest = text.split(f"<!-- table: {name} -->\n")
    return f"{before}<!-- table: {name} -->\n" + "\n".join(lines) + f"\n<!-- end: {name} -->" + rest.split(f"<!-- end: {name} -->")[1]
