# SPDX-License-Identifier: Apache-2.0
"""The driver: the list *What a driver does* of docs/register-map.md, with numpy arrays in and out.

It works through registers and buffers, and through nothing else. What can be known to be wrong is refused before a job
is started; after whatever goes wrong the core is idle.
"""
import numpy as np

from . import _layout as layout
from .buffers import Buffers, fits, records_of
from .device import Device
from .errors import ArgumentError, BusyError, ImageError, RayError, VersionError
from .job import Jobs
from .records import RAY
from .results import Answers, Frame, Info
from .scene import image_of, size_of

MODES = {"bvh": 0, "bvh_root": 1 << layout.OptionRoot, "brute": 1 << layout.OptionBrute}
VERSION = layout.VersionMajor << 16 | layout.VersionMinor << 8 | layout.VersionPatch
SAME_SOURCES = "Build the bitstream and install castray from the same sources"


class Core:
    """A castray core.

    Core("castray_ultra96v2.bit")   loads that overlay under PYNQ; an Overlay that is loaded, or its castray IP, do as well
    Core()                          the same of the one castray_*.bit in this folder
    Core(sim=True)                  the simulated core; lanes, contexts, tile, ports, l2_kbytes, memory, stalls, seed choose which

    timeout: seconds after which a job counts as hung, None for as long as it takes; by default 30 on the board, where the
    simulation sees for itself that nothing moves any more. interrupt: wait for it, or poll; None: whatever the device has.
    """

    def __init__(self, overlay=None, *, sim=False, timeout=..., interrupt=None, **options):
        self._device = _open(overlay, sim, options)
        self.timeout = self._device.timeout if timeout is ... else _seconds(timeout)
        if interrupt and not self._device.has_interrupt:
            raise ArgumentError(f"{self._device.description}: there is no interrupt to wait for; interrupt=False polls")
        self._jobs = Jobs(self._device, self._device.has_interrupt if interrupt is None else interrupt)
        self._buffers = Buffers(self._device)
        self._image = None
        self.info = self._identify()

    description = property(lambda self: self._device.description)
    lanes = property(lambda self: self.info.lanes)
    version = property(lambda self: self.info.version)

    def _identify(self):
        read, what = self._device.read32, self._device.description
        version, parameters = read(layout.RegVersion), read(layout.RegParameters)
        if version != VERSION:
            raise VersionError(f"{what}: its version register holds 0x{version:08x} ({_dotted(version)}), this package is for "
                               f"0x{VERSION:08x} ({_dotted(VERSION)}). {SAME_SOURCES}")
        if parameters != layout.ImageParameters:
            raise VersionError(f"{what}: its parameter register holds 0x{parameters:08x}, this package is for "
                               f"0x{layout.ImageParameters:08x}. {SAME_SOURCES}")
        if not read(layout.RegControl) >> layout.CtrlIdle & 1:
            raise BusyError(f"{what}: a job runs that this program did not start. Wait for it, or load the bitstream again")
        config = read(layout.RegConfig)
        return Info(_dotted(version), config & 0xff, config >> 8 & 0xff, config >> 16 & 0xff, parameters)

    # ---- Jobs ----
    def load(self, scene, size=None):
        """Copies a scene to the core's memory, in place of the one before: an image, its bytes, a file. The image."""
        image = image_of(scene, size)
        self._jobs.usable()
        self._image = None
        self._buffers.filled("image", image.bytes, layout.ImageAlign)
        self._image = image
        return image

    def render(self, scene=None, *, mode="bvh", hits=False, work=False, z_order=False, steps=0, window=None, size=None,
               frame=None, timeout=...):
        """Renders a scene, else the one that is loaded: a Frame.

        mode: bvh, bvh_root or brute. hits: the hit records too; work: with the nodes and tests of each ray in
        them. steps: nodes that a ray may visit. window: (x0, y0, x1, y1), only these pixels; others are black, and
        no hits. frame: a buffer of allocate() that the core draws into, in place of one of the driver's own.
        """
        timeout = self.timeout if timeout is ... else _seconds(timeout)
        options = self._options(mode, work, steps) | bool(z_order) << layout.OptionZOrder
        image = self._scene(scene, size)
        if not image.has_frame:
            raise ImageError("the image was compiled for a list of rays and has no frame: compile the scene without origins")
        low, high = _window(image, window)
        nbytes, count = image.stride * image.height, image.width * image.height
        target = self._buffers.pixels(nbytes) if frame is None else fits("frame", frame, nbytes)
        records = self._buffers.hits(count) if hits or work else None

        self._set_image(steps)
        self._jobs.set_window(layout.RegFrame, layout.RegFrameBytes, target)
        self._jobs.set_window(layout.RegHits, layout.RegHitsBytes, records)
        self._jobs.set(layout.RegFrameSize, image.width | image.height << 16)
        self._jobs.set(layout.RegWindowMin, low)
        self._jobs.set(layout.RegWindowMax, high)
        self._jobs.set(layout.RegOptions, options | (records is not None) << layout.OptionHits)
        counters = self._run(timeout)

        target.invalidate()
        met = None if records is None else records_of(records, count).reshape(image.height, image.width)
        return Frame(_pixels(image, target), met, counters)

    def query(self, rays, scene=None, *, mode="bvh_root", work=False, steps=0, timeout=...):
        """The hits of a list of rays in a scene, else in the one that is loaded: Answers.

        rays: an array of RAY, as image.rays(origins, directions) makes them. mode: bvh_root (bvh is the same) or brute.
        """
        timeout = self.timeout if timeout is ... else _seconds(timeout)
        options = self._options(mode, work, steps) & ~(1 << layout.OptionRoot) | 1 << layout.OptionList
        rays = _checked(rays)
        self._scene(scene, None)
        asked = self._buffers.filled("rays", rays.view(np.uint8))
        records = self._buffers.hits(len(rays))

        self._set_image(steps)
        self._jobs.set_window(layout.RegRays, layout.RegRayBytes, asked)
        self._jobs.set(layout.RegRayCount, len(rays))
        self._jobs.set_window(layout.RegHits, layout.RegHitsBytes, records)
        self._jobs.set(layout.RegOptions, options)
        counters = self._run(timeout)
        return Answers(records_of(records, len(rays)), counters)

    def counters(self):
        """The counters of the last job."""
        return self._jobs.counters()

    def allocate(self, nbytes):
        """A buffer that the core can draw into: render(frame=...). The caller frees it."""
        return self._device.allocate(nbytes)

    def close(self):
        """Gives the driver's buffers back."""
        self._buffers.free()
        self._image = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # ---- Of a job ----
    def _options(self, mode, work, steps):
        self._jobs.usable()
        if not isinstance(mode, str) or mode not in MODES:
            raise ArgumentError(f"mode {mode!r}: it is one of {', '.join(MODES)}")
        if not isinstance(steps, (int, np.integer)) or not 0 <= steps < 1 << 24:
            raise ArgumentError(f"steps: {steps}, must be 0 (no limit) to 2^24 - 1")
        return MODES[mode] | bool(work) << layout.OptionWork

    def _scene(self, scene, size):
        if scene is not None:
            self.load(scene, size)
        elif self._image is None:
            raise ArgumentError("no scene is loaded: give one, or load() it before")
        elif size is not None and size_of(size) != (self._image.width, self._image.height):
            raise ArgumentError("size: give the scene with it, its image is made for the size of the frame")
        return self._image

    def _set_image(self, steps):
        self._jobs.set_window(layout.RegImage, layout.RegImageBytes, self._buffers["image"])
        self._jobs.set(layout.RegSteps, steps)

    def _run(self, timeout):
        try:
            return self._jobs.run(timeout)
        finally:
            if self._jobs.lost:
                self._buffers.keep()


