# SPDX-License-Identifier: Apache-2.0
"""The scene image: the bytes that a core reads (docs/scene-image.md), checked before they go there."""
import pathlib

import numpy as np

from . import _layout as layout
from .errors import ImageError
from .rays import distances, ray_records
from .records import FRAME, HEADER

SECTIONS = {"lines": layout.LineBytes, "attributes": layout.AttrBytes, "nodes": layout.NodeBytes}


class SceneImage:
    """An image from bytes or an array of them; ImageError unless it is one for this package's version."""

    def __init__(self, data):
        if not isinstance(data, np.ndarray):
            data = np.frombuffer(data, np.uint8)
        if data.dtype != np.uint8 or data.ndim != 1:
            raise ImageError(f"a scene image is one row of bytes (uint8), not {data.dtype} of shape {data.shape}")
        self.bytes = np.ascontiguousarray(data)
        if self.bytes.size < layout.HeaderBytes + layout.FrameBytes:
            raise ImageError(f"{self.bytes.size} bytes are no scene image: header and frame record alone have "
                             f"{layout.HeaderBytes + layout.FrameBytes}")
        self.header = self.bytes[:layout.HeaderBytes].view(HEADER)[0]
        self.frame = self.bytes[layout.HeaderBytes:][:layout.FrameBytes].view(FRAME)[0]
        self.warnings = []
        self._check()

    @classmethod
    def load(cls, path):
        """The image of a file that `castray compile` or save() wrote."""
        try:
            return cls(np.fromfile(path, np.uint8))
        except OSError as error:
            raise ImageError(f"{path}: cannot be read: {error.strerror}") from error
        except ImageError as error:
            raise ImageError(f"{path}: {error}") from None

    def save(self, path):
        self.bytes.tofile(pathlib.Path(path))

    def _check(self):
        h = self.header
        if h["magic"] != layout.ImageMagic:
            raise ImageError(f"no scene image: it begins with 0x{int(h['magic']):08x}, not 0x{layout.ImageMagic:08x}. "
                             "Make one with castray.compile, or the command `castray compile`")
        if h["version"] != layout.ImageVersion:
            raise ImageError(f"a scene image of version {h['version']}, this package reads {layout.ImageVersion}: compile the scene again")
        if h["parameters"] != layout.ImageParameters:
            raise ImageError(f"a scene image for the parameter set 0x{int(h['parameters']):08x}, this package and its core have "
                             f"0x{layout.ImageParameters:08x}: compile the scene with the same sources as the core")
        if h["image_bytes"] > self.bytes.size:
            raise ImageError(f"a scene image cut short: its header says {h['image_bytes']} bytes, {self.bytes.size} are there")
        for name, size in SECTIONS.items():
            offset, count = int(h[f"{name}.offset"]), int(h[f"{name}.count"])
            if count and (offset % layout.ImageAlign or not offset or offset + count * size > int(h["image_bytes"])):
                raise ImageError(f"the section {name} of the scene image lies outside it")
        if h["primitives"] > h["attributes.count"]:
            raise ImageError(f"a scene image of {h['primitives']} primitives with attributes for {h['attributes.count']}")
        if self.has_frame:
            self._check_frame()

    def _check_frame(self):
        f = self.frame
        if not all(1 <= int(f[side]) <= layout.MaxFrameSize for side in ("width", "height")):
            raise ImageError(f"a frame of {f['width']}x{f['height']}: each side must be 1 to {layout.MaxFrameSize}")
        if f["stride"] % layout.BufferAlign or f["stride"] < self.width * layout.PixelBytes:
            raise ImageError(f"rows of {f['stride']} bytes do not hold {f['width']} pixels, or are no multiple "
                             f"of {layout.BufferAlign}")
        if f["pixel_format"] > layout.PixelBgra8:
            raise ImageError(f"there is no pixel format {f['pixel_format']}")

    # ---- What it holds ----
    has_frame = property(lambda self: bool(self.frame["width"] or self.frame["height"]), doc="False: compiled for rays alone")
    width = property(lambda self: int(self.frame["width"]))
    height = property(lambda self: int(self.frame["height"]))
    stride = property(lambda self: int(self.frame["stride"]))
    primitives = property(lambda self: int(self.header["primitives"]))
    grid_power = property(lambda self: int(self.header["grid_power"]), doc="a grid step is 2^grid_power scene units")

    @property
    def corner(self):
        """The scene's corner in grid steps from the world's origin."""
        return np.array([self.header[f"corner_{axis}"] for axis in "xyz"], np.int64)

    # ---- Rays on its grid ----
    def rays(self, origins, directions, **options):
        """Records of rays in scene units, for Core.query: castray.ray_records on this image's grid."""
        return ray_records(self, origins, directions, **options)

    def distances(self, rays, hits):
        """Distances from the origins in scene units; inf for a miss, nan for an answer to `any_hit`."""
        return distances(self, rays, hits)

    def __repr__(self):
        frame = f"a frame of {self.width}x{self.height}" if self.has_frame else "no frame"
        return f"<castray.SceneImage: {self.primitives} primitives, {frame}, {self.bytes.size} bytes>"
