# SPDX-License-Identifier: Apache-2.0
"""The driver under PYNQ: a real Overlay and a real DefaultIP, on a board that is the Verilated core."""
import asyncio
import subprocess
import sys

import castray
import castray.board
import pynq
import pytest
from castray import _layout as layout
from conftest import ONE_LANE, renders
from simulated_board import SimulatedBoard


@pytest.fixture
def bitstream(tmp_path):
    for suffix in (".bit", ".hwh"):
        (tmp_path / f"castray{suffix}").touch()
    return tmp_path / "castray.bit"


@pytest.fixture
def board():
    return SimulatedBoard()


def idle(board):
    return board.simulation.read32(layout.RegControl) >> layout.CtrlIdle & 1


def test_the_ip_of_the_overlay_has_our_driver(board, bitstream):
    overlay = pynq.Overlay(str(bitstream))
    assert type(overlay.castray) is castray.board.CastrayIP and isinstance(overlay.castray, pynq.DefaultIP)


@pytest.mark.parametrize("by", ["bitstream", "overlay", "ip"])
def test_a_core_from(board, bitstream, cube, by):
    overlay = str(bitstream) if by == "bitstream" else pynq.Overlay(str(bitstream))
    with castray.Core(overlay.castray if by == "ip" else overlay) as core:
        assert core.info.lanes == 1 and board.downloads == 1
        assert renders(core, cube)


@pytest.mark.parametrize("interrupt", [True, False])
def test_frames_and_lists_are_those_of_the_simulation(board, bitstream, teapot, interrupt):
    with castray.Core(bitstream, interrupt=interrupt) as core, castray.Core(sim=True, **ONE_LANE) as simulated:
        ours, theirs = core.render(teapot, hits=True), simulated.render(teapot, hits=True)
        assert (ours.pixels == theirs.pixels).all() and (ours.hits == theirs.hits).all() and ours.cycles == theirs.cycles
        assert type(ours.hits) is type(theirs.hits), "plain arrays, no PynqBuffer"
        rays = teapot.rays([0, 1, 9], [[0, 0, -1], [0.1, 0, -1], [0, 1, 0]])
        assert (core.query(rays).hits == simulated.query(rays).hits).all()


def test_a_buffer_that_is_not_flushed_or_invalidated_is_seen(board, bitstream, cube, monkeypatch):
    with castray.Core(bitstream) as core:
        monkeypatch.setattr(castray.board.BoardBuffer, "invalidate", lambda self: None)
        assert not core.render(cube).pixels.any()
        monkeypatch.setattr(castray.board.BoardBuffer, "flush", lambda self: None)
        board.simulation._core.write(core._buffers["image"].address, cube.bytes * 0)
        with pytest.raises(castray.JobError, match="ErrImage"):
            core.render(cube)


def test_buffers_go_back(board, bitstream, cube):
    free = board.free
    with castray.Core(bitstream) as core:
        core.render(cube, hits=True)
        assert board.free < free
    assert board.free == free


def test_a_bitstream_without_an_interrupt_is_polled(bitstream, cube):
    SimulatedBoard(interrupts=False)
    with castray.Core(bitstream) as core:
        assert renders(core, cube)
    with pytest.raises(castray.ArgumentError, match="interrupt=False polls"):
        castray.Core(bitstream, interrupt=True)


def test_where_an_event_loop_runs_the_core_is_polled(board, bitstream, cube):
    async def cell():
        with castray.Core(bitstream) as core:
            return core.render(cube).pixels
    assert asyncio.new_event_loop().run_until_complete(cell()).any()


def test_an_interrupt_that_never_comes(board, bitstream, cube):
    board.raises_interrupts = False
    with castray.Core(bitstream) as core:
        with pytest.warns(RuntimeWarning, match="no interrupt came"):
            core.render(cube, timeout=0.3)
        assert renders(core, cube), "polls from then on"


# ---- Bad input ----
def test_no_board():
    """A process of its own: PYNQ looks for boards once."""
    script = "import castray\ntry: castray.Core('castray.bit')\nexcept castray.NoBoardError as error: print(error)"
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", script], capture_output=True, text=True)
    assert "no board here" in done.stdout and "sim=True" in done.stdout, done.stdout + done.stderr


