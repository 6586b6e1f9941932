# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks and converts arguments, and shows the named ones that the extension has."""

import difflib
import inspect
import numbers
import sys
from typing import Any, Callable, Dict, Iterable, Literal, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops

Points = Union[NDArray[np.float32], NDArray[np.float64]]
Vector = Union[Sequence[float], NDArray[Any]]
Up = Union[Vector, Literal["camera"]]


def parameters_of(struct: Any) -> Dict[str, Tuple[Any, str]]:
    """Value and annotation of each parameter, by its name."""
    return struct.values_and_kinds()


def camera_up() -> Tuple[float, float, float]:
    """Against gravity in the optical frame of a level camera.

    There x points to the right, y down, z ahead: segment(points, up="camera") means it.
    """
    return 0.0, -1.0, 0.0


def _vector_of(up: Any) -> Any:
    """The vector that the word "camera" stands for; else what is given."""
    return camera_up() if isinstance(up, str) and up == "camera" else up


def _is_flag(value: Any) -> bool:
    return isinstance(value, (bool, np.bool_))


def flag(name: str, given: Any) -> bool:
    if not _is_flag(given):
        raise TypeError(f"{name}: has to be True or False, not {given!r:.80}")
    return bool(given)


def checked_number(
    name: str, given: Any, is_allowed: Callable[[Any], bool], wanted: str, kind: type = float
) -> Any:
    """A finite number of Python or NumPy as a float, or a whole one as an int.

    is_allowed: whether a number is in its range.
    wanted: what to give, for messages.
    kind: float or int.
    """
    value = given.item() if isinstance(given, np.generic) else given
    base, largest = ((numbers.Integral, sys.maxsize) if kind is int
                     else (numbers.Real, sys.float_info.max))
    is_number = isinstance(value, base) and not _is_flag(value)
    if not (is_number and abs(value) <= largest and is_allowed(value)):
        raise (ValueError if is_number else TypeError)(
            f"{name}: has to be {wanted}, not {value!r:.80}")
    return kind(value)


def _set(struct: Any, name: str, kind: str, value: Any) -> None:
    """Sets one parameter of a struct; kind is its annotation."""
    try:
        if (kind == "bool") != _is_flag(value):
            raise RuntimeError  # every value would convert to bool, and bool to numbers
        struct.set(name, _vector_of(value) if name == "up" else value)
    except RuntimeError:
        is_word = "Literal" in kind and isinstance(value, str)
        is_number = "int" in kind and hasattr(value, "__index__") and not (is_word or _is_flag(value))
        wanted = kind.replace("Vector", "three numbers (x, y, z)")
        if name == "up":
            wanted += ", 'camera' or, for segment, 'auto'"
        raise (ValueError if is_word or is_number else TypeError)(
            f"{name}: has to be {wanted}{' within its range' if is_number else ''}, "
            f"not {value!r:.80}") from None


def did_you_mean(name: Any, known: Iterable[str]) -> str:
    """What to add to the message on an unknown name; empty if no known name is like it."""
    similar_names = difflib.get_close_matches(str(name), list(known), 1)
    return f"; did you mean {similar_names[0]}?" if similar_names else ""


def with_given(preset: Any, given: Dict[str, Any]) -> Any:
    """A copy of the extension's struct with the parameters set that the user gives."""

    def copy_with(some):
        struct = type(preset)(preset)
        known = parameters_of(struct)
        for name, value in some.items():
            if name not in known:
                hint = did_you_mean(name, known) or f"; there are {', '.join(known)}"
                raise ValueError(f"{name}: unknown parameter{hint}")
            _, kind = known[name]
            _set(struct, name, kind, value)
        return struct

    struct = copy_with(given)
    problem = struct.problem()
    if problem:
        at_fault = [name for name in given
                    if copy_with({name: given[name]}).problem() == problem]
        raise ValueError(": ".join([*at_fault[:1], problem]))
    return struct


def named_parameters(*lists: str, **kinds: str) -> Callable[[Any], Any]:
    """Shows in help, completion and stubs what **parameters may be, besides those the function names.

    lists: names of the extension's structs of parameters, all of which the function takes.
    kinds: annotations of parameters that may also have values of another type.
    """

    def with_names(function):
        signature = inspect.signature(function)
        shown = {name: parameter for name, parameter in signature.parameters.items()
                 if name != "parameters"}
        for struct in lists:
            for name, (value, kind) in parameters_of(getattr(_pcl_ops, struct)()).items():
                if name in signature.parameters:
                    continue
                # Of several structs, each may have another default for a parameter.
                default = value if len(lists) == 1 else ...
                shown[name] = inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY,
                                                default=default,
                                                annotation=kinds.get(name, kind))
        function.__signature__ = signature.replace(parameters=list(shown.values()))
        return function

    return with_names


