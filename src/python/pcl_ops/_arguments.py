# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What arguments have to be, and the named ones that the extension knows."""

import inspect
from typing import Any, Callable, List, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops

Vector = Union[Sequence[float], NDArray[Any]]


def named_parameters(*lists: str) -> Callable[[Any], Any]:
    """Shows in help, completion and stubs what **parameters may be.

    lists: names of the extension's lists of parameters, which the function takes all.
    """

    def with_names(function):
        signature = inspect.signature(function)
        shown = [one for one in signature.parameters.values() if one.kind != one.VAR_KEYWORD]
        known = {name: rest for one in lists for name, *rest in _pcl_ops.parameters(one, "default")}
        for name, (default, annotation) in known.items():
            # Methods have defaults of their own.
            default = default if len(lists) == 1 else ...
            shown.append(inspect.Parameter(
                name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation))
        function.__signature__ = signature.replace(parameters=shown)
        return function

    return with_names


def check_is_one_of(name: str, value: Any, words: Tuple[str, ...]) -> None:
    if value not in words:
        kind = ValueError if isinstance(value, str) else TypeError
        raise kind(f"{name}: has to be one of {words}, not {value!r:.80}")


def points_array(points: Any) -> NDArray[Any]:
    """The points as an aligned array of the machine's order of bytes, the same one where it is."""
    if isinstance(points, np.ma.MaskedArray):
        raise TypeError("points: a masked array; use points.filled(numpy.nan)")
    array = np.asarray(points)
    if array.dtype.kind != "f" or array.dtype.itemsize not in (4, 8):
        raise TypeError(f"points: dtype {array.dtype} is neither float32 nor float64")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points: shape {array.shape} is not (N, 3)")
    if not 0 < len(array) <= np.iinfo(np.int32).max:
        raise ValueError(f"points: shape {array.shape} has no points, or more than 2^31 - 1")
    if array.dtype.isnative and array.flags.aligned:
        return array  # the very object: by it planes are known to be of one array
    return np.require(array, array.dtype.newbyteorder("="), "A")


def single_precision(points: NDArray[Any]) -> Tuple[NDArray[np.float32], NDArray[np.float64]]:
    """The points as the extension reads them, and where in their frame the zero of these is.

    That is zero where single precision holds all numbers exactly; else it is near most
    points, so that coordinates in the millions keep their millimetres.
    """
    origin = np.zeros(3)
    if points.dtype == np.float32:
        step, side = points.strides
        in_order = side == 4 and step >= 12 and step % 4 == 0
        return (points if in_order else np.ascontiguousarray(points)), origin
    with np.errstate(over="ignore", invalid="ignore"):
        single = points.astype(np.float32, order="C")
        if not ((single == points) | np.isnan(points)).all():
            origin = usual_place(points)
            np.subtract(points, origin, out=single, casting="same_kind")
    return single, origin


def usual_place(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The median of some thousand points: one outlier must not take the digits of all."""
    finite = np.flatnonzero(np.isfinite(points).all(axis=1))
    if not len(finite):
        return np.zeros(3)
    # The first finite point of each stretch, as the programs have it.
    stretches = finite // (len(points) // 1000 + 1)
    some = points[finite[np.flatnonzero(np.diff(stretches, prepend=-1))]]
    return np.sort(some, axis=0)[(len(some) - 1) // 2]


def place(name: str, given: Any) -> NDArray[np.float64]:
    """A finite place."""
    try:
        array = np.asarray(given, float)
    except (TypeError, ValueError):
        array = np.empty(0)
    if array.shape != (3,):
        raise TypeError(f"{name}: has to be three numbers (x, y, z), not {given!r:.80}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: has to be finite, not {given!r:.80}")
    return array


def pose_matrix(pose: Any) -> NDArray[np.float64]:
    """A rigid motion, by default none."""
    array = np.eye(4) if pose is None else np.asarray(pose)
    rounding = 1e-4  # of single precision, multiplied a few times
    is_rigid = array.dtype.kind in "fiu" and array.shape == (4, 4) and np.isfinite(array).all()
    if is_rigid:
        turn = array[:3, :3].astype(float)
        is_rigid = (np.allclose(turn @ turn.T, np.eye(3), atol=rounding) and np.linalg.det(turn) > 0
                    and np.allclose(array[3], (0, 0, 0, 1)))
    if not is_rigid:
        raise ValueError("pose: is no 4 x 4 matrix of a rotation and a translation")
    return array.astype(float)


def plane_numbers(name: str, labels: Any, number: int, none: int) -> NDArray[np.uint32]:
    """Labels as the extension has them: planes from 1, 0 for none."""
    if isinstance(labels, np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array; use {name}.filled(-1)")
    array = np.asarray(labels)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: dtype {array.dtype} is not one of whole numbers")
    if array.shape != (number,):
        raise ValueError(f"{name}: shape {array.shape} is not ({number},), that of the points")
    if array.max() > 2**32 - 3:
        raise ValueError(f"{name}: the label {array.max()} is too large")
    array = array.astype(np.int64)
    return np.where((array < 0) | (array == none), 0, array + 1).astype(np.uint32)


def plane_list(name: str, planes: Any, kind: type) -> List[Any]:
    try:
        planes = list(planes)
        wrong = [plane for plane in planes if not isinstance(plane, kind)]
    except TypeError:
        wrong = [planes]
    if wrong:
        raise TypeError(f"{name}: not a list of pcl_ops.Plane: {wrong[0]!r:.80}")
    return planes