def test_no_pynq(monkeypatch):
    monkeypatch.setattr(castray.board, "pynq", None)
    with pytest.raises(castray.NoBoardError, match="PYNQ is not installed"):
        castray.Core()


def test_the_one_bitstream_of_this_folder(board, bitstream, cube, monkeypatch):
    monkeypatch.chdir(bitstream.parent)
    with pytest.raises(castray.NoOverlayError, match="There are 0 files"):
        castray.Core()
    for suffix in (".bit", ".hwh"):
        bitstream.with_suffix(suffix).rename(bitstream.parent / f"castray_ultra96v2{suffix}")
    with castray.Core() as core:
        assert renders(core, cube)


def test_no_overlay(board, bitstream, tmp_path):
    with pytest.raises(castray.NoOverlayError, match="other.bit: there is no such file.*make bitstream"):
        castray.Core(tmp_path / "other.bit")
    bitstream.with_suffix(".hwh").unlink()
    with pytest.raises(castray.NoOverlayError, match="castray.hwh: there is no such file"):
        castray.Core(bitstream)
    with pytest.raises(castray.ArgumentError, match="not int"):
        castray.Core(5)


def test_an_overlay_that_pynq_cannot_load(board, bitstream, monkeypatch):
    monkeypatch.setattr(board, "get_bitfile_metadata", lambda *_, **__: 1 / 0)
    with pytest.raises(castray.NoOverlayError, match="PYNQ cannot load it"):
        castray.Core(bitstream)


@pytest.mark.filterwarnings("ignore:IP castray is of type")
@pytest.mark.parametrize("vlnv", ["xilinx.com:ip:axi_dma:7.1", layout.VLNV.rpartition(":")[0] + ":0.9"])
def test_an_overlay_of_something_else(bitstream, vlnv):
    SimulatedBoard(vlnv=vlnv)
    with pytest.raises(castray.NoOverlayError, match=f"but {vlnv}: build it"):
        castray.Core(bitstream)


def test_registers_that_are_not_mapped_whole(board, bitstream):
    board.metadata.ip_dict["castray"]["addr_range"] = 0x80
    with pytest.raises(castray.NoOverlayError, match="the overlay maps 128"):
        castray.Core(bitstream)


@pytest.mark.parametrize("register, words", [(layout.RegVersion, r"version register holds 0x00020000 \(2.0.0\)"),
                                             (layout.RegParameters, "parameter register holds 0x00020000")])
def test_a_bitstream_of_another_version(board, bitstream, register, words):
    board.registers[register] = 0x20000
    with pytest.raises(castray.VersionError, match=words):
        castray.Core(bitstream)
    assert idle(board)


def test_a_core_that_runs_already(board, bitstream):
    board.registers[layout.RegControl] = 1
    with pytest.raises(castray.BusyError):
        castray.Core(bitstream)


def test_no_memory(bitstream, teapot):
    board = SimulatedBoard(memory=1 << 16)
    with castray.Core(bitstream) as core, pytest.raises(castray.NoMemoryError, match="kernel parameter cma="):
        core.render(teapot)
    assert idle(board)


@pytest.mark.parametrize("interrupt", [True, False])
def test_a_job_that_never_starts(board, bitstream, cube, interrupt):
    board.deaf = True
    with castray.Core(bitstream, interrupt=interrupt) as core:
        with pytest.raises(castray.HungError):
            core.render(cube, timeout=0.2)
        board.deaf = False
        assert idle(board)
        assert renders(core, cube)


def test_a_job_that_takes_too_long_loads_the_bitstream_again(board, bitstream, teapot, cube):
    with castray.Core(bitstream) as core:
        with pytest.raises(castray.HungError):
            core.render(teapot, mode="brute", timeout=0.05)
        assert board.downloads == 2 and idle(board)
        assert renders(core, cube)


def test_without_the_overlay_a_hung_core_keeps_its_buffers(board, bitstream, teapot):
    ip, free = pynq.Overlay(str(bitstream)).castray, board.free
    core = castray.Core(ip)
    with pytest.warns(RuntimeWarning, match="could not be brought to rest"), pytest.raises(castray.HungError):
        core.render(teapot, mode="brute", timeout=0.05)
    core.close()
    assert board.free < free, "the core may still write there"
    with pytest.raises(castray.HungError, match="load its bitstream again"):
        core.render(teapot)
