#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the list of files in castray.core anew, from rtl/castray.f, and its version; or say whether they are what stands there."""
import argparse
import pathlib
import re
import sys

CORE = pathlib.Path("castray.core")


def renewed(text):
    files = [line for line in pathlib.Path("rtl/castray.f").read_text().splitlines() if line.startswith("rtl/")]
    listed = "".join(f"      - {name}\n" for name in files)
    package = pathlib.Path("rtl/pkg/castray_cfg_pkg.sv").read_text()
    version = ".".join(re.search(rf"Version{part} = (\d+);", package)[1] for part in ("Major", "Minor", "Patch"))
    text = re.sub(r"(# <files of rtl/castray\.f>\n).*?(\s*# </files>)", lambda m: m[1] + listed.rstrip("\n") + m[2], text, flags=re.S)
    return re.sub(r"(name: castray:castray:castray:).*", rf"\g<1>{version}", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="change nothing; fail if something would change")
    args = parser.parse_args()
    old = CORE.read_text()
    new = renewed(old)
    if args.check and new != old:
        sys.exit("castray.core is not what rtl/castray.f and castray_cfg_pkg say: run tools/fusesoc_core.py")
    if not args.check:
        CORE.write_text(new)


if __name__ == "__main__":
    main()
