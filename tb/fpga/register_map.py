# SPDX-License-Identifier: Apache-2.0
"""register_map.py HWH REGISTERS: PYNQ's own reader of a hardware handoff finds the core, and PYNQ's register_map, made from what
it finds, reaches every register that was listed, at its offset."""
import pathlib
import re
import sys

import numpy
from pynq.pl_server.hwh_parser import _HWHUltrascale
from pynq.registers import RegisterMap

handoff, listed = sys.argv[1:]
core = _HWHUltrascale(handoff).ip_dict["castray"]
assert core["type"] == pathlib.Path("fpga/ultra96/vlnv.txt").read_text().strip(), core["type"]
assert (core["phys_addr"], core["addr_range"]) == (0xA0000000, 4096), core
assert core["interrupts"]["interrupt"]["raw_irq"] == 121, core["interrupts"]   # GIC, the first of pl_ps_irq0

memory = numpy.zeros(core["addr_range"] // 4, numpy.uint32)
registers = RegisterMap.create_subclass("castray", core["registers"])(memory)
expected = re.findall(r"^  \{(\w+) (0x\w+) (read-\w+)", pathlib.Path(listed).read_text(), re.M)
assert len(expected) == len(core["registers"]) > 70
for number, (name, offset, access) in enumerate(expected, 1):
    memory[int(offset, 16) // 4] = number
    assert int(getattr(registers, name)) == number, name
    if access == "read-write":
        setattr(registers, name, 1000 + number)
        assert memory[int(offset, 16) // 4] == 1000 + number, name
    else:
        assert core["registers"][name]["access"] == access, name
registers.Control = 0
registers.Control.Start = 1
registers.Options = 0
registers.Options.Brute = 1
assert memory[0] == 1 and memory[0x54 // 4] == 4
