# SPDX-License-Identifier: Apache-2.0
"""The registers around a unit that is placed on its own, as Verilog.

Each input port is a part of one shift register, each output port goes to a register whose bits are folded into
another: all paths begin and end at registers, and there are four pins, however many ports the unit has.
"""
import re

TOP = "pnr_top"
PORT = re.compile(r"  wire (?:.*\bwidth (\d+) )?.*\b(input|output) \d+ .*?(\\\S+)$")


def ports(module):
    """[(name, direction, bits)] of a module."""
    found = (PORT.match(line) for line in module.lines)
    return [(m[3][1:], m[2], int(m[1] or 1)) for m in found if m]


def bits(module, direction):
    return sum(n for _, way, n in ports(module) if way == direction)


def text(module):
    """The registers bear the names of their ports."""
    outside = {"clk_i": "clk", "rst_ni": "rst_q"}
    declared, joined, before, fold = [], [], "shift_in", "shift_in"
    for name, direction, width in ports(module):
        if name in outside and direction == "input":
            joined.append(f".\\{name} ({outside[name]})")
        elif direction == "input":
            declared.append(f"  reg [{width - 1}:0] \\{name} ;\n  always @(posedge clk) \\{name} <= {{\\{name} , {before}}};")
            before = f"\\{name} [{width - 1}]"
            joined.append(f".\\{name} (\\{name} )")
        else:
            declared.append(f"  wire [{width - 1}:0] \\{name}:wire ;\n  reg [{width - 1}:0] \\{name} , \\{name}:fold ;\n"
                            f"  always @(posedge clk) begin\n    \\{name} <= \\{name}:wire ;\n"
                            f"    \\{name}:fold <= {{\\{name}:fold , {fold}}} ^ \\{name} ;\n  end")
            fold = f"\\{name}:fold [{width - 1}]"
            joined.append(f".\\{name} (\\{name}:wire )")
    lines = "\n".join(declared)
    return f"""module {TOP} (input clk, input rst_n, input shift_in, output reg shift_out);
  reg rst_q;
  always @(posedge clk) rst_q <= rst_n;
{lines}
  always @(posedge clk) shift_out <= {fold};
  {module.name} u ({", ".join(joined)});
endmodule
"""
