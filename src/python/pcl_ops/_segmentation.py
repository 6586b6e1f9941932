# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The planes of an array, and how right they are."""

from typing import Any, Dict, List, Literal, Optional, Tuple, Union, get_args

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops
from ._arguments import Points, Vector, named_parameters, parameters_of, place, plane_numbers
from ._arguments import points_array, single_precision, with_given
from ._planes import MAX_WARNINGS, FoundPlanes, Labels, Plane, ResultWarning, name_together

Method = Literal["ops", "fspf", "kht"]
Preset = Literal["default", "paper"]


def _preset(method: Any, preset: Any) -> Any:
    for name, value, words in (("method", method, get_args(Method)),
                               ("preset", preset, get_args(Preset))):
        if value not in words:
            raise (ValueError if isinstance(value, str) else TypeError)(
                f"{name}: has to be one of {words}, not {value!r:.80}")
    kind = getattr(_pcl_ops, method)
    return kind.paper() if preset == "paper" else kind()


def _gap(piece_gap: Any) -> float:
    if not isinstance(piece_gap, (int, float)) or not 1.0 <= piece_gap < float("inf"):
        raise ValueError(
            f"piece_gap: has to be a number of spacings from 1, not {piece_gap!r:.80}")
    return float(piece_gap)


@named_parameters("ops", "fspf", "kht", up="Union[Vector, Literal['auto', 'camera']]")
def segment(
    points: Points, method: Method = "ops", preset: Preset = "default", *,
    viewpoint: Vector = (0.0, 0.0, 0.0), pieces: bool = False, piece_gap: float = 8.0,
    **parameters: Any,
) -> Tuple[Labels, FoundPlanes]:
    """Find all planes of a point cloud.

    points: array of float32 or float64 of shape (N, 3), or (H, W, 3) as of an image; a fourth
        number of each point is not looked at. Rows with NaN or infinite numbers are on no
        plane. float32 with its rows in order is read where it is, all else is copied as
        float32; float64 relative to a place among the points where float32 could not hold
        it. Other threads must not change it meanwhile.
    method: "ops" (Oriented Point Sampling), "fspf" (Fast Sampling Plane Filtering) or
        "kht" (3D Kernel-based Hough Transform).
    preset: "default" or "paper", what the other parameters are by default.
    viewpoint: where the sensor was; normals point towards it. (0, 0, 0) says nothing where
        the points were not seen from there: normals of planes that are not vertical point up.
    pieces: whether each connected piece of a plane is one by itself, with the plane it lies on
        as lies_on.
    piece_gap: widest gap within a piece, in spacings of the points around it.
    parameters: see pcl_ops.parameters(method), with the values of the preset.
        distance_threshold, min_points, up=(x, y, z), angle_tolerance, seed and threads
        (0: all) are those of all methods. up="camera" is camera_up(); up="auto" is what the planes tell
        (estimate_up_axis), with planes.up and planes.up_confidence.

    Returns (labels, planes): an int32 array of shape (N,), or (H, W), with the position in
    planes of the plane each point is on, -1 on none; and a list of Plane by falling number
    of points, in the frame of the array, which has what was used, too.

    Raises ValueError or TypeError, which name the argument at fault. Warns by ResultWarning of
    what is doubtful, also where no up is given and the planes suggest another one than z, or
    where they cannot tell "auto"; planes.warnings has the same.
    """
    by_default = _preset(method, preset)
    sensor = place("viewpoint", viewpoint)
    array = points_array(points)
    single, origin = single_precision(array)
    seen = single, origin, sensor
    found_up = None
    on_up = None
    is_up_known = "up" in parameters
    if _is_auto(parameters.get("up")):
        found_up = _up_of_default(seen, parameters)
        on_up = None if found_up else ResultWarning(
            "unknown-up", "up: the planes cannot tell, (0, 0, 1) is used; give up=(x, y, z)")
        parameters["up"] = (0.0, 0.0, 1.0) if found_up is None else found_up[0]
    given = with_given(by_default, parameters)
    segments, voxel_size, distance_threshold = _pcl_ops.segment(*seen, given)
    if "up" not in parameters and (method, preset) == ("ops", "default"):
        on_up = _hint_at_up(seen, segments, given)
    doubts = _doubts(seen, segments, given, is_up_known)
    lies_on = [None] * len(segments)
    if pieces:
        segments, lies_on = _pcl_ops.pieces(
            single, origin, segments, _gap(piece_gap), parameters.get("threads", 1))
    planes = FoundPlanes(Plane(segment, array) for segment in segments)
    for plane, number in zip(planes, lies_on):
        plane._lies_on = number
    planes.voxel_size, planes.distance_threshold = voxel_size, distance_threshold
    planes.up = parameters_of(given)["up"][0]
    planes.up_confidence = found_up and found_up[1]
    name_together(planes, planes.up, sensor)
    # That kinds need to know up is told where somebody asks for them.
    planes._of_kinds = None if on_up else next(
        (doubt for doubt in doubts if doubt.code == "unknown-up"), None)
    told = [doubt for doubt in doubts if doubt.code != "unknown-up"]
    for doubt in ([on_up] if on_up else []) + told[:MAX_WARNINGS]:
        planes._warn(doubt, 3)
    labels = np.full(len(array), -1, np.int32)
    for number, plane in enumerate(planes):
        labels[plane.inliers] = number
    return labels.reshape(np.shape(points)[:-1]), planes


