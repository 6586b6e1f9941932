# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the planes of a building are: kinds, rooms, a floor plan.

    labels, planes = pcl_ops.segment(points)
    for room in pcl_ops.buildings.rooms(planes):
        print(room.area, room.rings[0])

Lengths of plans are meters, whatever the unit of the planes (meter=).
"""

from typing import Any, List, Optional

from ._arguments import Up, named_parameters
from ._planes import FloorPlan, PlaneMove, PlanOpening, PlanRoom, PlanWall, Planes
from ._planes import draw_floor_plan, floor_plan, regularize_planes
from ._planes import plane_kinds as kinds

__all__ = [
    "FloorPlan", "PlanOpening", "PlanRoom", "PlanWall", "PlaneMove", "floor_plan", "kinds",
    "regularize_planes", "rooms",
]


@named_parameters("floor_plan")
def rooms(planes: Planes, up: Optional[Up] = None, **parameters: Any) -> List[PlanRoom]:
    """The rooms of a floor plan, by falling area, with their outlines and heights.

    The arguments are those of floor_plan, which gives walls and openings, too.
    """
    return draw_floor_plan(planes, up, parameters).rooms