def _seconds(timeout):
    """None: however long it takes."""
    if timeout is not None and (not isinstance(timeout, (int, float, np.integer, np.floating)) or not timeout >= 0):
        raise ArgumentError(f"timeout: seconds, or None, are needed, not {timeout!r}")
    return None if timeout is None or timeout == float("inf") else float(timeout)


def _open(overlay, sim, options):
    if sim:
        if overlay is not None:
            raise ArgumentError("an overlay or sim=True, not both")
        from .simulation import Simulation
        return Simulation(**options)
    if isinstance(overlay, Device):
        return overlay
    from .board import Board
    return Board(overlay, **options)


def _window(image, window):
    if window is None:
        return 0, 0
    try:
        x0, y0, x1, y1 = (int(side) for side in window)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"window: (x0, y0, x1, y1) is needed, not {window!r}") from None
    if not (0 <= x0 < x1 <= image.width and 0 <= y0 < y1 <= image.height):
        raise ArgumentError(f"window {x0, y0, x1, y1}: empty, or not inside the frame of {image.width}x{image.height}")
    return x0 | y0 << 16, x1 | y1 << 16


def _checked(rays):
    if not isinstance(rays, np.ndarray) or rays.dtype != RAY or rays.ndim != 1:
        got = f"{rays.dtype} of shape {rays.shape}" if isinstance(rays, np.ndarray) else type(rays).__name__
        raise RayError(f"rays: one row of castray.RAY records is needed, not {got}; image.rays(origins, directions) makes them")
    if not 1 <= len(rays) <= layout.MaxRays:
        raise RayError(f"{len(rays)} rays: a list has 1 to {layout.MaxRays}")
    wrong = np.flatnonzero(rays["flags"] >> layout.NumRayFlags)
    if wrong.size:
        raise RayError(f"ray {wrong[0]} has a flag that is none")
    return np.ascontiguousarray(rays)


def _pixels(image, buffer):
    rows = buffer.data[:image.stride * image.height].reshape(image.height, image.stride)
    pixels = rows[:, :image.width * layout.PixelBytes].reshape(image.height, image.width, layout.PixelBytes)
    return np.ascontiguousarray(pixels[:, :, 2::-1] if image.frame["pixel_format"] == layout.PixelBgra8 else pixels[:, :, :3])


def _dotted(version):
    return f"{version >> 16}.{version >> 8 & 0xff}.{version & 0xff}"
