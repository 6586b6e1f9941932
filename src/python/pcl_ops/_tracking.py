# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes of one frame found again in others."""

from typing import Any, List, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops
from ._arguments import named_parameters, pose_matrix, with_given
from ._planes import Labels, Plane, Planes, plane_list


@named_parameters("match_planes")
def match_planes(
    previous: Planes, current: Planes, pose: Optional[NDArray[Any]] = None, **parameters: Any
) -> Tuple[Labels, NDArray[np.float64]]:
    """Find the planes of a frame again in the next.

    previous, current: lists of Plane, each in the frame of its own array.
    pose: array of shape (4, 4), the current frame in the previous one: a point p of the
        current frame is pose[:3, :3] @ p + pose[:3, 3] there. None: they are the same.
    rotation_error [rad], translation_error: how far the pose may be off, one standard
        deviation about and along any axis; rotations are about the zero of the current
        frame.
    min_overlap: the smallest share of the smaller of two planes that lies over the other.

    Returns (matches, pose): an int32 array with the position in previous of the plane that
    each of current continues, -1 for none; and the pose as the matched planes correct it.
    """
    matches, corrected = _pcl_ops.match(
        plane_list("previous", previous), plane_list("current", current), pose_matrix(pose),
        with_given(_pcl_ops.match_planes(), parameters))
    return np.array(matches, np.int32), corrected


class TrackedPlane(NamedTuple):
    """A plane with the number it has in all frames."""

    number: int
    """From 1, in the order of appearance."""
    plane: Plane
    """In the common frame, without inliers."""
    last_seen: int
    """The last frame it was seen in, from 0."""
    first_seen: int
    times_seen: int
    hull: NDArray[np.float64]
    """(m, 3): convex outline of where it was seen in any frame, of rectangles with the moments
    of each."""


class PlaneTracker:
    """Numbers for planes that they keep from frame to frame, also where they are out of
    sight for a while. copy.copy it to try what a frame would do."""

    @named_parameters("match_planes")
    def __init__(
        self, memory: Optional[int] = None, max_distance: Optional[float] = None, **parameters: Any
    ) -> None:
        """memory: frames a plane is remembered after it was last seen; None: for ever.
        max_distance: planes of which every part is farther from the sensor are forgotten.

        The others are those of match_planes; errors are from one frame to the next.
        """
        if memory is not None and not (isinstance(memory, int) and memory >= 0):
            raise ValueError(f"memory: has to be a number of frames or None, not {memory!r:.80}")
        self._tracker = _pcl_ops.Tracker(with_given(_pcl_ops.match_planes(), parameters), memory,
                                         None if max_distance is None else float(max_distance))

    def __copy__(self) -> "PlaneTracker":
        copied = PlaneTracker()
        copied._tracker = self._tracker.copy()
        return copied

    def __deepcopy__(self, _: Any) -> "PlaneTracker":
        return self.__copy__()

    def __reduce__(self) -> Any:
        raise TypeError("cannot pickle 'pcl_ops.PlaneTracker' objects")

    def track(self, planes: Planes, pose: Optional[NDArray[Any]] = None) -> NDArray[np.uint32]:
        """Number the planes of the next frame.

        planes: list of Plane as segment gives them, in the frame's own coordinates.
        pose: array of shape (4, 4), the frame in a common one, as for match_planes. Only
            how it moved since the frame before counts, so that poses may drift.

        Returns the number of each plane, all different; planes that were not seen before
        get new ones.
        """
        numbers = self._tracker.track(plane_list("planes", planes), pose_matrix(pose))
        return np.array(numbers, np.uint32)

    @property
    def planes(self) -> List[TrackedPlane]:
        """All planes that are remembered, by their numbers."""
        nowhere = np.empty((0, 3), np.float32)
        return [TrackedPlane(number, Plane(plane, nowhere), *seen, np.reshape(hull, (-1, 3)))
                for number, plane, *seen, hull in self._tracker.planes]

    @property
    def pose(self) -> NDArray[np.float64]:
        """(4, 4): the last frame in the common one, as its planes say."""
        return self._tracker.pose
