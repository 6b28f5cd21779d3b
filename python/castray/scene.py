# SPDX-License-Identifier: Apache-2.0
"""Scenes to images: by the host's C++ code, which comes with the simulated core."""
import os
import pathlib

import numpy as np

from . import _layout as layout
from .errors import ArgumentError, NoCompilerError, SceneError
from .image import SceneImage


def compile(scene, size=None, origins=None):
    """The image of a scene file or a mesh. size: (width, height), else the scene's own.

    With origins, an array of shape (rays, 3), the image is for a list of rays from there: its grid is the
    finest that holds them, and it has no frame.
    """
    scene = _path(scene)
    try:
        from . import _simulation
    except ImportError:
        raise NoCompilerError("this install of castray is pure Python and compiles no scenes. On a PC run "
                              f"`castray compile {scene} -o scene.image` and hand that file to the core") from None
    if size is not None:
        size = size_of(size)
    if origins is not None:
        try:
            origins = np.ascontiguousarray(origins, np.float64)
        except (TypeError, ValueError) as error:
            raise ArgumentError(f"origins: not numbers in an array of shape (rays, 3): {error}") from None
        if origins.ndim != 2 or origins.shape[1] != 3 or not len(origins) or not np.isfinite(origins).all():
            raise ArgumentError(f"origins: finite numbers in an array of shape (rays, 3) are needed, this has {origins.shape}")
    try:
        data, warnings = _simulation.compile(os.fspath(scene), size, origins)
    except _simulation.SceneError as error:
        raise SceneError(str(error)) from None
    image = SceneImage(data)
    image.warnings = warnings
    return image


def image_of(scene, size=None):
    """Whatever a user may call a scene: an image, its bytes, a file of it, a scene file, a mesh."""
    if isinstance(scene, SceneImage):
        image = scene
    elif isinstance(scene, (bytes, bytearray, memoryview, np.ndarray)):
        image = SceneImage(scene)
    else:
        path = _path(scene)
        if not path.is_file():
            raise SceneError(f"{path}: there is no such file")
        with path.open("rb") as file:
            if file.read(4) != layout.ImageMagic.to_bytes(4, "little"):
                return compile(path, size)
        image = SceneImage.load(path)
    if size is not None and size_of(size) != (image.width, image.height):
        raise ArgumentError(f"size: the image is compiled for {image.width}x{image.height}; compile the scene with size={size_of(size)}")
    return image


def size_of(size):
    """(width, height)."""
    try:
        width, height = (int(side) for side in size)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"size: (width, height) is needed, not {size!r}") from None
    if not all(1 <= side <= layout.MaxFrameSize for side in (width, height)):
        raise ArgumentError(f"size: {width}x{height}, each side must be 1 to {layout.MaxFrameSize}")
    return width, height


def _path(scene):
    if not isinstance(scene, (str, os.PathLike)) or "\0" in str(scene):
        what = "a name with a zero byte" if isinstance(scene, (str, os.PathLike)) else type(scene).__name__
        raise ArgumentError(f"scene: the name of a scene file, a mesh or an image is needed, not {what}")
    return pathlib.Path(scene)
