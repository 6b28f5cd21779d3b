# SPDX-License-Identifier: Apache-2.0
"""Elaborated designs as text (Yosys' RTLIL), each distinct module once.

The slang front end gives every instance a module of its own. Here instances of equal text become one module, named
by the hash of that text: M<hash>. Automatic names are numbered anew and source positions dropped, so that the hash
changes with the logic only, and with that of what it instantiates.
"""
import collections
import dataclasses
import hashlib
import re

AUTOMATIC = re.compile(r"\$\d+\w*|\$\w+\$\S*")
DROPPED = re.compile(r"\s*attribute \\(src|hdlname|top)\b")
CELL = re.compile(r"  cell (\\\S+) ")
PORT = re.compile(r"  wire .*\b(input|output|inout) \d+")


@dataclasses.dataclass
class Module:
    name: str                        # M<hash>
    unit: str                        # what the RTL calls it
    lines: list                      # its text between "module" and "end"
    children: collections.Counter    # names of modules instantiated

    def text(self, name=None):
        return f"module \\{name or self.name}\n{''.join(self.lines)}end\n"

    def stub(self):
        """Its ports alone: what instantiates it is synthesised on its own."""
        ports = [line for line in self.lines if PORT.match(line)]
        return f"attribute \\blackbox 1\nmodule \\{self.name}\n{''.join(ports)}end\n"


class Design:
    """modules: the distinct ones by name; tops: name of each top's module; paths: name of each instance's."""

    def __init__(self, text):
        bodies, body = {}, None
        for line in text.splitlines(keepends=True):
            if line.startswith("module "):
                body = bodies.setdefault(line.split()[1], [])
            elif line.startswith("end"):
                body = None
            elif body is not None:
                body.append(line)
        self.modules, self.paths = {}, {}
        for path in bodies:
            self._add(path, bodies)
        self.tops = {path[1:]: name for path, name in self.paths.items() if "$" not in path}

    def _add(self, path, bodies):
        if path in self.paths:
            return self.paths[path]
        numbers, lines, children = {}, [], collections.Counter()
        for line in bodies[path]:
            if DROPPED.match(line):
                continue
            cell = CELL.match(line)
            if cell and cell[1] in bodies:
                child = self._add(cell[1], bodies)
                children[child] += 1
                line = line.replace(cell[1], f"\\{child}", 1)
            lines.append(AUTOMATIC.sub(lambda m: numbers.setdefault(m[0], f"$i{len(numbers)}"), line))
        unit = path[1:].split("$")[0]
        name = "M" + hashlib.sha256("".join([unit, *lines]).encode()).hexdigest()[:20]
        self.modules.setdefault(name, Module(name, unit, lines, children))
        self.paths[path] = name
        return name

    def below(self, name):
        """Names of all modules under one, itself last."""
        seen = []

        def visit(at):
            for child in self.modules[at].children:
                visit(child)
            if at not in seen:
                seen.append(at)

        visit(name)
        return seen

    def instances(self, top):
        """How many there are of each module in an instance of one."""
        times = collections.Counter({top: 1})
        for name in reversed(self.below(top)):
            for child, number in self.modules[name].children.items():
                times[child] += times[name] * number
        return times

    def total(self, name, counts):
        """Sum of counts[module], a Counter each, over an instance and all below it."""
        sums = {}
        for at in self.below(name):
            sums[at] = collections.Counter(counts[at])
            for child, times in self.modules[at].children.items():
                for key, value in sums[child].items():
                    sums[at][key] += times * value
        return sums[name]
