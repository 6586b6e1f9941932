# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the planes of an array, and compares labels with the true ones."""

from typing import Any, Dict, List, Literal, Optional, Tuple, Union, get_args

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops
from ._arguments import Points, Vector, checked_flag, checked_number, finite_vector, named_parameters, parameters_of
from ._arguments import plane_numbers, points_array, single_precision, with_given
from ._planes import MAX_WARNINGS, FoundPlanes, Labels, Plane, ResultWarning, name_together

Method = Literal["ops", "fspf", "kht"]
Preset = Literal["default", "paper"]


def _preset(method: Any, preset: Any) -> Any:
    """The extension's struct of parameters of a method, with the values of a preset."""
    for name, value, words in (("method", method, get_args(Method)),
                               ("preset", preset, get_args(Preset))):
        if value not in words:
            raise (ValueError if isinstance(value, str) else TypeError)(
                f"{name}: has to be one of {words}, not {value!r:.80}")
    struct = getattr(_pcl_ops, method)
    return struct.paper() if preset == "paper" else struct()


@named_parameters("ops", "fspf", "kht", up="Union[Vector, Literal['auto', 'camera']]")
def segment(
    points: Points, method: Method = "ops", preset: Preset = "default", *,
    viewpoint: Vector = (0.0, 0.0, 0.0), pieces: bool = False, piece_gap: float = 8.0,
    **parameters: Any,
) -> Tuple[Labels, FoundPlanes]:
    """Find all planes of a point cloud.

    points: array of float32 or float64 of shape (N, 3), or (H, W, 3) as of an image; a fourth
        number of each point is not used. Rows with NaN or infinite numbers are on no plane.
        float32 with its rows in order is read without a copy, all else is copied as float32;
        float64 relative to a position among the points if float32 cannot hold it. Other
        threads must not change it meanwhile.
    method: "ops" (Oriented Point Sampling), "fspf" (Fast Sampling Plane Filtering) or
        "kht" (3D Kernel-based Hough Transform).
    preset: "default" or "paper", what the other parameters are by default.
    viewpoint: the position of the sensor; normals point towards it. If the points were not seen
        from (0, 0, 0), this default means that it is unknown: then normals of planes that are
        not vertical point up.
    pieces: whether each connected piece of a plane becomes a plane of its own, with the plane it
        is part of as lies_on.
    piece_gap: widest gap within a piece, in units of the spacing of the points around it.
    parameters: those of pcl_ops.parameters(method), by default with the values of the preset.
        All methods have distance_threshold, min_points, up=(x, y, z), angle_tolerance, seed and
        threads (0: all). up="camera" is camera_up(). up="auto" is the up axis that the planes
        tell (estimate_up_axis), which planes.up and planes.up_confidence then have.

    Returns (labels, planes): an int32 array of shape (N,), or (H, W), with the position in
    planes of the plane each point is on, -1 for no plane; and FoundPlanes, a list of Plane by
    falling number of points, in the frame of the array.

    Raises ValueError or TypeError, which name the argument at fault. Warns by ResultWarning of
    what is doubtful, also if the planes cannot tell an up for "auto", or, with the default of
    method and preset, if no up is given and the planes suggest another one than z;
    planes.warnings has the same warnings.
    """
    preset_parameters = _preset(method, preset)
    wants_pieces = checked_flag("pieces", pieces)
    gap = checked_number("piece_gap", piece_gap, lambda spacings: spacings >= 1.0,
                         "a number of spacings from 1")
    sensor = finite_vector("viewpoint", viewpoint)
    array = points_array(points)
    single, origin = single_precision(array)
    cloud = single, origin, sensor
    is_up_given = "up" in parameters
    found_up, up_warning = _set_auto_up(cloud, parameters)
    used = with_given(preset_parameters, parameters)
    segments, voxel_size, distance_threshold = _pcl_ops.segment(*cloud, used)
    if not is_up_given and (method, preset) == ("ops", "default"):
        up_warning = _warning_of_suggested_up(cloud, segments, used)
    warnings = _warnings_of(cloud, segments, used, is_up_given)
    lies_on = [None] * len(segments)
    if wants_pieces:
        segments, lies_on = _pcl_ops.pieces(
            single, origin, segments, gap, parameters.get("threads", 1))
    planes = FoundPlanes(Plane(segment, array) for segment in segments)
    for plane, number in zip(planes, lies_on):
        plane._lies_on = number
    planes.voxel_size, planes.distance_threshold = voxel_size, distance_threshold
    values = parameters_of(used)
    planes.up = values["up"][0]
    planes.up_confidence = found_up and found_up[1]
    name_together(planes, planes.up, values["angle_tolerance"][0], sensor)
    # unknown-up matters only for kinds of planes: it is kept until one is asked for.
    planes._warning_of_kinds = None if up_warning else next(
        (warning for warning in warnings if warning.code == "unknown-up"), None)
    others = [warning for warning in warnings if warning.code != "unknown-up"]
    if up_warning:
        others.insert(0, up_warning)
    for warning in others[:MAX_WARNINGS]:
        planes._warn(warning, 3)
    return _labels_by(planes, len(array)).reshape(np.shape(points)[:-1]), planes


