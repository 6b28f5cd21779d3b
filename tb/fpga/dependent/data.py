#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write image.hex and frame.hex anew, the scene that the still picture is of and what the model makes of it; or say whether they
are what stands there. A line is a beat of 16 bytes, its highest byte first."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path("tb/fpga/dependent")
SCENE, SIZE = "scenes/cube.json", "16x12"


def beats(data):
    data += bytes(-len(data) % 16)
    return "".join(data[at:at + 16][::-1].hex() + "\n" for at in range(0, len(data), 16))


def made(folder):
    """The two files as the host's program makes them."""
    image, frame = folder / "image", folder / "frame"
    for command in (["compile", SCENE, "--size", SIZE, "-o", image],
                    ["render", SCENE, "--size", SIZE, "--engine", "model", "--frame", frame, "-o", folder / "picture.png"]):
        subprocess.run(["build/castray", *command], check=True, stdout=subprocess.DEVNULL)
    return {HERE / "image.hex": beats(image.read_bytes()), HERE / "frame.hex": beats(frame.read_bytes())}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail if something would change")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for path, text in made(pathlib.Path(folder)).items():
            if not args.check:
                path.write_text(text)
            elif not path.exists() or path.read_text() != text:
                sys.exit(f"{path} is of another core: run tb/fpga/dependent/data.py")


if __name__ == "__main__":
    main()
