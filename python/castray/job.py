# SPDX-License-Identifier: Apache-2.0
"""A job through the registers: arguments, start, wait, outcome, and rest when it does not end."""
import time
import warnings

from . import _layout as layout
from .errors import HungError, JobError

RELOAD = "load its bitstream again, with a new castray.Core(...)"


class Jobs:
    def __init__(self, device, interrupt):
        self._device = device
        self.interrupt = interrupt
        self.lost = False   # a job could not be ended: nothing more can be asked

    # ---- Arguments ----
    def set(self, register, value):
        self._device.write32(register, int(value))

    def set_window(self, pointer, size, buffer):
        """A buffer's address and bytes; none: zeros."""
        address = buffer.address if buffer else 0
        self.set(pointer, address & 0xffffffff)
        self.set(pointer + 4, address >> 32)
        self.set(size, buffer.data.nbytes if buffer else 0)

    # ---- From the start to the end ----
    def run(self, timeout):
        """Its counters. JobError where the core ended it with an error, HungError where it did not end."""
        deadline = None if timeout is None else time.monotonic() + timeout
        self._acknowledge()
        self.set(layout.RegIer, self.interrupt << layout.IsrDone)
        self.set(layout.RegGie, self.interrupt)
        self.set(layout.RegControl, 1 << layout.CtrlStart)
        try:
            self._wait(timeout, deadline)
        except BaseException:   # a KeyboardInterrupt too: the core must not go on writing
            self._stop()
            raise
        error, counters = self._device.read32(layout.RegError), self.counters()
        self._device.job_ended()
        if error != layout.ErrNone:
            meaning = layout.ERRORS.get(error, "not a code that this package knows")
            raise JobError(error, f"the core ended the job with error {error}, {meaning}. The core is idle; "
                                  "docs/register-map.md says more")
        return counters

    def counters(self):
        read = self._device.read32
        at = [layout.RegCounters + 8 * i for i in range(layout.Counters)]
        return {name: read(low) | read(low + 4) << 32 for name, low in zip(layout.COUNTERS, at)}

    def usable(self):
        if self.lost:
            raise HungError(f"the core hangs since an earlier job: {RELOAD}")

    def _acknowledge(self):
        self.set(layout.RegIsr, self._device.read32(layout.RegIsr))   # toggles what is set

    def _done(self):
        return self._device.read32(layout.RegControl) >> layout.CtrlDone & 1

    def _idle(self):
        return self._device.read32(layout.RegControl) >> layout.CtrlIdle & 1

    def _wait(self, timeout, deadline):
        if self.interrupt:
            came = self._device.wait_interrupt(timeout)
            self._acknowledge()
            if self._done():
                if not came:
                    warnings.warn("the job is done, but no interrupt came; polling from now on. Is the interrupt wired?",
                                  RuntimeWarning, stacklevel=4)
                    self.interrupt = False
                return
            if not came:
                raise self._hung("no interrupt, and the job is not done", timeout)
            raise HungError(f"{self._device.description}: an interrupt came, but the job is not done")
        while not self._done():
            alive = self._device.pause()
            late = deadline is not None and time.monotonic() > deadline
            if (late or not alive) and not self._done():
                raise self._hung("the job is not done", timeout) if alive else \
                    HungError(f"{self._device.description}: the core does nothing any more, and the job is not done")
            if late or not alive:
                return

    def _hung(self, what, timeout):
        time_given = "" if timeout is None else f" after {timeout:g} s; timeout= gives it longer"
        return HungError(f"{self._device.description}: {what}{time_given}")

    def _stop(self):
        """Idle again, whatever runs."""
        self.set(layout.RegGie, 0)
        self.set(layout.RegIer, 0)
        if not self._idle() and not (self._device.reset() and self._idle()):
            self.lost = True
            warnings.warn(f"the core could not be brought to rest: {RELOAD}", RuntimeWarning, stacklevel=5)
