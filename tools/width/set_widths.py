#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write rtl/pkg/castray_cfg_pkg.sv anew with other widths: set_widths.py FOLDER NAME=VALUE ...

FOLDER, under build/width, then serves as BUILD and the file in it as CONFIG of make:
    make BUILD=FOLDER CONFIG=FOLDER/castray_cfg_pkg.sv FOLDER/unit/isect/ray_prim_test
"""
import pathlib
import re
import sys

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "rtl/pkg/castray_cfg_pkg.sv"


def with_widths(widths):
    """The package's text with each width of {name: value} changed."""
    text = PACKAGE.read_text()
    for name, value in widths.items():
        text, found = re.subn(rf"(unsigned {name} *= )[^;]*;", rf"\g<1>{value};", text)
        if found != 1:
            raise ValueError(f"{PACKAGE.name} has no width {name}")
    return text


def write(folder, widths):
    """The changed package in a folder; left alone, with its date, if it stands there already."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    path, text = folder / PACKAGE.name, with_widths(widths)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)
    return path


def main():
    folder, *settings = sys.argv[1:]
    try:
        write(folder, dict(setting.split("=") for setting in settings))
    except ValueError as error:
        sys.exit(f"set_widths: {error}")


if __name__ == "__main__":
    main()
