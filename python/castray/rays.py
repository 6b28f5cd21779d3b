# SPDX-License-Identifier: Apache-2.0
"""Rays between scene units and the records of a list (docs/ray-list.md): cpp_model/scene/ray_record.cpp in numpy."""
import numpy as np

from . import _layout as layout
from .errors import RayError
from .records import RAY


def _rounded(x):
    """To the nearest whole number, halves away from zero."""
    whole = np.trunc(x)
    return (whole + np.where(np.abs(x - whole) >= 0.5, np.copysign(1.0, x), 0.0)).astype(np.int64)


def _stretch(directions):
    """Length along a ray of one unit along its dominant axis: 1 to sqrt(3)."""
    d = directions / np.abs(directions).max(axis=1, keepdims=True)
    return np.sqrt(d[:, 0] ** 2 + d[:, 1] ** 2 + d[:, 2] ** 2)


def _vectors(what, value):
    try:
        array = np.asarray(value, np.float64)
    except (TypeError, ValueError) as error:
        raise RayError(f"{what}: not numbers: {error}") from None
    if array.ndim == 1:
        array = array[None]
    if array.ndim != 2 or array.shape[1] != 3:
        raise RayError(f"{what}: an array of shape (rays, 3) is needed, this has {array.shape}")
    if not np.isfinite(array).all():
        raise RayError(f"{what}: of ray {np.flatnonzero(~np.isfinite(array).all(axis=1))[0]} one is not a finite number")
    return array


def _column(what, value, count, dtype):
    try:
        column = np.asarray(value)
        if np.issubdtype(dtype, np.integer) and not np.issubdtype(column.dtype, np.integer):
            if column.dtype.kind != "f" or not (np.isfinite(column) & (column == np.trunc(column))).all():
                raise TypeError("not whole numbers")
        return np.broadcast_to(column.astype(dtype), (count,))
    except (TypeError, ValueError, OverflowError) as error:
        raise RayError(f"{what}: one value, or one for each of the {count} rays, is needed: {error}") from None


def _first(wrong):
    return np.flatnonzero(wrong)[0]


def ray_records(image, origins, directions, tmin=0.0, tmax=np.inf, any_hit=False, cull=False, ignore=None):
    """Records (RAY) of rays in scene units: arrays of shape (rays, 3), directions of any length.

    Hits lie strictly between the distances tmin and tmax. any_hit: only whether there is one. cull: back
    faces are not hit. ignore: the number of a primitive that is not hit. Each of these is one value for
    all rays, or one for each. RayError where a ray cannot be asked.
    """
    origins, directions = _vectors("origins", origins), _vectors("directions", directions)
    if len(origins) == 1:
        origins = np.broadcast_to(origins, directions.shape)
    if origins.shape != directions.shape:
        raise RayError(f"{len(origins)} origins and {len(directions)} directions")
    count = len(directions)
    largest = np.abs(directions).max(axis=1)
    if (largest == 0).any():
        raise RayError(f"directions: that of ray {_first(largest == 0)} is zero")
    tmin, tmax = _column("tmin", tmin, count, np.float64), _column("tmax", tmax, count, np.float64)
    if not (tmin < tmax).all():
        raise RayError(f"tmin, tmax: the range of ray {_first(~(tmin < tmax))} is empty")

    steps = np.ldexp(origins, -image.grid_power) - image.corner
    outside = ~((steps > -1) & (steps < 2.0 ** layout.CoordW)).all(axis=1)
    records = np.zeros(count, RAY)
    for axis, name in enumerate("xyz"):
        # The nearest step from the world's origin, as the compiler of images rounds; what is outside is refused below.
        at = _rounded(np.where(outside, 0, np.ldexp(origins[:, axis], -image.grid_power))) - image.corner[axis]
        outside |= (at < 0) | (at >= 1 << layout.CoordW)
        records[f"org_{name}"] = np.where(outside, 0, at)
    if outside.any():
        raise RayError(f"origins: that of ray {_first(outside)} lies outside the image's grid: "
                       "compile the scene with these origins, castray.compile(scene, origins=...)")

    power = np.frexp(largest)[1] - 1
    t = np.stack([tmin, tmax]) / _stretch(directions)
    t = _rounded(np.clip(np.ldexp(t, layout.TFrac - image.grid_power), 0, layout.TMax))
    for axis, name in enumerate("xyz"):
        records[f"dir_{name}"] = _rounded(np.ldexp(directions[:, axis], layout.DirFrac - power))
    records["tmin"], records["tmax"] = t
    records["flags"] = (_column("any_hit", any_hit, count, bool).astype(np.uint32) << layout.RayAnyHit
                        | _column("cull", cull, count, bool).astype(np.uint32) << layout.RayCull)
    ignore = _column("ignore", layout.NoHit if ignore is None else ignore, count, np.int64)
    if ((ignore != layout.NoHit) & ((ignore < 0) | (ignore >= image.primitives))).any():
        raise RayError(f"ignore: the scene has the primitives 0 to {image.primitives - 1}")
    records["ignore"] = ignore
    return records


def distances(image, rays, hits):
    """Distances in scene units of the hits of a list; inf for a miss, nan where only `any_hit` was asked."""
    directions = np.stack([rays[f"dir_{axis}"] for axis in "xyz"], axis=1).astype(np.float64)
    units = np.ldexp(hits["t"] * _stretch(directions), image.grid_power - layout.TFrac)
    return np.where(hits["prim"] == layout.NoHit, np.inf, np.where(hits["prim"] == layout.AnyHit, np.nan, units))