def _labels_by(planes: FoundPlanes, point_count: int) -> Labels:
    """For each point the position in planes of the plane it is on, -1 for no plane."""
    labels = np.full(point_count, -1, np.int32)
    for number, plane in enumerate(planes):
        labels[plane.inliers] = number
    return labels


# What the extension gets of a cloud: the points, the origin that they are relative to, and the
# position of the sensor, relative to zero of the user's array.
_Cloud = Tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.float64]]


# Direction and confidence of an up axis.
_FoundUp = Tuple[NDArray[np.float64], float]


def _set_auto_up(
    cloud: _Cloud, parameters: Dict[str, Any]
) -> Tuple[Optional[_FoundUp], Optional[ResultWarning]]:
    """If up is "auto", replaces it among the parameters by the axis that the planes tell, or by z.

    Returns that axis, and a warning if the planes tell none; (None, None) for another up.
    """
    up = parameters.get("up")
    if not (isinstance(up, str) and up == "auto"):
        return None, None
    found = _up_of_default(cloud, parameters)
    parameters["up"] = (0.0, 0.0, 1.0) if found is None else found[0]
    return found, None if found else ResultWarning(
        "unknown-up", "up: the planes cannot tell, (0, 0, 1) is used; give up=(x, y, z)")


def _up_of(cloud: _Cloud, segments: Any) -> Optional[_FoundUp]:
    """The up axis that the planes tell.

    None if they tell none, or if the points cannot have been seen from the sensor's position.
    """
    single, origin, sensor = cloud
    found = _pcl_ops.up_axis(segments, sensor, _pcl_ops.estimate_up_axis())
    return found if found and _pcl_ops.is_seen_from(single, sensor - origin) else None


def _up_of_default(cloud: _Cloud, parameters: Dict[str, Any]) -> Optional[_FoundUp]:
    """The same as _up_of, by planes that the default preset finds in the cloud.

    What the confidence means was measured for such planes.
    """
    given = {name: parameters[name] for name in ("seed", "threads") if name in parameters}
    return _up_of(cloud, _pcl_ops.segment(*cloud, with_given(_pcl_ops.ops(), given))[0])


def _warning_of_suggested_up(cloud: _Cloud, segments: Any, used: Any) -> Optional[ResultWarning]:
    """A warning that the planes suggest another up axis than the one used, or None."""
    found = _up_of(cloud, segments)
    values = parameters_of(used)
    # The sign does not matter: with the opposite up, planes have the same orientations.
    if not found or abs(found[0] @ values["up"][0]) >= np.cos(values["angle_tolerance"][0]):
        return None
    x, y, z = np.round(found[0], 2) + 0.0  # adding 0 makes -0 positive
    return ResultWarning(
        "suggested-up", f"planes suggest that up is {x:.2f}, {y:.2f}, {z:.2f}: give up=\"auto\", "
        "or up=(0, 0, 1) where z is")


