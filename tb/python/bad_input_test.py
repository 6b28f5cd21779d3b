# SPDX-License-Identifier: Apache-2.0
"""Whatever is wrong is an exception of its own type, with a sentence, before the core is started or with the core idle."""
import castray
import numpy as np
import pytest
from castray import _layout as layout
from conftest import ONE_LANE, SCENES, renders


@pytest.fixture
def started(core, monkeypatch):
    """The values written to the control register: a job that was refused has none."""
    writes = []
    write = core._device.write32

    def noted(offset, value):
        if offset == layout.RegControl:
            writes.append(value)
        write(offset, value)
    monkeypatch.setattr(core._device, "write32", noted)
    return writes


def edited(image, what, value, part="header"):
    other = castray.SceneImage(image.bytes.copy())
    getattr(other, part)[what] = value
    return other.bytes


@pytest.mark.parametrize("field, value, part, words", [
    ("magic", 0x12345678, "header", "no scene image"),
    ("version", 1, "header", "version 1"),
    ("parameters", 0x18040014, "header", "parameter set 0x18040014"),
    ("image_bytes", 1 << 30, "header", "cut short"),
    ("lines.offset", 300, "header", "section lines"),
    ("nodes.count", 1 << 24, "header", "section nodes"),
    ("primitives", 1 << 20, "header", "attributes"),
    ("width", 4097, "frame", "1 to 4096"),
    ("height", 0, "frame", "1 to 4096"),
    ("stride", 100, "frame", "rows of 100 bytes"),
    ("pixel_format", 2, "frame", "pixel format 2"),
])
def test_an_image_that_is_none_for_this_core(core, cube, started, field, value, part, words):
    with pytest.raises(castray.ImageError, match=words):
        core.render(edited(cube, field, value, part))
    assert not started


@pytest.mark.parametrize("data", [b"", b"CTRY", np.zeros((4, 64), np.uint8), np.zeros(256, np.float32)])
def test_bytes_that_are_no_image(core, data, started):
    with pytest.raises(castray.ImageError):
        core.render(data)
    assert not started


def test_a_scene_that_is_none(core, tmp_path, started):
    (tmp_path / "bad.json").write_text("{}")
    for scene, words in ((tmp_path / "none.json", "no such file"), (tmp_path / "bad.json", "bad.json: ")):
        with pytest.raises(castray.SceneError, match=words):
            core.render(scene)
    assert not started


@pytest.mark.parametrize("scene", [5, 1.5, ["a.json"], "a\0.json"])
def test_a_scene_that_is_no_name(core, scene, started):
    for call in (core.render, castray.compile):
        with pytest.raises(castray.ArgumentError, match="scene: the name"):
            call(scene)
    with pytest.raises(castray.ArgumentError, match="not bytes"):
        castray.compile(b"scenes/cube.json")
    assert not started


@pytest.mark.parametrize("options, words", [
    ({"size": 5}, "size"), ({"size": (8, float("inf"))}, "size"), ({"size": (8, 0)}, "size"), ({"size": "8x8"}, "size"),
    ({"origins": [[0, 0, 0], [1, 2]]}, "origins"), ({"origins": "abc"}, "origins"), ({"origins": [[0, 0, np.inf]]}, "origins"),
])
def test_a_scene_that_cannot_be_compiled_so(options, words):
    with pytest.raises(castray.ArgumentError, match=words):
        castray.compile(SCENES / "cube.json", **options)


def test_memory_that_there_is_not(core, cube):
    with pytest.raises(castray.NoMemoryError, match="buffer of 1152921504606846976 bytes"):
        core.allocate(1 << 60)
    for nbytes in (0, -1, 1.5, "x"):
        with pytest.raises(castray.ArgumentError, match="buffer of"):
            core.allocate(nbytes)
    assert renders(core, cube)


