# SPDX-License-Identifier: Apache-2.0
"""Frames and lists of rays through the driver, on the simulated core."""
import csv
import hashlib
import subprocess

import castray
import numpy as np
import pytest
from conftest import ONE_LANE, ROOT, SCENES


def program(*arguments):
    """What build/castray prints."""
    return subprocess.run([ROOT / "build/castray", *arguments], check=True, capture_output=True, text=True).stdout


def hashes():
    """name of a file of raw pixels or hits at 80x60 -> its SHA-256, as every scene must come out."""
    lines = (SCENES / "frames.sha256").read_text().splitlines()
    return {name: digest for digest, name in (line.split() for line in lines)}


@pytest.mark.parametrize("scene", ["teapot", "cube", "spheres", "teapot_interior"])
def test_a_frame_is_what_it_must_be(core, scene):
    frame = core.render(SCENES / f"{scene}.json", hits=True, size=(80, 60))
    words = np.dstack([frame.pixels, np.full((60, 80), 255, np.uint8)])
    assert frame.pixels.shape == (60, 80, 3) and frame.pixels.dtype == np.uint8
    assert hashlib.sha256(words.tobytes()).hexdigest() == hashes()[f"{scene}.pixels"]
    assert frame.hits.shape == (60, 80) and frame.hits.dtype == castray.HIT
    assert hashlib.sha256(frame.hits.tobytes()).hexdigest() == hashes()[f"{scene}.hits"]


def test_modes_and_orders_draw_the_same(core, cube):
    first = core.render(cube, hits=True)
    for options in ({"mode": "bvh_root"}, {"mode": "brute"}, {"z_order": True}):
        frame = core.render(cube, hits=True, **options)
        assert (frame.pixels == first.pixels).all() and (frame.hits == first.hits).all(), options
    assert core.render(cube, mode="brute").counters["tests"] == 40 * 30 * cube.primitives


def test_without_hits_there_are_none_and_with_work_they_say_it(core, cube):
    assert core.render(cube).hits is None
    frame = core.render(cube, work=True, mode="bvh_root")
    assert frame.hits["nodes"].sum() == frame.counters["nodes"]
    assert frame.hits["tests"].sum() == frame.counters["tests"]


def test_polling_and_the_interrupt_give_the_same(cube):
    with castray.Core(sim=True, interrupt=False, **ONE_LANE) as polls, castray.Core(sim=True, **ONE_LANE) as waits:
        assert (polls.render(cube).pixels == waits.render(cube).pixels).all()
        assert polls.render(cube).cycles == waits.render(cube).cycles


def test_a_window_leaves_the_rest_black(core, cube):
    whole, part = core.render(cube, hits=True), core.render(cube, mode="brute", hits=True, window=(8, 8, 33, 20))
    inside = np.zeros((30, 40), bool)
    inside[8:20, 8:33] = True
    assert (part.pixels[inside] == whole.pixels[inside]).all() and (part.hits[inside] == whole.hits[inside]).all()
    assert not part.pixels[~inside].any() and (part.hits["prim"][~inside] == castray.NO_HIT).all()
    assert part.counters["rays"] == inside.sum()


def test_the_driver_draws_into_a_buffer_that_it_is_given(core, cube):
    buffer = core.allocate(cube.stride * cube.height)
    frame = core.render(cube, frame=buffer)
    rows = buffer.data.reshape(cube.height, cube.stride)[:, :4 * cube.width].reshape(cube.height, cube.width, 4)
    assert (rows[:, :, :3] == frame.pixels).all() and (rows[:, :, 3] == 255).all()
    buffer.free()


def test_blue_first_is_turned_round(core, cube):
    other = castray.SceneImage(cube.bytes.copy())
    other.frame["pixel_format"] = 1
    assert (core.render(other).pixels == core.render(cube).pixels).all()


