# SPDX-License-Identifier: Apache-2.0
"""The report's experiment: one ray and the 6,320 triangles of the teapot, against float64; and as the notebook."""
import json
import subprocess

import castray
import numpy as np
import pytest
from conftest import ROOT, SCENES
from notebook import executed

NOTEBOOK = ROOT / "python/examples/report_experiment.ipynb"
CLOCK_MHZ, REPORT_US = 100, 843
EYE, TARGETS = (5.439442, 11.080794, 10.381341), [(0.086994, 0.639098, -0.496275), (0, 2, 0), (-2, 1, 0.1), (3, 2.2, 0)]


def float64(target, tmp_path):
    """The reference's answer, by the program: it reads the scene, not the image."""
    rays = tmp_path / "ray.csv"
    rays.write_text("ox,oy,oz,dx,dy,dz\n" + ",".join(str(x) for x in (*EYE, *(np.array(target) - EYE))) + "\n")
    command = [ROOT / "build/castray", "query", SCENES / "teapot.json", rays, "--engine", "float64"]
    row = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()[1].split(",")
    return int(row[1]), float(row[2])


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("mode", ["brute", "bvh_root"])
def test_one_ray_against_float64(core, tmp_path, mode, target):
    expected, distance = float64(target, tmp_path)
    image = castray.compile(SCENES / "teapot.json")
    rays = image.rays(EYE, np.array(target) - EYE)
    answer = core.query(rays, image, mode=mode)
    print(f"\nIP Verification: {'PASS' if answer.hits['prim'][0] == expected else 'FAIL'}, triangle {expected}, {mode}: "
          f"{answer.cycles} cycles, {answer.cycles / CLOCK_MHZ:.2f} us at {CLOCK_MHZ} MHz, the report {REPORT_US} us")
    assert answer.hits["prim"][0] == expected
    assert image.distances(rays, answer.hits)[0] == pytest.approx(distance, rel=1e-6)
    assert answer.counters["tests"] == 6320 if mode == "brute" else answer.counters["tests"] < 50
    assert answer.cycles < REPORT_US * CLOCK_MHZ / (1 if mode == "brute" else 20)


def streams(notebook):
    return "".join("".join(output.get("text", "")) for cell in notebook["cells"] for output in cell.get("outputs", []))


def test_the_notebook_runs():
    notebook = executed(NOTEBOOK)
    text = streams(notebook)
    assert text.count("IP Verification: PASS") == 3 and "FAIL" not in text, text
    assert "843 us" in text and "6320 triangles" in text
    pictures = [output for cell in notebook["cells"] for output in cell.get("outputs", []) if "image/png" in output.get("data", {})]
    assert len(pictures) == 2


def test_the_notebook_was_executed_before_it_was_committed():
    assert streams(json.loads(NOTEBOOK.read_text())).count("IP Verification: PASS") == 3