def _warnings_of(cloud: _Cloud, segments: Any, used: Any, is_up_given: bool) -> List[ResultWarning]:
    """The warnings that the programs give, the most important first."""
    single, origin, sensor = cloud
    values = parameters_of(used)
    context = _pcl_ops.ResultContext()
    if sensor.any():
        context.viewpoint = sensor
    context.uses_kinds = True
    context.set_up(np.asarray(values["up"][0], np.float64), is_up_given)
    uses_neighborhoods = (
        "sampling" in values and values["sampling"][0] in ("automatic", "neighborhoods")
        and values["surfels_voxel_size"][0] is None)
    if uses_neighborhoods:
        context.search = used
    return [ResultWarning(code, text)
            for code, text in _pcl_ops.warnings(single, origin, segments, context)]


def parameters(method: Method = "ops", preset: Preset = "default") -> Dict[str, Any]:
    """The parameters of a method by name, with the values of a preset, as a dict.

    None means that the value follows the cloud. The page on parameters and the headers say what
    each means. They are the fields of structs; fields of a nested struct begin with its name,
    as merging_angle_threshold.
    """
    return {name: value for name, (value, _) in parameters_of(_preset(method, preset)).items()}


def is_seen_from(points: Points, viewpoint: Vector = (0.0, 0.0, 0.0)) -> bool:
    """Whether a point cloud may have been taken from one position.

    Then there is one surface in each direction, and nothing behind it: as in a depth image or
    a scan in the frame of its sensor, but not in a cloud of several scans, or in the frame of
    a world.
    """
    sensor = finite_vector("viewpoint", viewpoint)
    single, origin = single_precision(points_array(points))
    return _pcl_ops.is_seen_from(single, sensor - origin)


@named_parameters("evaluate", up="Union[Vector, Literal['camera']]")
def evaluate(
    truth: NDArray[Any], result: NDArray[Any], points: Points, *,
    none: Optional[int] = None, **parameters: Any,
) -> Dict[str, float]:
    """Compare the planes found in a point cloud with the true ones.

    truth, result: arrays of integers in the shape of segment's labels, the plane of each point,
        negative for no plane.
    points: array as for segment; rows that are not finite do not count.
    none: the label of truth that stands for no plane, besides negative ones: 0 for labels
        as files have them, -1 if 0 is a plane. It is needed if truth has the label 0 but no
        negative one, while result has negative ones.
    up, angle_tolerance: decide which planes are horizontal and vertical [rad].

    Returns a dict of fractions: classification_accuracy, segmentation_accuracy,
    segmentation_accuracy_all, and precision, recall, f_score, mean_iou, panoptic_quality,
    over_segmentation, under_segmentation, noise and missed at an intersection over union
    of 0.5 and, ending in _75, of 0.75; points_off_planes_called_planes; rand_index and
    segmentation_covering; variation_of_information [bits]; and the numbers
    points, truth_planes and result_planes.
    """
    array, shape = points_array(points), np.shape(points)[:-1]
    if none is not None:
        none = checked_number("none", none, lambda _: True, "a label or None", int)
    true_planes = plane_numbers("truth", truth, shape, -1 if none is None else none)
    found_planes = plane_numbers("result", result, shape, -1)
    # plane_numbers makes the label 0 a 1, and negative labels 0.
    has_truth_0_but_no_negative = true_planes.min() == 1
    has_result_negative = found_planes.min() == 0
    if none is None and has_truth_0_but_no_negative and has_result_negative:
        raise ValueError(
            "truth: has the label 0 and no negative one; give none=0 if 0 stands for no plane, "
            "as in files, or none=-1 if it is a plane")
    single, _ = single_precision(array)
    return _pcl_ops.compare(
        true_planes, found_planes, single, with_given(_pcl_ops.evaluate(), parameters))
