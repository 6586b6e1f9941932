# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks and converts arguments; shows the named parameters of the extension in signatures."""

import difflib
import inspect
import numbers
import os
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
    return struct.values_and_annotations()


def camera_up() -> Tuple[float, float, float]:
    """Against gravity in the optical frame of a level camera.

    There x points to the right, y down, z ahead: segment(points, up="camera") means it.
    """
    return 0.0, -1.0, 0.0


def file_name(path: Union[str, bytes, "os.PathLike[str]"]) -> bytes:
    """The name of a file for the extension; raises ValueError if it has a NUL, which would end it there."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError(f"path: {name!r:.80} has a NUL; give another name")
    return name


def _vector_of(up: Any) -> Any:
    """The vector that the word "camera" stands for; else what is given."""
    return camera_up() if isinstance(up, str) and up == "camera" else up


def _is_flag(value: Any) -> bool:
    return isinstance(value, (bool, np.bool_))


def checked_flag(name: str, given: Any) -> bool:
    """The given value as a bool; raises TypeError if it is none."""
    if not _is_flag(given):
        raise TypeError(f"{name}: has to be True or False, not {given!r:.80}")
    return bool(given)


def checked_number(
    name: str, given: Any, is_allowed: Callable[[Any], bool], wanted: str,
    number_type: type = float
) -> Any:
    """A finite number of Python or NumPy as a float, or a whole one as an int.

    name: of the argument, for messages, here and in the other functions.
    is_allowed: whether a number is in the range of the argument.
    wanted: what to give, for messages.
    number_type: float or int.
    """
    value = given.item() if isinstance(given, np.generic) else given
    allowed_class, largest = ((numbers.Integral, sys.maxsize) if number_type is int
                              else (numbers.Real, sys.float_info.max))
    is_number = isinstance(value, allowed_class) and not _is_flag(value)
    if not (is_number and abs(value) <= largest and is_allowed(value)):
        raise (ValueError if is_number else TypeError)(
            f"{name}: has to be {wanted}, not {value!r:.80}")
    return number_type(value)


def _set(struct: Any, name: str, annotation: str, value: Any) -> None:
    """Sets one parameter of a struct; raises ValueError or TypeError for a wrong value."""
    try:
        if (annotation == "bool") != _is_flag(value):
            raise RuntimeError  # every value would convert to bool, and bool to numbers
        struct.set(name, _vector_of(value) if name == "up" else value)
    except RuntimeError:
        is_word = "Literal" in annotation and isinstance(value, str)
        is_number = ("int" in annotation and hasattr(value, "__index__")
                     and not (is_word or _is_flag(value)))
        wanted = annotation.replace("Vector", "three numbers (x, y, z)")
        if name == "up":
            wanted += ", 'camera' or, for segment, 'auto'"
        raise (ValueError if is_word or is_number else TypeError)(
            f"{name}: has to be {wanted}{' within its range' if is_number else ''}, "
            f"not {value!r:.80}") from None


def did_you_mean(name: Any, known: Iterable[str]) -> str:
    """What to add to the message about an unknown name; empty if no known name is similar."""
    similar_names = difflib.get_close_matches(str(name), list(known), 1)
    return f"; did you mean {similar_names[0]}?" if similar_names else ""


def with_given(preset: Any, given: Dict[str, Any]) -> Any:
    """A copy of the preset, a struct of the extension, with the parameters that the user gives."""

    def copy_with(some_of_given):
        struct = type(preset)(preset)
        known = parameters_of(struct)
        for name, value in some_of_given.items():
            if name not in known:
                hint = did_you_mean(name, known) or f"; there are {', '.join(known)}"
                raise ValueError(f"{name}: unknown parameter{hint}")
            _, annotation = known[name]
            _set(struct, name, annotation, value)
        return struct

    struct = copy_with(given)
    problem = struct.problem()
    if problem:
        # The first parameter that causes the problem by itself, if there is one.
        at_fault = [name for name in given
                    if copy_with({name: given[name]}).problem() == problem]
        raise ValueError(": ".join([*at_fault[:1], problem]))
    return struct


def named_parameters(*structs: str, **annotations: str) -> Callable[[Any], Any]:
    """A decorator: help, completion and stubs show which **parameters a function takes.

    structs: names of the extension's structs, whose parameters the function takes.
    annotations: by the name of a parameter, in place of that of the extension: for parameters
        that may also have values of another type.
    """

    def with_names(function):
        signature = inspect.signature(function)
        shown = {name: parameter for name, parameter in signature.parameters.items()
                 if name != "parameters"}
        for struct in structs:
            for name, (value, annotation) in parameters_of(getattr(_pcl_ops, struct)()).items():
                if name in signature.parameters:
                    continue
                # Several structs may have different defaults for one parameter.
                default = value if len(structs) == 1 else ...
                shown[name] = inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY,
                                                default=default,
                                                annotation=annotations.get(name, annotation))
        function.__signature__ = signature.replace(parameters=list(shown.values()))
        return function

    return with_names


def plain_array(name: str, numbers: Any, instead: str) -> NDArray[Any]:
    """The numbers as an array; raises TypeError for a masked one.

    instead: what users may fill masked entries with, for the message.
    """
    if isinstance(numbers, np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array; use {name}.filled({instead})")
    return np.asarray(numbers)


def _rows_of_three(array: NDArray[Any]) -> NDArray[Any]:
    """The points as rows x, y, z, in shape (N, 3).

    array: rows or an image of points, which may have a fourth number, such as an intensity.
    """
    if array.ndim not in (2, 3) or array.shape[-1] not in (3, 4):
        fix = ""
        if array.ndim == 2 and array.shape[0] == 3:
            fix = "; give points.T"
        elif array.ndim in (2, 3) and array.shape[-1] > 4:
            fix = "; give points[..., :3] if the first three are x, y and z"
        raise ValueError(f"points: shape {array.shape} is none of (N, 3), (N, 4), (H, W, 3) and "
                         f"(H, W, 4){fix}")
    rows = array if array.ndim == 2 else array.reshape(-1, array.shape[-1])
    return rows if rows.shape[1] == 3 else rows[:, :3]


def points_array(points: Any) -> NDArray[Any]:
    """The points as rows x, y, z, aligned and in the machine's byte order.

    It is a view of the given array if that is aligned and in this byte order already.
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
    """Whether both are the same numbers in memory, as two views of one image are."""
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
    """The rounded median of a sample of distinct places, as localOrigin of the programs.

    Hashes choose the sample, so that the result is the same for any order of the points. Neither
    single outliers nor many equal points change it much. Zero if no point is finite.
    """
    sample_size = 8192
    # The median is rounded to multiples of a power of two, at least this many deviations.
    step_in_deviations = 16.0
    largest_lower_half = 2**32 - 1  # of the 64 bits of a hash
    hashes = _hashes(points)
    # Points are taken up to this value of the lower half.
    last_taken = largest_lower_half // (len(points) // sample_size + 1)
    is_finite = np.isfinite(points).all(axis=1)
    lower_halves = hashes & np.uint64(largest_lower_half)
    taken = np.flatnonzero(is_finite & (lower_halves <= last_taken))
    if not len(taken):
        taken = np.flatnonzero(is_finite)
    if not len(taken):
        return np.zeros(3)
    # Equal points have equal hashes.
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
    """The given numbers as an array of this size.

    wanted: what to give, for messages.
    """
    try:
        array = np.asarray(given, float).reshape(size)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: has to be {wanted}, not {given!r:.80}") from None
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: has to be finite, not {given!r:.80}")
    return array


