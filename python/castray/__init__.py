# SPDX-License-Identifier: Apache-2.0
"""castray, a ray-tracing core: on the board under PYNQ, or simulated (docs/python.md).

    core = castray.Core("castray_ultra96v2.bit")   # on the board
    core = castray.Core(sim=True)                  # anywhere
    frame = core.render("scenes/teapot.json", hits=True)
    frame.pixels, frame.hits, frame.counters["cycles"]
"""
from . import _layout
from .core import Core
from .errors import *  # noqa: F401, F403
from .image import SceneImage
from .rays import ray_records
from .records import HIT, RAY
from .results import Answers, Frame
from .scene import compile

NO_HIT = _layout.NoHit    # a hit record's prim where nothing was hit
ANY_HIT = _layout.AnyHit  # where a ray that asked for any hit has one
__version__ = f"{_layout.VersionMajor}.{_layout.VersionMinor}.{_layout.VersionPatch}"
__all__ = ["ANY_HIT", "Answers", "Core", "Frame", "HIT", "NO_HIT", "RAY", "SceneImage", "compile", "ray_records"]
