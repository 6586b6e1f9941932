# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""All planes of an unorganized point cloud: numpy in, labels and planes out.

    labels, planes = pcl_ops.segment(points)

Lengths are in the unit of the points, angles in radians.
"""

from . import buildings as buildings
from ._arguments import camera_up
from ._clouds import Cloud, from_message, read, write
from ._look import write_html
from ._maps import write_planes
from ._pcl_ops import __version__
from ._planes import FloorPlan, FoundPlanes, Plane, PlaneCorner, PlaneEdge, PlaneTracker, TrackedPlane
from ._planes import estimate_up_axis, filter_planes, find_plane_edges, match_planes, merge_planes
from ._planes import PlaneMove, PlanOpening, PlanRoom, PlanWall, ResultWarning, floor_plan, plane_kinds, regularize_planes
from ._segmentation import evaluate, is_seen_from, parameters, segment

__all__ = [
    "Cloud", "FloorPlan", "FoundPlanes", "PlanOpening", "PlanRoom", "PlanWall", "Plane", "PlaneCorner", "PlaneEdge", "PlaneMove", "PlaneTracker",
    "ResultWarning", "TrackedPlane", "__version__", "camera_up", "estimate_up_axis", "evaluate", "filter_planes", "find_plane_edges",
    "floor_plan", "from_message", "is_seen_from", "match_planes", "merge_planes", "parameters",
    "plane_kinds", "read", "regularize_planes", "segment", "write", "write_html", "write_planes",
]