def up_direction(given: Any) -> NDArray[np.float64]:
    """The unit vector of an up argument: a vector of any length but 0, or the word "camera"."""
    array = finite_vector("up", _vector_of(given), "three numbers (x, y, z) or 'camera'")
    largest = np.abs(array).max()
    if not largest >= np.finfo(float).tiny:
        raise ValueError("up: has no direction")
    array = array / largest  # squares of huge numbers are infinite
    return array / np.linalg.norm(array)


def pose_matrix(pose: Any) -> NDArray[np.float64]:
    """The (4, 4) matrix of a rigid motion; the identity for None."""
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
    name: str, given: Any, type_codes: str, instead: str, shape: Tuple[int, ...], things: str
) -> NDArray[Any]:
    """An array without a mask, of one number for each thing.

    type_codes: NumPy's codes that the type may have, "iu" for integers or "f" for floats.
    instead: what users may fill masked entries with, for the message.
    things: what there are numbers for, in the plural, for the message.
    """
    array = plain_array(name, given, instead)
    if array.dtype.kind not in type_codes:
        wanted = "floating point" if type_codes == "f" else "whole"
        raise TypeError(f"{name}: dtype {array.dtype} is not one of {wanted} numbers")
    if array.shape != shape:
        raise ValueError(f"{name}: shape {array.shape} is not {shape}, that of the {things}")
    return array


def plane_numbers(
    name: str, labels: Any, shape: Tuple[int, ...], none: int
) -> NDArray[np.uint32]:
    """Labels as the extension has them: each label plus 1, and 0 for no plane.

    shape: of the array of the points, without its last dimension.
    none: the label that stands for no plane, besides negative ones.
    """
    array = array_of(name, labels, "iu", "-1", shape, "points").ravel()
    # A label plus 1 has to be below 2^32 - 1.
    if array.max() > 2**32 - 3:
        raise ValueError(f"{name}: the label {array.max()} is too large")
    array = array.astype(np.int64)
    return np.where((array < 0) | (array == none), 0, array + 1).astype(np.uint32)