def plain_array(name: str, numbers: Any, instead: str) -> NDArray[Any]:
    """An array without a mask; instead: what users may fill masked entries with."""
    if isinstance(numbers, np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array; use {name}.filled({instead})")
    return np.asarray(numbers)


def _rows_of_three(array: NDArray[Any]) -> NDArray[Any]:
    """x, y, z of rows or an image of points, which may have a fourth number, as an intensity."""
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
    """The points as aligned rows in the machine's byte order; the same array if it is so already.
    """
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


def _hashes(points: NDArray[np.float64]) -> NDArray[np.uint64]:
    """Pseudo-random numbers that depend on the coordinates of a point alone."""
    golden_ratio = np.uint64(0x9e3779b97f4a7c15)  # 2^64 / 1.618..., as in Fibonacci hashing
    hashes = np.zeros(len(points), np.uint64)
    for axis in range(3):
        # Adding 0 makes -0 equal to 0.
        hashes ^= (np.ascontiguousarray(points[:, axis]) + 0.0).view(np.uint64)
        hashes *= golden_ratio
        hashes ^= hashes >> np.uint64(32)
    return hashes


def _origin_near_most(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The rounded median of a sample of distinct places, as the programs have it.

    Hashes choose the sample, so that the result is the same for any order of the points. Neither
    one outlier nor many equal points decide about it.
    """
    sample_size = 8192
    step_in_deviations = 16.0  # lower bound of the rounding step, a power of two
    largest_hash = 2**32 - 1  # of the lower half of the bits
    hashes = _hashes(points)
    last_taken = largest_hash // (len(points) // sample_size + 1)
    is_finite = np.isfinite(points).all(axis=1)
    taken = np.flatnonzero(is_finite & ((hashes & np.uint64(largest_hash)) <= last_taken))
    if not len(taken):
        taken = np.flatnonzero(is_finite)
    if not len(taken):
        return np.zeros(3)
    _, first_of_place = np.unique(hashes[taken], return_index=True)
    places = points[taken[first_of_place]]
    middle = (len(places) - 1) // 2
    median = np.sort(places, axis=0)[middle]
    # The largest of the median absolute deviations along the axes.
    deviation = np.sort(np.abs(places - median), axis=0)[middle].max()
    if not (deviation > 0.0 and np.isfinite(deviation)):
        return median
    step = np.exp2(np.ceil(np.log2(step_in_deviations * deviation)))
    return np.floor(median / step + 0.5) * step


def single_precision(points: NDArray[Any]) -> Tuple[NDArray[np.float32], NDArray[np.float64]]:
    """The points in single precision, and the origin that they are relative to.

    The origin is zero if single precision holds all numbers exactly; else it is near most
    points, so that coordinates in the millions keep their millimeters.
    """
    origin = np.zeros(3)
    if points.dtype == np.float32:
        bytes_per_row, bytes_per_number = points.strides
        is_readable = (bytes_per_number == 4 and bytes_per_row >= 12
                       and bytes_per_row % 4 == 0)
        return (points if is_readable else np.ascontiguousarray(points)), origin
    with np.errstate(over="ignore", invalid="ignore"):
        single = points.astype(np.float32, order="C")
        is_exact = ((single == points) | np.isnan(points)).all()
        if not is_exact:
            origin = _origin_near_most(points)
            np.subtract(points, origin, out=single, casting="same_kind")
    return single, origin


def finite_vector(
    name: str, given: Any, wanted: str = "three numbers (x, y, z)", size: int = 3
) -> NDArray[np.float64]:
    """An array of this size; wanted: what to give, for messages."""
    try:
        array = np.asarray(given, float).reshape(size)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: has to be {wanted}, not {given!r:.80}") from None
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: has to be finite, not {given!r:.80}")
    return array


def up_direction(given: Any) -> NDArray[np.float64]:
    """The unit vector along an up, which is a vector of any length but 0 or the word "camera"."""
    array = finite_vector("up", _vector_of(given), "three numbers (x, y, z) or 'camera'")
    longest = np.abs(array).max()
    if not longest >= np.finfo(float).tiny:
        raise ValueError("up: has no direction")
    array = array / longest  # squares of huge numbers are infinite
    return array / np.linalg.norm(array)


def pose_matrix(pose: Any) -> NDArray[np.float64]:
    """The matrix of a rigid motion; None is the identity."""
    array = np.eye(4) if pose is None else np.asarray(pose)
    if array.dtype.kind in "fiu" and array.shape == (4, 4) and np.isfinite(array).all():
        array = array.astype(float)
        rotation = array[:3, :3]
        rounding = 1e-4  # of a product of several matrices in single precision
        if (np.allclose(rotation @ rotation.T, np.eye(3), atol=rounding)
                and np.linalg.det(rotation) > 0
                and np.allclose(array[3], (0, 0, 0, 1))):
            return array
    raise ValueError("pose: is no 4 x 4 matrix of a rotation and a translation")


def array_of(
    name: str, given: Any, kinds: str, instead: str, shape: Tuple[int, ...], things: str
) -> NDArray[Any]:
    """An array without a mask, of one number for each thing.

    kinds: the codes that the type may have, "iu" or "f".
    instead: what users may fill masked entries with.
    """
    array = plain_array(name, given, instead)
    if array.dtype.kind not in kinds:
        of = "floating point" if kinds == "f" else "whole"
        raise TypeError(f"{name}: dtype {array.dtype} is not one of {of} numbers")
    if array.shape != shape:
        raise ValueError(f"{name}: shape {array.shape} is not {shape}, that of the {things}")
    return array


def plane_numbers(
    name: str, labels: Any, of_points: Tuple[int, ...], none: int
) -> NDArray[np.uint32]:
    """Labels as the extension has them: planes from 1, 0 for none.

    of_points: the shape of the array of the points without its last dimension.
    none: the label that stands for no plane, besides negative ones.
    """
    array = array_of(name, labels, "iu", "-1", of_points, "points").ravel()
    # Planes are counted from 1 below, and their numbers have to stay below 2^32 - 1.
    if array.max() > 2**32 - 3:
        raise ValueError(f"{name}: the label {array.max()} is too large")
    array = array.astype(np.int64)
    return np.where((array < 0) | (array == none), 0, array + 1).astype(np.uint32)
