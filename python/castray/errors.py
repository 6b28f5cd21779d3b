# SPDX-License-Identifier: Apache-2.0
"""What can go wrong: each says what it is and what to do next."""


class CastrayError(Exception):
    """Any of these."""


class NoBoardError(CastrayError):
    """There is no board, or PYNQ is not installed."""


class NoOverlayError(CastrayError):
    """The bitstream is not there, or castray is not in it."""


class NoSimulationError(CastrayError):
    """This install has no simulated core, or not the one that was asked for."""


class NoCompilerError(CastrayError):
    """This install cannot compile scenes."""


class VersionError(CastrayError):
    """The core is of another version than this package, or is none."""


class BusyError(CastrayError):
    """The core runs a job that is not ours."""


class SceneError(CastrayError, ValueError):
    """A scene file is wrong: file, place, cause."""


class ImageError(CastrayError, ValueError):
    """Bytes that are no scene image, or not one for this core."""


class RayError(CastrayError, ValueError):
    """Rays that cannot be asked."""


class ArgumentError(CastrayError, ValueError):
    """Another argument that cannot be."""


class BufferSizeError(CastrayError, ValueError):
    """A buffer is too small, or does not lie where the core can take it."""


class NoMemoryError(CastrayError, MemoryError):
    """The device has no memory left for a buffer."""


class JobError(CastrayError):
    """The core ended a job with an error; `code` is its number. The core is idle."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


class HungError(CastrayError, TimeoutError):
    """A job did not end in time."""


class SimulationError(CastrayError):
    """The simulated core broke a rule of its bus."""
