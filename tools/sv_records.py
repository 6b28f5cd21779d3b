#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turn the SystemVerilog packages into one C++ header: constants, formats and records.

The packages are the one place where a width, an offset or a field order is written. This reads
the small subset they use (localparam, typedef logic / enum / struct packed), leaves functions to
the RTL, and stops with the file and line of anything else.
"""
import argparse
import pathlib
import re
import sys


class Packages:
    """Constants and types of all packages read so far, by name."""

    def __init__(self):
        self.constants = {}   # name -> int
        self.types = {}       # name -> (width, signed, fields or None)
        self.out = []

    def value(self, text):
        """The integer value of a constant expression."""
        text = re.sub(r"(\d+)?'([shb]*)([hdb])([0-9a-fA-F_]+)", lambda m: str(
            int(m[4].replace("_", ""), {"h": 16, "d": 10, "b": 2}[m[3]])), text)
        text = re.sub(r"\b\w+'\(", "(", text)
        text = re.sub(r"\$clog2\(", "clog2(", text)
        text = text.replace("/", "//")
        scope = dict(self.constants, clog2=lambda n: (n - 1).bit_length())
        return eval(f"({text})", {"__builtins__": {}}, scope)  # expressions of our own sources only

    def width(self, text):
        """(width, signed, fields) of a type written in place: logic, logic [..], or a name."""
        match = re.fullmatch(r"logic\s*(signed)?\s*(?:\[(.+):\s*0\])?", text.strip())
        if match:
            bits = self.value(match[2]) + 1 if match[2] else 1
            return bits, bool(match[1]), None
        return self.types[text.strip()]

    def constant(self, kind, name, text):
        """A localparam; kind is the type it was declared with."""
        if text.strip() == "'1":
            self.constants[name] = (1 << self.width(kind)[0]) - 1
        else:
            self.constants[name] = self.value(text)
        literal = self.constants[name]
        self.out.append(f"inline constexpr std::int64_t {name} = {literal};")

    def struct(self, name, body):
        fields, offset = [], 0
        declared = re.findall(r"([\w\s:\[\]+\-*]+?)\s+((?:\w+\s*,\s*)*\w+)\s*;", body)
        flat = [(kind, n.strip()) for kind, names in declared for n in names.split(",")]
        for kind, field in reversed(flat):
            bits, signed, sub = self.width(kind)
            fields.append((field, kind.strip(), bits, signed, sub, offset))
            offset += bits
        self.types[name] = (offset, False, fields)
        kept = [f for f in fields if f[0] not in ("reserved", "unused")]
        lines = [f"struct {name} {{", f"  static constexpr int kBits = {offset};"]
        for field, kind, bits, signed, sub, _ in kept:
            if sub:
                lines.append(f"  {kind} {field}{{}};")
            elif kind in self.types:
                lines.append(f"  {kind} {field}{{}};")
            elif bits > 64:
                lines.append(f"  std::array<std::uint32_t, {(bits + 31) // 32}> {field}{{}};")
            else:
                lines.append(f"  {'std::int64_t' if signed else 'std::uint64_t'} {field} = 0;")
        for const in ("", " const"):
            lines.append("  // f(name, value, lowest bit, bits, signed) for each leaf, lowest first.")
            lines.append(f"  template <class F> void each_field(F&& f, int at = 0){const} {{")
            for field, kind, bits, signed, sub, at in kept:
                if sub:
                    lines.append(f"    {field}.each_field(prefixed(\"{field}.\", f), at + {at});")
                else:
                    lines.append(f"    f(std::string_view(\"{field}\"), {field}, at + {at}, {bits}, "
                                 f"{'true' if signed else 'false'});")
            lines.append("  }")
        lines += [f"  bool operator==(const {name}&) const = default;", "};"]
        self.out += lines

    def read(self, path):
        source = path.read_text()
        text = re.sub(r"//[^\n]*", "", source)
        self.out.append(f"\n// ---- {path.name} ----")
        body = re.search(r"package\s+\w+\s*;(.*)endpackage", text, re.S)[1]
        body = re.sub(r"import\s+[\w:*]+\s*;", "", body)
        pos = 0
        patterns = [
            (r"\s*localparam\s+(int unsigned|logic\s*(?:\[[^\]]*\])?|\w+_t)\s+(\w+)\s*=\s*([^;]+);", "const"),
            (r"\s*typedef\s+struct\s+packed\s*\{(.*?)\}\s*(\w+)\s*;", "struct"),
            (r"\s*typedef\s+enum\s+(logic\s*\[[^\]]*\])\s*\{(.*?)\}\s*(\w+)\s*;", "enum"),
            (r"\s*typedef\s+(logic[^;{]*?)\s+(\w+)\s*;", "format"),
            (r"\s*function\b.*?\bendfunction\b", "function"),
            (r"\s+$", "end"),
        ]
        while pos < len(body):
            for pattern, kind in patterns:
                match = re.compile(pattern, re.S).match(body, pos)
                if match:
                    break
            else:
                line = body[pos:].strip().splitlines()[0]
                sys.exit(f"{path}: cannot read: {line}")
            pos = match.end()
            if kind == "const":
                self.constant(match[1], match[2], match[3])
            elif kind == "struct":
                self.struct(match[2], match[1])
            elif kind == "enum":
                self.enum(match[1], match[2], match[3])
                self.meanings(match[3], re.search(r"\{([^{}]*)\}\s*" + match[3] + r"\s*;", source)[1])
            elif kind == "format":
                bits, signed, _ = self.width(match[1])
                self.types[match[2]] = (bits, signed, None)
                cpp = "std::int64_t" if signed else "std::uint64_t"
                if 64 < bits < 128:   # a number of the width study; beats and lines of memory are larger
                    cpp = "__int128" if signed else "unsigned __int128"
                elif bits > 64:
                    cpp = f"std::array<std::uint32_t, {(bits + 31) // 32}>"
                self.out.append(f"using {match[2]} = {cpp};")
                self.out.append(f"inline constexpr int {match[2]}_bits = {bits};")

    def enum(self, base, body, name):
        self.types[name] = self.width(base)
        items = re.findall(r"(\w+)\s*=\s*([^,]+)", body)
        self.out.append(f"enum {name} : std::uint64_t {{")
        for item, text in items:
            self.constants[item] = self.value(text.strip())
            self.out.append(f"  {item} = {self.constants[item]},")
        self.out.append("};")

    def meanings(self, name, source):
        """meaning(value): the comment beside each item of an enumeration, where all have one."""
        items = re.findall(r"(\w+)\s*=\s*[\w']+\s*,?[ ]*(?://[ ]*([^\n]*))?", source)
        if not all(comment for _, comment in items):
            return
        self.out += [f"inline const char* meaning({name} value) {{", "  switch (value) {"]
        for item, comment in items:
            self.out.append(f"    case {item}: return \"{item}: {comment.strip()}\";")
        self.out += ["  }", "  return \"not a value that this program knows\";", "}"]


HEAD = """// Generated by tools/sv_records.py from the packages under rtl/pkg. Do not edit.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace castray {

// The name of a field of a record within a record: put together only for who reads it.
template <class Name> struct PrefixedName {
  std::string_view prefix;
  const Name& name;
  mutable std::string text;
  operator std::string_view() const { return text = std::string(prefix) + std::string(std::string_view(name)); }
};

// A visitor that puts a record's name before the names of its fields.
template <class F> auto prefixed(std::string_view prefix, F& f) {
  return [prefix, &f](const auto& name, auto& value, int at, int bits, bool is_signed) {
    f(PrefixedName<std::decay_t<decltype(name)>>{prefix, name, {}}, value, at, bits, is_signed);
  };
}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("packages", nargs="+", type=pathlib.Path, help="in the order of castray.f")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    args = parser.parse_args()
    packages = Packages()
    for path in args.packages:
        packages.read(path)
    args.output.parent.mkdir(parents=True, exist_ok=True)
    args.output.write_text(HEAD + "\n".join(packages.out) + "\n\n}  // namespace castray\n")


if __name__ == "__main__":
    main()