def test_an_image_from_a_file_is_the_same(core, cube, tmp_path):
    file = tmp_path / "cube.image"
    program("compile", SCENES / "cube.json", "--size", "40x30", "-o", file)
    assert file.read_bytes() == cube.bytes.tobytes()
    first = core.render(cube).pixels
    for scene in (file, str(file), cube.bytes, file.read_bytes(), castray.SceneImage.load(file)):
        assert (core.render(scene).pixels == first).all()


def test_a_loaded_scene_serves_many_jobs(core, teapot):
    core.load(teapot)
    first = core.render()
    assert core.render().cycles == first.cycles and core.counters() == first.counters


def camera_rays(image):
    """A ray through the middle of the picture: from the eye against the camera's third axis."""
    f = image.frame
    eye = np.ldexp([int(f[f"eye_{axis}"]) + int(image.corner[i]) for i, axis in enumerate("xyz")], image.grid_power)
    return eye[None], -np.array([[f[f"back_{axis}"] for axis in "xyz"]], np.float64)


def test_one_ray_meets_what_the_picture_shows(core, teapot):
    hits = core.render(teapot, hits=True).hits
    answer = core.query(teapot.rays(*camera_rays(teapot))).hits[0]
    assert answer["prim"] in hits["prim"][29:31, 39:41]


def test_a_list_is_answered_as_the_program_answers_it(core, tmp_path):
    """The rays of scenes/rays.csv: the same records, so the same answers, bit for bit."""
    scene = SCENES / "teapot.json"
    lines = [line.replace(" ", "") for line in (SCENES / "rays.csv").read_text().splitlines() if line.strip() and line[0] != "#"]
    rays = list(csv.DictReader(lines))
    expected = list(csv.DictReader(program("query", scene, SCENES / "rays.csv", "--engine", "model").splitlines()))

    def column(name, default):
        return np.array([float(ray.get(name) or default) for ray in rays])
    origins = np.stack([column(f"o{axis}", 0) for axis in "xyz"], axis=1)
    image = castray.compile(scene, origins=origins)
    assert not image.has_frame
    directions = np.stack([column(f"d{axis}", 0) for axis in "xyz"], axis=1)
    records = image.rays(origins, directions, tmin=column("tmin", 0), tmax=column("tmax", "inf"), any_hit=column("any", 0).astype(bool),
                         cull=column("cull", 0).astype(bool), ignore=column("ignore", castray.NO_HIT))
    for mode in ("bvh_root", "brute"):
        hits = core.query(records, image, mode=mode).hits
        for hit, distance, row in zip(hits, image.distances(records, hits), expected, strict=True):
            assert int(row["hit"]) == (hit["prim"] != castray.NO_HIT)
            if row["prim"]:
                assert hit["prim"] == int(row["prim"]) and hit["t"] / 16 == float(row["t"])
                assert hit["u"] / 2**24 == float(row["u"]) and hit["v"] / 2**24 == float(row["v"])
                assert distance == pytest.approx(float(row["distance"]), rel=1e-9)
            elif row["hit"] == "1":
                assert hit["prim"] == castray.ANY_HIT and np.isnan(distance)
            else:
                assert np.isinf(distance)


def test_a_thousand_rays_by_the_hierarchy_and_by_brute_force(core, cube):
    random = np.random.default_rng(5)
    rays = cube.rays(camera_rays(cube)[0], random.normal(size=(1000, 3)))
    by_tree, by_brute = core.query(rays, cube), core.query(rays, mode="brute")
    assert (by_tree.hits == by_brute.hits).all() and by_tree.counters["hits"] == (by_tree.hits["prim"] != castray.NO_HIT).sum() > 0


def test_what_the_registers_say(core):
    assert (core.info.lanes, core.info.contexts, core.info.tile, core.version) == (1, 32, 8, castray.__version__)


def test_a_picture_is_a_png(core, cube):
    data = core.render(cube)._repr_png_()
    assert data[:8] == b"\x89PNG\r\n\x1a\n" and data[16:24] == (40).to_bytes(4, "big") + (30).to_bytes(4, "big")
