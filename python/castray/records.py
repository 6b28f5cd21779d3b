# SPDX-License-Identifier: Apache-2.0
"""Records in memory as numpy's structured types (docs/scene-image.md)."""
import numpy as np

from . import _layout


def record_dtype(name):
    size, fields = _layout.RECORDS[name]
    names, formats, offsets = zip(*fields)
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": size})


HEADER = record_dtype("image_header_t")
FRAME = record_dtype("frame_record_t")
RAY = record_dtype("ray_record_t")   # a ray of a list
HIT = record_dtype("hit_record_t")   # what a pixel's ray, or a ray of a list, met
