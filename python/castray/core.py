# SPDX-License-Identifier: Apache-2.0
"""The driver: jobs through the registers of a core and the buffers of its memory, and through nothing else.

It is the list *What a driver does* of docs/register-map.md, with numpy arrays in and out. What can be known
to be wrong is refused before a register is written; after whatever goes wrong the core is idle.
"""
import dataclasses
import time
import warnings

import numpy as np

from . import _layout as layout
from . import png
from .device import Device
from .errors import (ArgumentError, BufferSizeError, BusyError, HungError, ImageError, JobError, RayError, VersionError)
from .records import HIT, RAY
from .scene import image_of

MODES = {"bvh": 0, "bvh_root": 1 << layout.OptionRoot, "brute": 1 << layout.OptionBrute}
VERSION = layout.VersionMajor << 16 | layout.VersionMinor << 8 | layout.VersionPatch


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


def open_device(overlay, sim, options):
    if sim:
        if overlay is not None:
            raise ArgumentError("an overlay or sim=True, not both")
        from .simulation import Simulation
        return Simulation(**options)
    if isinstance(overlay, Device):
        if options:
            raise ArgumentError(f"a device takes no {', '.join(options)}")
        return overlay
    from .board import Board
    return Board(overlay, **options)


class Core:
    """A castray core.

    Core("castray_ultra96v2.bit")   loads that overlay under PYNQ; an Overlay that is loaded, or its castray IP, do as well
    Core()                          the same of the one castray_*.bit in this folder
    Core(sim=True)                  the simulated core; lanes, contexts, tile, ports, l2_kbytes, memory, stalls, seed choose which

    timeout: seconds after which a job counts as hung; None: for as long as it takes. interrupt: wait for it,
    or poll; None: whatever the device has.
    """

    def __init__(self, overlay=None, *, sim=False, timeout=30.0, interrupt=None, **options):
        self.timeout = timeout
        self._image = None
        self._buffers = {}
        self._lost = False
        self._device = open_device(overlay, sim, options)
        self._interrupt = self._device.has_interrupt if interrupt is None else interrupt
        if self._interrupt and not self._device.has_interrupt:
            raise ArgumentError(f"{self._device.description}: there is no interrupt to wait for; interrupt=False polls")
        self.info = self._identify()

    def _identify(self):
        read = self._device.read32
        version, parameters = read(layout.RegVersion), read(layout.RegParameters)
        if version != VERSION:
            raise VersionError(f"{self._device.description}: its version register holds 0x{version:08x} ({_version(version)}), this package is "
                               f"for 0x{VERSION:08x} ({_version(VERSION)}). Build the bitstream and install castray from the same sources")
        if parameters != layout.ImageParameters:
            raise VersionError(f"{self._device.description}: its parameter register holds 0x{parameters:08x}, this package is for "
                               f"0x{layout.ImageParameters:08x}. Build the bitstream and install castray from the same sources")
        if not read(layout.RegControl) >> layout.CtrlIdle & 1:
            raise BusyError(f"{self._device.description}: a job runs that this program did not start. Wait for it, or load the bitstream again")
        config = read(layout.RegConfig)
        return Info(_version(version), config & 0xff, config >> 8 & 0xff, config >> 16 & 0xff, parameters)

    description = property(lambda self: self._device.description)
    lanes = property(lambda self: self.info.lanes)
    version = property(lambda self: self.info.version)

    # ---- Jobs ----
    def load(self, scene, size=None):
        """Copies a scene to the core's memory, in place of the one before: an image, its bytes, a file. The image."""
        image = image_of(scene, size)
        self._usable()
        self._image = None
        buffer = self._reserve("image", image.bytes.size, layout.ImageAlign)
        buffer.data[:image.bytes.size] = image.bytes
        buffer.flush()
        self._image = image
        return image

    def render(self, scene=None, *, mode="bvh", hits=False, work=False, z_order=False, steps=0, window=None, size=None,
               frame=None, timeout=...):
        """Renders a scene, else the one that is loaded: a Frame.

        mode: bvh, bvh_root or brute. hits: the hit records too; work: with the nodes and tests of each ray in
        them. steps: nodes that a ray may visit. window: (x0, y0, x1, y1), only these pixels. frame: a buffer of
        allocate() that the core draws into, in place of one of the driver's own.
        """
        options = self._options(mode, work, steps) | z_order << layout.OptionZOrder
        image = self._scene(scene, size)
        if not image.has_frame:
            raise ImageError("the image was compiled for a list of rays and has no frame: compile the scene without origins")
        low, high = self._window(image, window)
        # Pixels outside the window are not written: they are black, and no hits.
        target = self._given("frame", frame, image.stride * image.height) if frame is not None else \
            self._cleared("frame", image.stride * image.height)
        records = self._cleared("hits", image.width * image.height * layout.HitBytes) if hits or work else None

        self._set_image(steps)
        self._set_pointer(layout.RegFrame, target.address)
        self._set(layout.RegFrameBytes, target.data.nbytes)
        self._set_hits(records)
        self._set(layout.RegFrameSize, image.width | image.height << 16)
        self._set(layout.RegWindowMin, low)
        self._set(layout.RegWindowMax, high)
        self._set(layout.RegOptions, options | (records is not None) << layout.OptionHits)
        counters = self._run(timeout)

        target.invalidate()
        met = None
        if records:
            records.invalidate()
            met = records.data[:image.width * image.height * layout.HitBytes].copy().view(HIT).reshape(image.height, image.width)
        return Frame(self._pixels(image, target), met, counters)

    def query(self, rays, scene=None, *, mode="bvh_root", work=False, steps=0, timeout=...):
        """The hits of a list of rays in a scene, else in the one that is loaded: Answers.

        rays: an array of RAY, as image.rays(origins, directions) makes them. mode: bvh_root (bvh is the same) or brute.
        """
        options = self._options(mode, work, steps) & ~(1 << layout.OptionRoot) | 1 << layout.OptionList
        rays = self._checked(rays)
        self._scene(scene, None)
        nbytes = len(rays) * layout.RayBytes
        asked = self._reserve("rays", nbytes, layout.BufferAlign)
        asked.data[:nbytes] = rays.view(np.uint8)
        asked.flush()
        records = self._cleared("hits", len(rays) * layout.HitBytes)

        self._set_image(steps)
        self._set_pointer(layout.RegRays, asked.address)
        self._set(layout.RegRayBytes, asked.data.nbytes)
        self._set(layout.RegRayCount, len(rays))
        self._set_hits(records)
        self._set(layout.RegOptions, options)
        counters = self._run(timeout)

        records.invalidate()
        return Answers(records.data[:len(rays) * layout.HitBytes].copy().view(HIT), counters)

    def counters(self):
        """The counters of the last job."""
        read = self._device.read32
        at = [layout.RegCounters + 8 * i for i in range(layout.Counters)]
        return {name: read(low) | read(low + 4) << 32 for name, low in zip(layout.COUNTERS, at)}

    # ---- Memory ----
    def allocate(self, nbytes):
        """A buffer that the core can draw into: render(frame=...). The caller frees it."""
        return self._device.allocate(nbytes)

    def _reserve(self, name, nbytes, align):
        """A buffer of the driver's own, kept from job to job while it is large enough."""
        buffer = self._buffers.get(name)
        if buffer is not None and buffer.data.nbytes < nbytes:
            self._buffers.pop(name).free()
            buffer = None
        if buffer is None:
            buffer = self._buffers[name] = self._device.allocate(nbytes)
        return _fits(f"the buffer of the {name}", buffer, nbytes, align)

    def _cleared(self, name, nbytes):
        buffer = self._reserve(name, nbytes, layout.BufferAlign)
        buffer.data[:] = 0
        if name == "hits":
            buffer.data[:nbytes].view(HIT)["prim"] = layout.NoHit
        buffer.flush()
        return buffer

    def _given(self, name, buffer, nbytes):
        if not all(hasattr(buffer, part) for part in ("address", "data", "invalidate")):
            raise ArgumentError(f"{name}: a buffer of Core.allocate() is needed, not {type(buffer).__name__}")
        return _fits(name, buffer, nbytes, layout.BufferAlign)

    # ---- Arguments, checked ----
    def _options(self, mode, work, steps):
        self._usable()
        if mode not in MODES:
            raise ArgumentError(f"mode {mode!r}: it is one of {', '.join(MODES)}")
        if not 0 <= steps < 1 << 24:
            raise ArgumentError(f"steps: {steps}, must be 0 (no limit) to 2^24 - 1")
        return MODES[mode] | bool(work) << layout.OptionWork

    def _scene(self, scene, size):
        if scene is not None:
            self.load(scene, size)
        elif self._image is None:
            raise ArgumentError("no scene is loaded: give one, or load() it before")
        elif size is not None and tuple(size) != (self._image.width, self._image.height):
            raise ArgumentError("size: give the scene with it, its image is made for the size of the frame")
        return self._image

    def _window(self, image, window):
        if window is None:
            return 0, 0
        try:
            x0, y0, x1, y1 = (int(side) for side in window)
        except (TypeError, ValueError):
            raise ArgumentError(f"window: (x0, y0, x1, y1) is needed, not {window!r}") from None
        if not (0 <= x0 < x1 <= image.width and 0 <= y0 < y1 <= image.height):
            raise ArgumentError(f"window {x0, y0, x1, y1}: empty, or not inside the frame of {image.width}x{image.height}")
        return x0 | y0 << 16, x1 | y1 << 16

    def _checked(self, rays):
        if not isinstance(rays, np.ndarray) or rays.dtype != RAY or rays.ndim != 1:
            got = f"{rays.dtype} of shape {rays.shape}" if isinstance(rays, np.ndarray) else type(rays).__name__
            raise RayError(f"rays: one row of castray.RAY records is needed, not {got}; image.rays(origins, directions) makes them")
        if not 1 <= len(rays) <= layout.MaxRays:
            raise RayError(f"{len(rays)} rays: a list has 1 to {layout.MaxRays}")
        flags = rays["flags"] >> layout.NumRayFlags
        if flags.any():
            raise RayError(f"ray {np.flatnonzero(flags)[0]} has a flag that is none")
        return np.ascontiguousarray(rays)

    # ---- Registers ----
    def _set(self, register, value):
        self._device.write32(register, int(value))

    def _set_pointer(self, register, address):
        self._set(register, address & 0xffffffff)
        self._set(register + 4, address >> 32)

    def _set_image(self, steps):
        self._set_pointer(layout.RegImage, self._buffers["image"].address)
        self._set(layout.RegImageBytes, self._buffers["image"].data.nbytes)
        self._set(layout.RegSteps, steps)

    def _set_hits(self, records):
        self._set_pointer(layout.RegHits, records.address if records else 0)
        self._set(layout.RegHitsBytes, records.data.nbytes if records else 0)

    # ---- A job from its start to its end ----
    def _run(self, timeout):
        timeout = self.timeout if timeout is ... else timeout
        deadline = None if timeout is None else time.monotonic() + timeout
        self._set(layout.RegIer, self._interrupt << layout.IsrDone)
        self._set(layout.RegGie, self._interrupt)
        self._set(layout.RegControl, 1 << layout.CtrlStart)
        try:
            self._wait(timeout, deadline)
        except BaseException:   # a KeyboardInterrupt too: the core must not go on writing
            self._stop()
            raise
        error = self._device.read32(layout.RegError)
        counters = self.counters()
        self._device.job_ended()
        if error != layout.ErrNone:
            meaning = layout.ERRORS.get(error, "not a code that this package knows")
            raise JobError(error, f"the core ended the job with error {error}, {meaning}. The core is idle; docs/register-map.md says more")
        return counters

    def _wait(self, timeout, deadline):
        if self._interrupt:
            came = self._device.wait_interrupt(timeout)
            self._set(layout.RegIsr, self._device.read32(layout.RegIsr))
            if not came:
                if not self._done():
                    raise HungError(f"{self.description}: no interrupt in {_seconds(timeout)}, and the job is not done. "
                                    "timeout= gives it longer")
                warnings.warn("the job is done, but no interrupt came; polling from now on. Is the interrupt wired?", RuntimeWarning, stacklevel=4)
                self._interrupt = False
                return
            deadline = time.monotonic() + 1   # done is set by then
        late = False
        while not late and not self._done():
            alive = self._device.pause()
            late = not alive or deadline is not None and time.monotonic() > deadline
            if late and not self._done():
                raise HungError(f"{self.description}: " + (f"the job is not done after {_seconds(timeout)}. timeout= gives it longer"
                                                           if alive else "the core does nothing any more, and the job is not done"))

    def _done(self):
        return self._device.read32(layout.RegControl) >> layout.CtrlDone & 1

    def _stop(self):
        """Idle again, whatever runs. Where that cannot be had, the buffers stay: the core may still write there."""
        self._set(layout.RegGie, 0)
        self._set(layout.RegIer, 0)
        idle = 1 << layout.CtrlIdle
        if not self._device.read32(layout.RegControl) & idle and not (self._device.reset() and self._device.read32(layout.RegControl) & idle):
            self._lost = True
            KEPT.append(self._buffers)
            warnings.warn("the core could not be brought to rest: load its bitstream again, with a new castray.Core(...)",
                          RuntimeWarning, stacklevel=5)

    def _usable(self):
        if self._lost:
            raise HungError("the core hangs since an earlier job: load its bitstream again, with a new castray.Core(...)")

    @staticmethod
    def _pixels(image, buffer):
        rows = buffer.data[:image.stride * image.height].reshape(image.height, image.stride)
        pixels = rows[:, :image.width * layout.PixelBytes].reshape(image.height, image.width, layout.PixelBytes)
        rgb = pixels[:, :, 2::-1] if image.frame["pixel_format"] == layout.PixelBgra8 else pixels[:, :, :3]
        return np.ascontiguousarray(rgb)

    # ---- The end ----
    def close(self):
        """Gives the driver's buffers back."""
        if not self._lost:
            for buffer in self._buffers.values():
                buffer.free()
        self._buffers = {}
        self._image = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


KEPT = []   # buffers that a core which hangs may still write to


def _fits(what, buffer, nbytes, align):
    if buffer.data.nbytes < nbytes:
        raise BufferSizeError(f"{what}: {buffer.data.nbytes} bytes, the job needs {nbytes}; Core.allocate({nbytes}) makes one")
    if buffer.address % align:
        raise BufferSizeError(f"{what}: it lies at 0x{buffer.address:x}, the core takes multiples of {align}")
    return buffer


def _version(word):
    return f"{word >> 16}.{word >> 8 & 0xff}.{word & 0xff}"


def _seconds(timeout):
    return "this time" if timeout is None else f"{timeout:g} s"
