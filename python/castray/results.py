# SPDX-License-Identifier: Apache-2.0
"""What a core answers."""
import dataclasses

import numpy as np

from . import png


@dataclasses.dataclass(frozen=True)
class Info:
    """What the registers say of a core."""
    version: str
    lanes: int
    contexts: int     # rays in flight in each lane
    tile: int         # side of a tile in pixels
    parameters: int   # the widths that images must be for


@dataclasses.dataclass(frozen=True)
class Frame:
    """A rendered frame; a notebook shows it as its picture."""
    pixels: np.ndarray   # (height, width, 3) uint8: R, G, B
    hits: np.ndarray     # (height, width) of HIT, None unless asked for
    counters: dict

    cycles = property(lambda self: self.counters["cycles"])

    def _repr_png_(self):
        return png.encode(self.pixels)

    def __repr__(self):
        height, width, _ = self.pixels.shape
        return f"<castray.Frame: {width}x{height}, {self.cycles} cycles{'' if self.hits is None else ', with hits'}>"


@dataclasses.dataclass(frozen=True)
class Answers:
    """What the rays of a list met, in their order."""
    hits: np.ndarray     # (rays,) of HIT
    counters: dict

    cycles = property(lambda self: self.counters["cycles"])

    def __repr__(self):
        return f"<castray.Answers: {len(self.hits)} rays, {self.cycles} cycles>"
