# SPDX-License-Identifier: Apache-2.0
"""A board for PYNQ whose registers, memory and interrupt are those of the Verilated core.

All else is PYNQ's own: the overlay, the IP and its driver, buffers, the wait for an interrupt. As on the board
host and core see each other's writes only after flush and invalidate, and time passes between two accesses.
"""
import asyncio
import types

import numpy as np
import pynq
import pynq.interrupt
from castray import _layout as layout
from castray.simulation import Simulation
from conftest import ONE_LANE

BASE = 0xA000_0000
RAW_IRQ = 121
CYCLES = 2000   # between two accesses to a register


class SimulatedBuffer(pynq.buffer.PynqBuffer):
    """Goes back to the simulation's memory; on the board it is unmapped."""

    def freebuffer(self):
        if getattr(self, "memory", None):
            self.memory.take_back(self.bo)
            self.memory = None


class SimulatedBoard(pynq.Device):
    def __init__(self, vlnv=layout.VLNV, interrupts=True, memory=1 << 30):
        super().__init__("castray-simulation")
        self.name = "simulated"
        self.capabilities = {"REGISTER_RW": True}
        self.simulation = Simulation(**ONE_LANE)
        self.default_memory = self
        self.registers = {}          # that read otherwise than the core's own
        self.deaf = False            # true: the core is never started
        self.raises_interrupts = True
        self.downloads = 0
        self.free = memory
        pin = {"controller": "", "parent": "", "index": 0, "raw_irq": RAW_IRQ, "fullpath": "castray/interrupt"}
        pins = {"interrupt": pin} if interrupts else {}
        ip = {"phys_addr": BASE, "addr_range": 0x1000, "type": vlnv, "fullpath": "castray", "parameters": {},
              "registers": {}, "state": None, "interrupts": pins, "gpio": {}, "mem_id": None}
        self.metadata = types.SimpleNamespace(
            ip_dict={"castray": ip}, interrupt_pins={"castray/interrupt": pin} if interrupts else {}, gpio_dict={},
            interrupt_controllers={}, hierarchy_dict={}, mem_dict={}, clock_dict={}, systemgraph=None)
        pynq.interrupt._InterruptController._uio_devices[RAW_IRQ] = self
        pynq.Device.active_device = self

    # ---- The overlay: what PYNQ would read out of the .hwh, and the load ----
    def get_bitfile_metadata(self, name, partial=False):
        return self.metadata

    def download(self, bitstream, parser=None):
        self.simulation.reset()
        self.downloads += 1
        super().post_download(bitstream, parser)

    # ---- Registers ----
    def read_registers(self, address, length):
        assert length == 4
        self.simulation._core.run(CYCLES)
        value = self.simulation.read32(address - BASE)
        return self.registers.get(address - BASE, value).to_bytes(4, "little")

    def write_registers(self, address, data):
        if not (self.deaf and address - BASE == layout.RegControl):
            self.simulation.write32(address - BASE, int.from_bytes(data, "little"))

    # ---- Buffers ----
    def allocate(self, shape, dtype, **_):
        size = int(np.prod(shape)) * np.dtype(dtype).itemsize
        if size > self.free:
            raise RuntimeError("Failed to allocate Memory!")
        self.free -= size
        address = self.simulation._core.allocate(size)
        buffer = SimulatedBuffer(shape, dtype, device=self, device_address=address, bo=(address, size))
        buffer.memory = self
        return buffer

    def take_back(self, bo):
        self.simulation._core.release(bo[0])
        self.free += bo[1]

    @staticmethod
    def _bytes(pointer, size):
        return np.ctypeslib.as_array((np.ctypeslib.ctypes.c_uint8 * size).from_address(pointer))

    def flush(self, bo, offset, pointer, size):
        self.simulation._core.write(bo[0] + offset, self._bytes(pointer, size))

    def invalidate(self, bo, offset, pointer, size):
        self.simulation._core.read(bo[0] + offset, self._bytes(pointer, size))

    # ---- The interrupt, in place of a /dev/uio ----
    def add_event(self, event, number):
        async def wait():
            while not (self.simulation._core.run(CYCLES) and self.raises_interrupts):
                await asyncio.sleep(0)
            event.set()
        self.waiting = asyncio.get_event_loop().create_task(wait())
