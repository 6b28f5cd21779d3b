# SPDX-License-Identifier: Apache-2.0
"""The buffers of a driver in its device's memory, kept from job to job while they are large enough."""
import numpy as np

from . import _layout as layout
from .errors import ArgumentError, BufferSizeError
from .records import HIT

KEPT = []   # of cores that hang: they may still write there


class Buffers:
    def __init__(self, device):
        self._device = device
        self._buffers = {}

    def filled(self, name, data, align=layout.BufferAlign):
        """One that holds these bytes, for the core to read."""
        buffer = self._reserve(name, data.nbytes, align)
        buffer.data[:data.nbytes] = data
        buffer.flush()
        return buffer

    def pixels(self, nbytes):
        """Black, for the core to write."""
        buffer = self._reserve("frame", nbytes)
        buffer.data[:] = 0
        buffer.flush()
        return buffer

    def hits(self, records):
        """Records of misses, for the core to write."""
        buffer = self._reserve("hits", records * layout.HitBytes)
        buffer.data[:] = 0
        buffer.data[:records * layout.HitBytes].view(HIT)["prim"] = layout.NoHit
        buffer.flush()
        return buffer

    def __getitem__(self, name):
        return self._buffers[name]

    def _reserve(self, name, nbytes, align=layout.BufferAlign):
        buffer = self._buffers.get(name)
        if buffer is not None and buffer.data.nbytes < nbytes:
            self._buffers.pop(name).free()
            buffer = None
        if buffer is None:
            buffer = self._buffers[name] = self._device.allocate(nbytes)
        return fits(f"the buffer of the {name}", buffer, nbytes, align)

    def keep(self):
        """They are never given back."""
        KEPT.append(self._buffers)
        self._buffers = {}

    def free(self):
        for buffer in self._buffers.values():
            buffer.free()
        self._buffers = {}


def records_of(buffer, count):
    """Hit records that the core wrote, byte for byte."""
    buffer.invalidate()
    return buffer.data[:count * layout.HitBytes].copy().view(HIT)


def fits(what, buffer, nbytes, align=layout.BufferAlign):
    """The buffer, if the core can take it for so many bytes."""
    if not all(hasattr(buffer, part) for part in ("address", "data", "invalidate")):
        raise ArgumentError(f"{what}: a buffer of Core.allocate() is needed, not {type(buffer).__name__}")
    if buffer.data.dtype != np.uint8 or buffer.data.nbytes < nbytes:
        raise BufferSizeError(f"{what}: {buffer.data.nbytes} bytes, the job needs {nbytes}; Core.allocate({nbytes}) makes one")
    if buffer.address % align:
        raise BufferSizeError(f"{what}: it lies at 0x{buffer.address:x}, the core takes multiples of {align}")
    return buffer
