# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What arguments have to be, and the named ones that the extension knows."""

import difflib
import inspect
from typing import Any, Callable, Dict, Iterable, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops

Points = Union[NDArray[np.float32], NDArray[np.float64]]
Vector = Union[Sequence[float], NDArray[Any]]


def parameters_of(struct: Any) -> Dict[str, Tuple[Any, str]]:
    """Value and annotation of each by its name."""
    return struct.values_and_kinds()


def camera_up() -> Tuple[float, float, float]:
    """Against gravity in the optical frame of a level camera.

    There x points to the right, y down, z ahead: segment(points, up="camera") means it.
    """
    return 0.0, -1.0, 0.0


def _set(struct: Any, name: str, kind: str, value: Any) -> None:
    try:
        if kind == "bool" and not isinstance(value, (bool, np.bool_)):
            raise RuntimeError  # everything converts to it
        if name == "up" and isinstance(value, str):
            if value != "camera":
                raise RuntimeError
            value = camera_up()
        struct.set(name, value)
    except RuntimeError:
        is_word = "Literal" in kind and isinstance(value, str)
        is_number = "int" in kind and not is_word and hasattr(value, "__index__")
        wanted = kind.replace("Vector", "three numbers (x, y, z)")
        if name == "up":
            wanted += ", 'camera' or, for segment, 'auto'"
        raise (ValueError if is_word or is_number else TypeError)(
            f"{name}: has to be {wanted}{' within its range' if is_number else ''}, "
            f"not {value!r:.80}") from None


def did_you_mean(name: Any, known: Iterable[str]) -> str:
    """What to add to the message on an unknown name; empty where none is like it."""
    like = difflib.get_close_matches(str(name), list(known), 1)
    return f"; did you mean {like[0]}?" if like else ""


def with_given(preset: Any, given: Dict[str, Any]) -> Any:
    """The extension's struct with those parameters set that the user gives."""

    def with_some(some):
        struct = type(preset)(preset)
        known = parameters_of(struct)
        for name, value in some.items():
            if name not in known:
                hint = did_you_mean(name, known) or f"; there are {', '.join(known)}"
                raise ValueError(f"{name}: unknown parameter{hint}")
            _set(struct, name, known[name][1], value)
        return struct, struct.problem()

    struct, problem = with_some(given)
    if problem:
        at_fault = [name for name in given if with_some({name: given[name]})[1] == problem]
        raise ValueError(": ".join([*at_fault[:1], problem]))
    return struct


def named_parameters(*lists: str, **kinds: str) -> Callable[[Any], Any]:
    """Shows in help, completion and stubs what **parameters may be.

    lists: names of the extension's structs of parameters, which the function takes all.
    kinds: annotations of those that may be something else besides.
    """

    def with_names(function):
        signature = inspect.signature(function)
        shown = {name: one for name, one in signature.parameters.items() if name != "parameters"}
        for one in lists:
            for name, (value, kind) in parameters_of(getattr(_pcl_ops, one)()).items():
                # Methods have defaults of their own.
                default = value if len(lists) == 1 else ...
                shown[name] = inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY,
                                                default=default,
                                                annotation=kinds.get(name, kind))
        function.__signature__ = signature.replace(parameters=list(shown.values()))
        return function

    return with_names


