# SPDX-License-Identifier: Apache-2.0
"""The model at the points of the width study: each point is a program compiled for its widths."""
import concurrent.futures
import json
import os
import pathlib
import subprocess
import time

import points
import set_widths

BUILD = pathlib.Path("build/width")
REFERENCES = BUILD / "reference"
PACKAGES = ["rtl/pkg/castray_pkg.sv", "rtl/pkg/castray_image_pkg.sv", "rtl/pkg/castray_reg_pkg.sv"]
COMPILE = ("clang++ -std=c++20 -O2 -march=native -w -Itools/width -Icpp_model -Itb/common -Itb -Itb/isect -isystem /usr/include/Imath").split()
LIBRARY = "build/libcastray.a -lembree3 -lassimp -lOpenImageIO -lOpenImageIO_Util -lImath-3_1 -latomic -lpthread".split()


def newest():
    """When what a point is made of was last changed."""
    sources = [p for folder in ("cpp_model", "tools/width", "tb/isect", "rtl/pkg", "scenes") for p in pathlib.Path(folder).rglob("*")
               if p.suffix in (".hpp", ".cpp", ".sv", ".json")]
    return max(p.stat().st_mtime for p in sources)


def run(name, widths, program):
    """What program (point or tree) says of some widths. A result that is newer than its sources is taken as it is."""
    folder = BUILD / name
    result = folder / f"{program}.json"
    if not result.exists() or result.stat().st_mtime < newest():
        package = set_widths.write(folder, widths)
        subprocess.run(["python3", "tools/sv_records.py", package, *PACKAGES, "-o", folder / "model/castray_records.hpp"], check=True)
        subprocess.run([*COMPILE, f"-I{folder}/model", f"tools/width/{program}.cpp", *LIBRARY, "-o", folder / program], check=True)
        text = subprocess.run([folder / program, REFERENCES], check=True, capture_output=True, text=True).stdout
        json.loads(text)
        result.write_text(text)
        (folder / program).unlink()
    return json.loads(result.read_text())


def summary(program, found):
    views = found["views"].values()
    if program == "tree":
        return f"{sum(v['nodes'] for v in views):,} nodes, {sum(v['differ'] for v in views)} hits differ from brute force"
    return (f"{'/'.join(str(v['wrong']) for v in views)} wrong pixels, {min(v['psnr'] for v in views):.1f} dB, "
            f"{found['none'] + found['several']} cracks")


def study(jobs):
    """The points of every curve with what was found: [(Point, dict)]."""
    REFERENCES.mkdir(parents=True, exist_ok=True)
    wanted = [(p, "point") for p in points.points()] + [(p, "tree") for p in points.slab_points()]
    distinct = {(p.name, program): p.widths for p, program in wanted}
    start, found = time.monotonic(), {}

    def one(key):
        return run(key[0], distinct[key], key[1])

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:   # the first makes the references
        for batch in ([("default", "point")], [k for k in distinct if k != ("default", "point")]):
            running = {pool.submit(one, key): key for key in batch}
            for job in concurrent.futures.as_completed(running):
                key = running[job]
                found[key] = job.result()
                print(f"  width [{len(found)}/{len(distinct)}] {time.monotonic() - start:4.0f} s  {key[0]}: {summary(key[1], found[key])}", flush=True)
    return [(p, found[p.name, program]) for p, program in wanted]


if __name__ == "__main__":
    study(os.cpu_count())
