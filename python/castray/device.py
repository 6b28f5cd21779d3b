# SPDX-License-Identifier: Apache-2.0
"""A castray core behind its registers and its memory, and nothing else: what Core drives.

simulation.py and board.py are the two there are.
"""
import abc


class Buffer(abc.ABC):
    """Memory that host and core both reach. The host sees `data`, a row of uint8; the core `address`."""

    address = 0
    data = None

    @abc.abstractmethod
    def flush(self):
        """What the host wrote becomes visible to the core."""

    @abc.abstractmethod
    def invalidate(self):
        """What the core wrote becomes visible to the host."""

    @abc.abstractmethod
    def free(self):
        """The memory goes back; neither side may touch it any more."""


class Device(abc.ABC):
    description = ""
    has_interrupt = False
    timeout = None   # seconds that a job may take, unless the caller says so; None: any

    @abc.abstractmethod
    def read32(self, offset):
        """A register."""

    @abc.abstractmethod
    def write32(self, offset, value):
        """The same."""

    @abc.abstractmethod
    def allocate(self, nbytes):
        """A Buffer of at least so many bytes; NoMemoryError."""

    @abc.abstractmethod
    def wait_interrupt(self, seconds):
        """True as soon as the interrupt is high, False when it was not in this time."""

    @abc.abstractmethod
    def pause(self):
        """Lets the core run a little between two looks at it; False when it surely hangs."""

    @abc.abstractmethod
    def reset(self):
        """The core as after power-up, memory as it is. False when there is no way to do that."""

    def job_ended(self):
        """Called when a job's outcome was read."""
