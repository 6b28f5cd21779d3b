# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share. tb/python/package.sh runs them."""
import pathlib

import castray
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "scenes"
ONE_LANE = {"lanes": 1, "ports": 1, "l2_kbytes": 0}   # the core that most tests share: quick to simulate


@pytest.fixture(scope="module")
def core():
    with castray.Core(sim=True, **ONE_LANE) as core:
        yield core


@pytest.fixture(scope="module")
def teapot():
    return castray.compile(SCENES / "teapot.json", size=(80, 60))


@pytest.fixture(scope="module")
def cube():
    return castray.compile(SCENES / "cube.json", size=(40, 30))


def renders(core, image):
    """True if a core that went through something still draws what it should."""
    with castray.Core(sim=True, **ONE_LANE) as fresh:
        return (core.render(image).pixels == fresh.render(image).pixels).all()


def pytest_runtest_logreport(report):
    """A line for each test as GoogleTest has it, from which tools/run_tests.py counts."""
    if report.failed or report.when == "call" and report.passed:
        name, verdict = report.nodeid.rpartition("/")[2].replace(" ", "_"), "       OK" if report.passed else "  FAILED "
        print(f"\n[{verdict} ] {name} ({report.duration * 1000:.0f} ms)")


def pytest_sessionstart():
    print("[==========]")
