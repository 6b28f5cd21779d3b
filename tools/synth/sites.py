# SPDX-License-Identifier: Apache-2.0
"""How many of the device's LUTs a netlist's LUT cells take.

A LUT6 of UltraScale+ has two outputs: it holds one function of six inputs, or two of at most five inputs between
them (UG574, look-up table). Yosys maps with that in mind (two small cells cost it no more than a large one), but leaves each
in a cell of its own. Here they are paired, each cell once, under rules that any placement can keep:

  - a LUT6 stands alone, and so does a LUT that drives a carry's sum input or a wide multiplexer: the other output is theirs
  - two others share a LUT where their inputs together are five or fewer; an inverter is a function of one input
"""
import collections
import re

CELL = re.compile(r"  cell \\(\S+) ")
CONNECT = re.compile(r"    connect \\(\S+) (.*)$")
NET = re.compile(r"\\\S+(?: \[\d+\])?|\$\S+(?: \[\d+\])?")
LUT = re.compile(r"LUT[1-6]$|INV$")
INPUTS = 5   # of two functions in one LUT


def cells(lines):
    """(type, {port: net}) of each cell of a module's text."""
    found = []
    for line in lines:
        cell = CELL.match(line)
        port = CONNECT.match(line)
        if cell:
            found.append((cell[1], {}))
        elif port and found:
            found[-1][1][port[1]] = port[2].strip()
    return found


def functions(found):
    """(how many LUTs hold one function alone, the inputs of each function that may share one)."""
    bound = set()
    for kind, ports in found:
        if kind == "CARRY4":
            bound.update(NET.findall(ports["S"]))
        elif kind.startswith("MUXF"):
            bound.update((ports["I0"], ports["I1"]))
    alone, free = 0, []
    for kind, ports in found:
        if not LUT.match(kind):
            continue
        if kind == "LUT6" or ports["O"] in bound:
            alone += 1
        else:
            free.append(frozenset(net for name, net in ports.items() if name.startswith("I")))
    return alone, free


def pairs(free):
    """A matching of functions that fit into one LUT, as pairs of indices: the largest first, each with the largest it shares nets
    with, and what is left over among the small ones, which need share none."""
    users = collections.defaultdict(dict)   # dicts, for their order: the same netlist gives the same pairs
    order = sorted(range(len(free)), key=lambda i: -len(free[i]))
    for i in order:
        for net in free[i]:
            users[net][i] = None
    matched, single, gone = [], [], set()

    def take(i):
        gone.add(i)
        for net in free[i]:
            del users[net][i]

    for i in order:
        if i in gone:
            continue
        take(i)
        near = (j for net in sorted(free[i]) for j in users[net] if len(free[i] | free[j]) <= INPUTS)
        best = max(near, key=lambda j: (len(free[j]), -j), default=None)
        if best is None:
            single.append(i)
        else:
            take(best)
            matched.append((i, best))
    # What is left shares no net that helps: the largest of it with the largest that fits.
    by_size = {size: [i for i in single if len(free[i]) == size] for size in range(INPUTS + 1)}
    for size in range(INPUTS, 0, -1):
        while by_size[size]:
            i = by_size[size].pop()
            other = next((s for s in range(min(size, INPUTS - size), 0, -1) if by_size[s]), None)
            if other:
                matched.append((i, by_size[other].pop()))
    return matched


def count(lines):
    """LUTs that a module's LUT cells take, those of memories and shift registers not among them."""
    alone, free = functions(cells(lines))
    return alone + len(free) - len(pairs(free))