# The points, their zero and the sensor's place, as the extension takes them.
_Seen = Tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.float64]]


def _is_auto(up: Any) -> bool:
    return isinstance(up, str) and up == "auto"


def _up_of(seen: _Seen, segments: Any) -> Optional[Tuple[NDArray[np.float64], float]]:
    """Direction and confidence, where the sensor's place may be the true one."""
    single, origin, sensor = seen
    found = _pcl_ops.up_axis(segments, sensor, _pcl_ops.estimate_up_axis())
    return found if found and _pcl_ops.is_seen_from(single, sensor - origin) else None


def _up_of_default(
    seen: _Seen, parameters: Dict[str, Any]
) -> Optional[Tuple[NDArray[np.float64], float]]:
    """By the planes of the default preset, on which the confidence was measured."""
    known = {name: parameters[name] for name in ("seed", "threads") if name in parameters}
    return _up_of(seen, _pcl_ops.segment(*seen, with_given(_pcl_ops.ops(), known))[0])


def _hint_at_up(seen: _Seen, segments: Any, used: Any) -> Optional[ResultWarning]:
    """Names another axis than the one used where the planes are sure of it."""
    found = _up_of(seen, segments)
    known = parameters_of(used)
    # Planes have the same names upside down.
    if not found or abs(found[0] @ known["up"][0]) >= np.cos(known["angle_tolerance"][0]):
        return None
    x, y, z = np.round(found[0], 2) + 0.0  # the sum turns -0 into 0
    return ResultWarning(
        "suggested-up", f"planes suggest that up is {x:.2f}, {y:.2f}, {z:.2f}: give up=\"auto\", "
        "or up=(0, 0, 1) where z is")


def _doubts(seen: _Seen, segments: Any, used: Any, is_up_known: bool) -> List[ResultWarning]:
    """What the programs say, the most important first."""
    single, origin, sensor = seen
    known = parameters_of(used)
    context = _pcl_ops.ResultContext()
    if sensor.any():
        context.viewpoint = sensor
    context.uses_kinds = True
    context.set_up(np.asarray(known["up"][0], np.float64), is_up_known)
    if "sampling" in known and known["sampling"][0] in ("automatic", "neighborhoods") and (
            known["surfels_voxel_size"][0] is None):
        context.search = used
    return [ResultWarning(*doubt) for doubt in _pcl_ops.warnings(single, origin, segments, context)]


def parameters(method: Method = "ops", preset: Preset = "default") -> Dict[str, Any]:
    """The parameters of a method by name, with the values of a preset, as a dict.

    None stands for: follows the cloud. What each means is on the page of parameters, and
    in the headers, whose structs' fields these are; those of a struct within another have
    its name before their own, as in merging_angle_threshold.
    """
    return {name: value for name, (value, _) in parameters_of(_preset(method, preset)).items()}


def is_seen_from(points: Points, viewpoint: Vector = (0.0, 0.0, 0.0)) -> bool:
    """Whether a point cloud may have been taken from a place.

    One surface in each direction, nothing behind anything: so is a depth image or a scan
    in the frame of its sensor, but not a cloud of several, or one in the frame of a world.
    """
    sensor = place("viewpoint", viewpoint)
    single, origin = single_precision(points_array(points))
    return _pcl_ops.is_seen_from(single, sensor - origin)


@named_parameters("evaluate")
def evaluate(
    truth: NDArray[Any], result: NDArray[Any], points: Points, *,
    none: Optional[int] = None, **parameters: Any,
) -> Dict[str, float]:
    """Compare the planes found in a point cloud with the true ones.

    truth, result: arrays of whole numbers of the shape that segment gives labels, the plane
        of each point, negative on none.
    points: array as for segment; rows that are not finite do not count.
    none: the label of truth that stands for no plane, besides negative ones: 0 for labels
        as files have them, -1 where 0 is a plane. Needed where truth has the label 0 but
        no negative one, while result has negative ones.
    up, angle_tolerance: which planes are horizontal and vertical [rad].

    Returns a dict of fractions: classification_accuracy, segmentation_accuracy,
    segmentation_accuracy_all, and precision, recall, f_score, mean_iou, panoptic_quality,
    over_segmentation, under_segmentation, noise and missed at an intersection over union
    of 0.5 and, ending in _75, of 0.75; points_off_planes_called_planes; rand_index and
    segmentation_covering; variation_of_information [bits]; and the numbers
    points, truth_planes and result_planes.
    """
    array, shape = points_array(points), np.shape(points)[:-1]
    true_planes = plane_numbers("truth", truth, shape, -1 if none is None else none)
    found_planes = plane_numbers("result", result, shape, -1)
    # 1 was the label 0, 0 a negative one.
    if none is None and true_planes.min() == 1 and found_planes.min() == 0:
        raise ValueError(
            "truth: has the label 0 and no negative one; give none=0 if 0 stands for no plane, "
            "as in files, or none=-1 if it is a plane")
    single, _ = single_precision(array)
    return _pcl_ops.compare(
        true_planes, found_planes, single, with_given(_pcl_ops.evaluate(), parameters))