def test_an_image_file_cut_short(core, cube, tmp_path, started):
    (tmp_path / "cube.image").write_bytes(cube.bytes[:1000].tobytes())
    with pytest.raises(castray.ImageError, match="cube.image: .*cut short"):
        core.render(tmp_path / "cube.image")
    assert not started


@pytest.mark.parametrize("options, words", [
    ({"mode": "fast"}, "one of bvh"), ({"steps": -1}, "steps"), ({"steps": 1 << 24}, "steps"),
    ({"steps": 1.5}, "steps"), ({"mode": ["bvh"]}, "one of bvh"), ({"mode": None}, "one of bvh"),
    ({"timeout": "x"}, "timeout"), ({"timeout": -1}, "timeout"), ({"timeout": float("nan")}, "timeout"),
    ({"size": 5}, "size"), ({"size": (40, float("inf"))}, "size"), ({"window": (0, 0, float("inf"), 1)}, "window"),
    ({"window": (0, 0, 41, 30)}, "window"), ({"window": (5, 5, 5, 6)}, "window"), ({"window": "all"}, "window"),
    ({"size": (80, 60)}, "compiled for 40x30"), ({"frame": bytearray(10)}, "frame"),
])
def test_arguments_that_cannot_be(core, cube, started, options, words):
    with pytest.raises(castray.ArgumentError, match=words):
        core.render(cube, **options)
    assert not started


def test_a_buffer_too_small(core, cube, started):
    buffer = core.allocate(cube.stride * cube.height - 1)
    with pytest.raises(castray.BufferSizeError, match=f"frame: .* the job needs {cube.stride * cube.height}"):
        core.render(cube, frame=buffer)
    buffer.data, buffer.address = np.zeros(cube.stride * cube.height, np.uint8), buffer.address + 8
    with pytest.raises(castray.BufferSizeError, match="multiples of 64"):
        core.render(cube, frame=buffer)
    assert not started


@pytest.mark.parametrize("rays, words", [
    (np.zeros(3, np.float64), "castray.RAY"), ([1, 2, 3], "list"), (np.zeros((2, 2), castray.RAY), "one row"),
    (np.zeros(0, castray.RAY), "0 rays"),
])
def test_rays_of_another_form(core, cube, started, rays, words):
    with pytest.raises(castray.RayError, match=words):
        core.query(rays, cube)
    assert not started


def test_a_flag_that_is_none(core, cube, started):
    rays = np.zeros(3, castray.RAY)
    rays["flags"][1] = 4
    with pytest.raises(castray.RayError, match="ray 1 has a flag"):
        core.query(rays, cube)
    assert not started


@pytest.mark.parametrize("origins, directions, options, words", [
    ([[0, 0]], [[1, 0, 0]], {}, "shape"), ("abc", [[1, 0, 0]], {}, "not numbers"), ([[0, 0, 0]], [[0, 0, 0]], {}, "zero"),
    ([[0, 0, 0]], [[0, np.nan, 0]], {}, "finite"), ([[0, np.inf, 0]], [[0, 1, 0]], {}, "finite"),
    ([[0, 0, 1e9]], [[0, 1, 0]], {}, "outside the image's grid"), ([[0, 0, 0]] * 3, [[0, 1, 0]] * 2, {}, "3 origins and 2"),
    ([[0, 0, 0]], [[0, 1, 0]], {"tmin": 2, "tmax": 2}, "empty"),
    ([[0, 0, 0]], [[0, 1, 0]], {"tmin": np.nan}, "empty"), ([[0, 0, 0]], [[0, 1, 0]], {"ignore": 12}, "primitives 0 to 11"),
    ([[0, 0, 0]], [[0, 1, 0]], {"ignore": 1.5}, "ignore: .*not whole"),
    ([[0, 0, 0]], [[0, 1, 0]], {"ignore": np.nan}, "ignore: .*not whole"), ([[0, 0, 0]], [[0, 1, 0]], {"ignore": np.inf}, "not whole"),
    ([[0, 0, 0]], [[0, 1, 0]], {"ignore": "3"}, "ignore: .*not whole"), ([[0, 0, 0]], [[0, 1, 0]], {"ignore": 1 << 70}, "ignore"),
    ([[0, 0, 0]], [[0, 1, 0]], {"tmax": [1, 2]}, "tmax"),
])
def test_rays_that_cannot_be_asked(cube, origins, directions, options, words):
    with pytest.raises(castray.RayError, match=words):
        cube.rays(origins, directions, **options)


