# SPDX-License-Identifier: Apache-2.0
"""castray in a bitstream, under PYNQ, as a Device. Importing this module registers the driver of the IP."""
import asyncio
import pathlib
import time
import warnings

import numpy as np

from . import _layout as layout
from .device import Buffer, Device
from .errors import ArgumentError, NoBoardError, NoMemoryError, NoOverlayError

try:
    import pynq
except ImportError:
    pynq = None

WORDS = 1 << layout.RegAddrW   # bytes of the register space


class BoardBuffer(Buffer):
    """Physically contiguous memory of pynq.allocate."""

    def __init__(self, nbytes, target):
        if nbytes < 1:
            raise ArgumentError(f"a buffer of {nbytes} bytes")
        try:
            self._memory = pynq.allocate(shape=(nbytes,), dtype="u1", target=target)
        except (RuntimeError, MemoryError, OSError) as error:
            raise NoMemoryError(f"no contiguous memory for a buffer of {nbytes} bytes ({error}): close() what is not needed, "
                                "or give Linux more (kernel parameter cma=)") from error
        self.address = self._memory.device_address
        self.data = np.asarray(self._memory)   # a plain array: what is copied from it is no buffer

    def flush(self):
        self._memory.flush()

    def invalidate(self):
        self._memory.invalidate()

    def free(self):
        self.data = None
        self._memory.freebuffer()


if pynq is not None:
    class CastrayIP(pynq.DefaultIP):
        """The core in an overlay: overlay.castray, by its name in the block design. castray.Core(overlay) drives it."""
        bindto = [layout.VLNV]


class Board(Device):
    """What castray.Core takes for a board: a bitstream, a loaded pynq.Overlay, or the IP of one."""

    timeout = 30.0

    def __init__(self, overlay, download=True):
        if pynq is None:
            raise NoBoardError("PYNQ is not installed here. On the board's own image it is; elsewhere castray.Core(sim=True) "
                               "simulates the core")
        self._overlay = None
        self._ip = overlay if isinstance(overlay, pynq.DefaultIP) else self._find(overlay, download)
        if not isinstance(self._ip, CastrayIP):
            raise NoOverlayError(f"the IP is a {type(self._ip).__name__}, not {layout.VLNV}")
        if self._ip.mmio.length < WORDS:
            raise NoOverlayError(f"castray's registers take {WORDS} bytes, the overlay maps {self._ip.mmio.length}: "
                                 "build it with `make bitstream`")
        self.description = f"castray at 0x{self._ip.mmio.base_addr:x}"
        self._pin = getattr(self._ip, "interrupt", None)

    def _find(self, overlay, download):
        """The IP of an overlay, loaded if it is a file's name; of None: of the one bitstream that is here."""
        if overlay is None or isinstance(overlay, (str, pathlib.Path)):
            _need_board()
            overlay = self._load(pathlib.Path(overlay) if overlay is not None else _bitstream_here(), download)
        self._overlay = overlay
        try:
            names = [name for name, ip in overlay.ip_dict.items() if ip["type"] == layout.VLNV]
        except (AttributeError, TypeError, KeyError):
            raise ArgumentError("a bitstream's name, a pynq.Overlay or its castray IP is needed, "
                                f"not {type(overlay).__name__}; sim=True simulates the core") from None
        if not names:
            found = ", ".join(sorted({ip["type"] for ip in overlay.ip_dict.values()})) or "no IP at all"
            raise NoOverlayError(f"the overlay holds no {layout.VLNV}, but {found}: build it with `make bitstream`")
        ip = overlay
        for part in names[0].split("/"):   # inside a hierarchy of the block design
            ip = getattr(ip, part)
        return ip

    @staticmethod
    def _load(path, download):
        for file in (path, path.with_suffix(".hwh")):
            if not file.is_file():
                raise NoOverlayError(f"{file}: there is no such file. `make bitstream BOARD=ultra96v2` builds a .bit and a .hwh "
                                     "of one name, which belong side by side")
        try:
            return pynq.Overlay(str(path.resolve()), download=download)
        except Exception as error:   # PYNQ's own are of many types
            raise NoOverlayError(f"{path}: PYNQ cannot load it: {error}") from error

    def read32(self, offset):
        return int(self._ip.read(offset))

    def write32(self, offset, value):
        self._ip.write(offset, value)

    def allocate(self, nbytes):
        return BoardBuffer(nbytes, self._ip.device)

    @property
    def has_interrupt(self):
        """Where an event loop runs already, as in a notebook, its thread cannot wait for an interrupt: it polls."""
        return self._pin is not None and not _loop_runs()

    def wait_interrupt(self, seconds):
        async def wait():
            await asyncio.wait_for(self._pin.wait(), seconds)
        try:
            asyncio.get_event_loop_policy().get_event_loop().run_until_complete(wait())
        except asyncio.TimeoutError:
            self._pin.waiting = False
            return False
        return True

    def pause(self):
        time.sleep(50e-6)
        return True

    def reset(self):
        """Loads the bitstream again: the core has no other reset that software reaches."""
        if self._overlay is None:
            return False
        try:
            self._overlay.download()
        except Exception:   # PYNQ's own are of many types; what is lost is said by the caller
            return False
        return True


def _need_board():
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)   # that there is no device: said below
            pynq.Device.active_device
    except RuntimeError as error:
        raise NoBoardError(f"PYNQ finds no board here ({error}): run this on the Ultra96, as root; elsewhere "
                           "castray.Core(sim=True) simulates the core") from error


def _bitstream_here():
    files = sorted(pathlib.Path().glob("castray_*.bit"))
    if len(files) != 1:
        raise NoOverlayError(f"which bitstream? There are {len(files)} files castray_*.bit in {pathlib.Path().resolve()}; name one, as in "
                             "castray.Core(\"castray_ultra96v2.bit\")")
    return files[0]


def _loop_runs():
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return False
    return True
