# SPDX-License-Identifier: Apache-2.0
"""The Verilated core behind a model of its memory, as a Device.

Host and core have memories of their own, and flush and invalidate copy between them: a driver that forgets
one of the two sees what it would see on a board.
"""
import os
import pathlib
import time

import numpy as np

from . import _layout as layout
from .device import Buffer, Device
from .errors import ArgumentError, NoMemoryError, NoSimulationError, SimulationError

CYCLES = 1 << 13          # between two looks at the clock on the wall
PATIENCE = 2_000_000      # cycles without traffic on the bus after which the core hangs


class SimulatedBuffer(Buffer):
    def __init__(self, core, nbytes):
        self._core = core
        self.address = core.allocate(nbytes)
        self.data = np.zeros(nbytes, np.uint8)

    def flush(self):
        self._core.write(self.address, self.data)

    def invalidate(self):
        self._core.read(self.address, self.data)

    def free(self):
        self._core.release(self.address)


class Simulation(Device):
    has_interrupt = True

    def __init__(self, lanes=layout.DefaultLanes, contexts=layout.DefaultContexts, tile=1 << layout.DefaultTileLog2,
                 ports=layout.DefaultPorts, l2_kbytes=layout.DefaultL2Kbytes, memory="reference", stalls="none", seed=1,
                 patience=PATIENCE, cores=None):
        try:
            from . import _simulation
        except ImportError as error:
            raise NoSimulationError("this install of castray is pure Python and has no simulated core: on a PC, "
                                    f"`pip install .` in the sources builds one ({error})") from None
        numbers = {"lanes": lanes, "contexts": contexts, "tile": tile, "ports": ports, "l2_kbytes": l2_kbytes, "seed": seed,
                   "patience": patience}
        for what, value in numbers.items():
            most = (1 << 64 if what in ("seed", "patience") else 1 << 31) - 1
            if not isinstance(value, (int, np.integer)) or not 0 <= value <= most:
                raise ArgumentError(f"{what}: {value!r}, must be a whole number from 0 to {most}")
        tile = int(tile)
        if tile not in (4, 8, 16):
            raise ArgumentError(f"tile: {tile}, must be 4, 8 or 16")
        folder = pathlib.Path(cores or os.environ.get("CASTRAY_CORES") or pathlib.Path(__file__).parent / "cores")
        name = f"l{lanes}c{contexts}t{tile.bit_length() - 1}p{ports}m{l2_kbytes}"
        if not (folder / f"{name}.so").is_file():
            there = ", ".join(sorted(file.stem for file in folder.glob("*.so"))) or "none"
            raise NoSimulationError(f"no simulated core {name} in {folder} (there: {there}). `make build/cores/{name}.so` in the "
                                    "sources builds it, and cores= or CASTRAY_CORES names the folder")
        try:
            self._core = _simulation.Core(str(folder), lanes, contexts, tile.bit_length() - 1, ports, l2_kbytes, memory, stalls, seed)
        except ValueError as error:
            raise ArgumentError(str(error)) from None
        self._patience = patience
        self.description = self._core.description

    def read32(self, offset):
        return self._core.read32(offset)

    def write32(self, offset, value):
        self._core.write32(offset, value)

    def allocate(self, nbytes):
        if not isinstance(nbytes, (int, np.integer)) or nbytes < 1:
            raise ArgumentError(f"a buffer of {nbytes!r} bytes")
        try:
            return SimulatedBuffer(self._core, nbytes)
        except MemoryError:
            raise NoMemoryError(f"no memory for a buffer of {nbytes} bytes") from None

    def wait_interrupt(self, seconds):
        deadline = None if seconds is None else time.monotonic() + seconds
        while not self._core.run(CYCLES):
            if self._hangs() or deadline is not None and time.monotonic() > deadline:
                return False
        return True

    def pause(self):
        self._core.run(CYCLES)
        return not self._hangs()

    def _hangs(self):
        return self._core.quiet > self._patience

    def reset(self):
        self._core.reset()
        return True

    def job_ended(self):
        broken = self._core.violations()
        if broken:
            raise SimulationError("the simulated core broke a rule of its bus: " + "; ".join(broken))