def test_no_scene_is_loaded():
    with castray.Core(sim=True, **ONE_LANE) as core:
        with pytest.raises(castray.ArgumentError, match="no scene is loaded"):
            core.render()
        with pytest.raises(castray.ArgumentError, match="no scene is loaded"):
            core.query(np.zeros(1, castray.RAY))


def test_an_image_for_rays_has_no_frame(core, started):
    with pytest.raises(castray.ImageError, match="has no frame"):
        core.render(castray.compile(SCENES / "cube.json", origins=[[0, 0, 9]]))
    assert not started


def test_a_core_that_was_not_built():
    with pytest.raises(castray.NoSimulationError, match="make build/cores/l7c1t4p2m128.so"):
        castray.Core(sim=True, lanes=7, contexts=1, tile=16)
    with pytest.raises(castray.ArgumentError, match="tile"):
        castray.Core(sim=True, tile=5)
    for what, value in (("tile", 8.0), ("lanes", "3"), ("lanes", -1), ("l2_kbytes", 1 << 40), ("seed", -1), ("seed", 1 << 64), ("seed", 1.5)):
        with pytest.raises(castray.ArgumentError, match=f"{what}: "):
            castray.Core(sim=True, **{**ONE_LANE, what: value})
    with pytest.raises(castray.ArgumentError, match="timeout"):
        castray.Core(sim=True, timeout="x", **ONE_LANE)
    with pytest.raises(castray.ArgumentError, match="stall"):
        castray.Core(sim=True, stalls="never", **ONE_LANE)


def test_a_job_that_the_core_ends_with_an_error(core, teapot):
    with pytest.raises(castray.JobError, match="ErrSteps") as caught:
        core.render(teapot, steps=1)
    assert caught.value.code == layout.ErrSteps
    assert core._device.read32(layout.RegControl) >> layout.CtrlIdle & 1
    assert renders(core, teapot)


@pytest.mark.parametrize("interrupt", [True, False])
def test_a_job_that_takes_too_long(teapot, cube, interrupt):
    with castray.Core(sim=True, interrupt=interrupt, **ONE_LANE) as core:
        with pytest.raises(castray.HungError, match="timeout= gives it longer"):
            core.render(SCENES / "teapot.json", mode="brute", timeout=0.05)
        assert core._device.read32(layout.RegControl) >> layout.CtrlIdle & 1, "the device is left idle"
        assert renders(core, cube)


@pytest.mark.parametrize("interrupt", [True, False])
def test_a_core_that_does_nothing_any_more(cube, interrupt):
    with castray.Core(sim=True, interrupt=interrupt, patience=100, **ONE_LANE) as core:
        write = core._device.write32
        core._device.write32 = lambda offset, value: None if offset == layout.RegControl else write(offset, value)
        with pytest.raises(castray.HungError):
            core.render(cube, timeout=5)
        del core._device.write32
        assert renders(core, cube)


def test_a_core_that_cannot_be_brought_to_rest(cube):
    core = castray.Core(sim=True, **ONE_LANE)
    core._device.reset = lambda: False
    with pytest.warns(RuntimeWarning, match="could not be brought to rest"), pytest.raises(castray.HungError):
        core.render(SCENES / "teapot.json", mode="brute", timeout=0.05)
    with pytest.raises(castray.HungError, match="load its bitstream again"):
        core.render(cube)
    core.close()
