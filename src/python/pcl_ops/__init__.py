# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""All planes of an unorganized point cloud: numpy in, labels and planes out.

    labels, planes = pcl_ops.segment(points)

Lengths are in the unit of the points, angles in radians.
"""

import numpy as _np

from . import _pcl_ops
from ._pcl_ops import Plane, __version__

__all__ = [
    "Plane",
    "estimate_up_axis",
    "evaluate",
    "filter_planes",
    "match_planes",
    "merge_planes",
    "parameters",
    "segment",
    "__version__",
]

_UP = (0.0, 0.0, 1.0)
_ANGLE_TOLERANCE = 0.12217304763960307
_DIRECTION_TOLERANCE = 0.17453292519943295


def segment(points, method="ops", preset="default", *, viewpoint=(0.0, 0.0, 0.0), **parameters):
    """Find all planes of a point cloud.

    points: array of float32 or float64 of shape (N, 3), with any strides; rows with NaN or
        infinite numbers are on no plane. float32 with its rows in order is read where it
        is, all else is copied as float32; float64 relative to a place among the points
        where float32 could not hold it, so that coordinates in the millions keep their
        millimetres. Other threads run meanwhile; they must not change the array.
    method: "ops" (Oriented Point Sampling), "fspf" (Fast Sampling Plane Filtering) or
        "kht" (3D Kernel-based Hough Transform).
    preset: "default" or "paper", what the other parameters are by default.
    viewpoint: where the sensor was; normals point towards it.
    parameters: see pcl_ops.parameters(method), with the values of the preset.
        distance_threshold, up=(x, y, z), angle_tolerance, seed and threads (0: all) are
        those of all methods.

    Returns (labels, planes): an int32 array of shape (N,) with the position in planes of
    the plane each point is on, -1 on none; and a list of Plane by falling number of
    points, in the frame of the array.

    Raises ValueError or TypeError, which name the argument at fault.
    """
    return _pcl_ops.segment(_checked_points(points), method, preset, viewpoint, parameters)


def parameters(method="ops", preset="default"):
    """The parameters of a method by name, with the values of a preset, as a dict.

    None stands for: follows the cloud. What each means is on the page of parameters, and
    in the headers, whose structs' fields these are; those of a struct within another have
    its name before their own, as in merging_angle_threshold.
    """
    return _pcl_ops.parameters(method, preset)


def merge_planes(planes, *, up=_UP, angle_tolerance=_ANGLE_TOLERANCE, **parameters):
    """Merge coplanar planes until no pair passes the test.

    planes: list of Plane of one array that share no points, as segment gives them; with
        merging_enabled=False it leaves them as they were found.
    up, angle_tolerance: which planes are horizontal and vertical [rad].
    parameters: angle_threshold [rad], distance_threshold and noise_factor, how far the
        normals and the centroids of two planes may be apart.

    Returns (merged, merged_into): a list of Plane by falling number of points, and an
    int32 array with the position in it of the plane that each of planes went into, -1
    where its points span no plane.
    """
    orientation = {"up": up, "angle_tolerance": angle_tolerance}
    return _pcl_ops.merge_planes(_checked_planes("planes", planes), orientation, parameters)


def filter_planes(
    planes,
    *,
    orientation=None,
    direction=None,
    direction_tolerance=_DIRECTION_TOLERANCE,
    min_points=0,
    min_area=0.0,
    min_width=0.0,
    max_planes=None,
):
    """Keep the planes that are wanted.

    planes: list of Plane, in an order that stays.
    orientation: "horizontal", "vertical" or "other".
    direction: vector (x, y, z) of any length that normals point along, or against, to
        within direction_tolerance [rad].
    min_points, min_area, min_width: fewest inliers, smallest area of the hull and smallest
        width of the rectangle around it.
    max_planes: how many to keep of those that are left, the first ones.

    Returns (kept, dropped): the list of Plane, and a dict with how many each of these
    arguments dropped; a plane counts once, for the first it fails.
    """
    return _pcl_ops.filter_planes(_checked_planes("planes", planes), {
        "orientation": orientation,
        "direction": direction,
        "direction_tolerance": direction_tolerance,
        "min_points": min_points,
        "min_area": min_area,
        "min_width": min_width,
        "max_planes": max_planes,
    })


def match_planes(previous, current, pose=None, **parameters):
    """Find the planes of a frame again in the next.

    previous, current: lists of Plane, each in the frame of its own array.
    pose: array of shape (4, 4), the current frame in the previous one: a point p of the
        current frame is pose[:3, :3] @ p + pose[:3, 3] there. None: they are the same.
    parameters: rotation_error [rad] and translation_error, how far the pose may be off,
        one standard deviation about and along any axis, where rotations are about the zero
        of the current frame; and min_overlap, the smallest share of the smaller of two
        planes that lies over the other.

    Returns (matches, pose): an int32 array with the position in previous of the plane that
    each of current continues, -1 for none; and the pose as the matched planes mend it.
    """
    previous = _checked_planes("previous", previous)
    current = _checked_planes("current", current)
    return _pcl_ops.match_planes(previous, current, _checked_pose(pose), parameters)


def estimate_up_axis(planes, viewpoint=(0.0, 0.0, 0.0), **parameters):
    """Which way is up in a room, by its planes alone.

    planes: list of Plane as segment gives them, with normals towards the viewpoint.
    viewpoint: where the sensor was, in the frame of the planes.
    parameters: angle_tolerance [rad], least_share and least_confidence.

    Returns (direction, confidence): a unit vector against gravity, and how sure it is, 0
    to 1; or None where the planes cannot tell.
    """
    return _pcl_ops.estimate_up_axis(_checked_planes("planes", planes), viewpoint, parameters)


def evaluate(truth, result, points, *, up=_UP, angle_tolerance=_ANGLE_TOLERANCE):
    """Compare the planes found in a point cloud with the true ones.

    truth, result: arrays of whole numbers of shape (N,), the plane of each point, negative
        on none, as segment gives them.
    points: array of shape (N, 3), as for segment; rows that are not finite do not count.
    up, angle_tolerance: which planes are horizontal and vertical [rad].

    Returns a dict of fractions: classification_accuracy, segmentation_accuracy,
    segmentation_accuracy_all, and precision, recall, f_score, mean_iou, panoptic_quality,
    over_segmentation, under_segmentation, noise and missed at an intersection over union
    of 0.5 and, ending in _75, of 0.75; points_off_planes_called_planes; and the numbers
    points, truth_planes and result_planes.
    """
    points = _checked_points(points)
    truth = _checked_labels("truth", truth, len(points))
    result = _checked_labels("result", result, len(points))
    orientation = {"up": up, "angle_tolerance": angle_tolerance}
    return _pcl_ops.evaluate(truth, result, points, orientation)


def _checked_points(points):
    """The points as an array the extension can read, the same one where it can."""
    if isinstance(points, _np.ma.MaskedArray):
        raise TypeError("points: a masked array; use points.filled(numpy.nan)")
    array = _np.asarray(points)
    if array.dtype.kind != "f" or array.dtype.itemsize not in (4, 8):
        raise TypeError(f"points: dtype {array.dtype} is neither float32 nor float64")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points: shape {array.shape} is not (N, 3)")
    if not 0 < len(array) <= _np.iinfo(_np.int32).max:
        raise ValueError(f"points: shape {array.shape} has no points, or more than 2^31 - 1")
    if array.dtype.isnative and array.flags.aligned:
        return array  # the very object: by it planes are known to be of one array
    return _np.require(array, array.dtype.newbyteorder("="), "A")


def _checked_planes(name, planes):
    try:
        return list(planes)
    except TypeError:
        raise TypeError(f"{name}: not a list of pcl_ops.Plane: {planes!r:.80}") from None


def _checked_pose(pose):
    array = _np.eye(4) if pose is None else _np.asarray(pose)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"pose: dtype {array.dtype} is not one of real numbers")
    if array.shape != (4, 4):
        raise ValueError(f"pose: shape {array.shape} is not (4, 4)")
    return array.astype(float)


def _checked_labels(name, labels, number):
    if isinstance(labels, _np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array; use {name}.filled(-1)")
    array = _np.asarray(labels)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: dtype {array.dtype} is not one of whole numbers")
    if array.shape != (number,):
        raise ValueError(f"{name}: shape {array.shape} is not ({number},), that of the points")
    if array.dtype.kind == "u":  # the largest must not become negative
        array = _np.minimum(array.astype(_np.uint64), _np.uint64(2**63 - 1))
    return array