def plain_array(name: str, numbers: Any, instead: str) -> NDArray[Any]:
    if isinstance(numbers, np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array; use {name}.filled({instead})")
    return np.asarray(numbers)


def _rows_of_three(array: NDArray[Any]) -> NDArray[Any]:
    """Of rows or an image of points, which may have a fourth number each, as an intensity."""
    if array.ndim not in (2, 3) or array.shape[-1] not in (3, 4):
        instead = ""
        if array.ndim == 2 and array.shape[0] == 3:
            instead = "; give points.T"
        elif array.ndim in (2, 3) and array.shape[-1] > 4:
            instead = "; give points[..., :3] if the first three are x, y and z"
        raise ValueError(f"points: shape {array.shape} is none of (N, 3), (N, 4), (H, W, 3) and "
                         f"(H, W, 4){instead}")
    rows = array if array.ndim == 2 else array.reshape(-1, array.shape[-1])
    return rows if rows.shape[1] == 3 else rows[:, :3]


def points_array(points: Any) -> NDArray[Any]:
    """The points as aligned rows of the machine's order of bytes, the same array where it is."""
    if not isinstance(points, np.ndarray) and hasattr(points, "points"):
        raise TypeError(f"points: a {type(points).__name__} is no array; give its .points, as "
                        "numpy.asarray(cloud.points)")
    array = plain_array("points", points, "numpy.nan")
    if array.dtype.kind != "f" or array.dtype.itemsize not in (4, 8):
        raise TypeError(f"points: dtype {array.dtype} is neither float32 nor float64")
    rows = _rows_of_three(array)
    if not 0 < len(rows) <= np.iinfo(np.int32).max:
        raise ValueError(f"points: shape {array.shape} has no points, or more than 2^31 - 1")
    if rows.dtype.isnative and rows.flags.aligned:
        return rows
    return np.require(rows, rows.dtype.newbyteorder("="), "A")


def is_same_array(one: NDArray[Any], other: NDArray[Any]) -> bool:
    """Whether both are the same rows in memory, as those of an image that was given twice."""
    return one is other or one.__array_interface__ == other.__array_interface__


def _hashes(places: NDArray[np.float64]) -> NDArray[np.uint64]:
    """Numbers as good as drawn, but the same for a place wherever it stands."""
    hashes = np.zeros(len(places), np.uint64)
    for axis in range(3):
        # Zero and minus zero are one.
        hashes ^= (np.ascontiguousarray(places[:, axis]) + 0.0).view(np.uint64)
        hashes *= np.uint64(0x9e3779b97f4a7c15)
        hashes ^= hashes >> np.uint64(32)
    return hashes


def _place_near_most(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The median of some places, by their hashes, rounded, as the programs have it.

    It is the same for any order of the points. One outlier must not take the digits of all, nor
    many points at one place.
    """
    looked_at, deviations = 8192, 16.0
    hashes = _hashes(points)
    last_taken = (2**32 - 1) // (len(points) // looked_at + 1)
    is_finite = np.isfinite(points).all(axis=1)
    taken = np.flatnonzero(is_finite & ((hashes & np.uint64(2**32 - 1)) <= last_taken))
    if not len(taken):
        taken = np.flatnonzero(is_finite)
    if not len(taken):
        return np.zeros(3)
    some = points[taken[np.unique(hashes[taken], return_index=True)[1]]]
    middle = (len(some) - 1) // 2
    median = np.sort(some, axis=0)[middle]
    deviation = np.sort(np.abs(some - median), axis=0)[middle].max()
    if not (deviation > 0.0 and np.isfinite(deviation)):
        return median
    step = np.exp2(np.ceil(np.log2(deviations * deviation)))
    return np.floor(median / step + 0.5) * step


def single_precision(points: NDArray[Any]) -> Tuple[NDArray[np.float32], NDArray[np.float64]]:
    """The points as the extension reads them, and where in their frame the zero of these is.

    That is zero where single precision holds all numbers exactly; else it is near most
    points, so that coordinates in the millions keep their millimeters.
    """
    origin = np.zeros(3)
    if points.dtype == np.float32:
        step, side = points.strides
        in_order = side == 4 and step >= 12 and step % 4 == 0
        return (points if in_order else np.ascontiguousarray(points)), origin
    with np.errstate(over="ignore", invalid="ignore"):
        single = points.astype(np.float32, order="C")
        is_exact = ((single == points) | np.isnan(points)).all()
        if not is_exact:
            origin = _place_near_most(points)
            np.subtract(points, origin, out=single, casting="same_kind")
    return single, origin


def place(name: str, given: Any) -> NDArray[np.float64]:
    try:
        array = np.asarray(given, float).reshape(3)
    except (TypeError, ValueError):
        raise TypeError(
            f"{name}: has to be three numbers (x, y, z), not {given!r:.80}") from None
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: has to be finite, not {given!r:.80}")
    return array


def direction(name: str, given: Any) -> NDArray[np.float64]:
    """A unit vector along what is given, which may have any length but 0."""
    array = place(name, given)
    longest = np.abs(array).max()
    if not longest >= np.finfo(float).tiny:
        raise ValueError(f"{name}: has no direction")
    array = array / longest  # squares of huge numbers are infinite
    return array / np.linalg.norm(array)


def pose_matrix(pose: Any) -> NDArray[np.float64]:
    """A rigid motion, by default none."""
    array = np.eye(4) if pose is None else np.asarray(pose)
    if array.dtype.kind in "fiu" and array.shape == (4, 4) and np.isfinite(array).all():
        array = array.astype(float)
        turn = array[:3, :3]
        rounding = 1e-4  # of single precision, multiplied a few times
        if (np.allclose(turn @ turn.T, np.eye(3), atol=rounding) and np.linalg.det(turn) > 0
                and np.allclose(array[3], (0, 0, 0, 1))):
            return array
    raise ValueError("pose: is no 4 x 4 matrix of a rotation and a translation")


def plane_numbers(
    name: str, labels: Any, of_points: Tuple[int, ...], none: int
) -> NDArray[np.uint32]:
    """Labels as the extension has them: planes from 1, 0 for none.

    of_points: the shape of the array of the points without its last side.
    """
    array = plain_array(name, labels, "-1")
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: dtype {array.dtype} is not one of whole numbers")
    if array.shape != of_points:
        raise ValueError(f"{name}: shape {array.shape} is not {of_points}, that of the points")
    array = array.ravel()
    if array.max() > 2**32 - 3:
        raise ValueError(f"{name}: the label {array.max()} is too large")
    array = array.astype(np.int64)
    return np.where((array < 0) | (array == none), 0, array + 1).astype(np.uint32)
