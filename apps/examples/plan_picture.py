# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Draws floor plans, seen from above, over the points near the height of the cut.
import sys

import matplotlib
import numpy as np
import pcl_ops
from pcl_ops import buildings

matplotlib.use("Agg")  # without a display
import matplotlib.pyplot as plt
from matplotlib.patches import PathPatch
from matplotlib.path import Path

NEAR_CUT = 0.3  # largest distance of drawn points above or below the cut [m]
MARGIN = 0.7  # around the rooms [m]


def draw_line(axes, start, end, **style):
    axes.plot([start[0], end[0]], [start[1], end[1]], solid_capstyle="butt", **style)


def draw_plan(axes, plan):
    """Draws walls black, openings blue, and rooms orange with their area."""
    for room in plan.rooms:
        # Holes run the other way round than the outline: a compound path leaves them empty.
        area = Path.make_compound_path(*(Path(ring, closed=True) for ring in room.rings))
        axes.add_patch(PathPatch(area, fc="tab:orange", ec="none", alpha=0.15))
        for ring in room.rings:
            axes.fill(ring[:, 0], ring[:, 1], fill=False, ec="tab:orange", lw=0.8)
        axes.text(*room.middle, f"{room.area:.1f} m²", ha="center", fontsize=11)
    for wall in plan.walls:
        draw_line(axes, wall.start, wall.end, color="black", lw=2)
        for opening in wall.openings:
            draw_line(axes, opening.start, opening.end, color="tab:blue", lw=3)


def show_rooms(axes, plan):
    """Shows the part of the picture around the rooms."""
    axes.set_aspect("equal")
    axes.set_axis_off()
    corners = [corner for room in plan.rooms for ring in room.rings for corner in ring]
    if corners:
        low, high = np.min(corners, axis=0) - MARGIN, np.max(corners, axis=0) + MARGIN
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


def main():
    if len(sys.argv) < 3 or sys.argv[1].startswith("-"):
        sys.exit("Usage: plan_picture.py PICTURE.png CLOUD.pcd [...]")
    figure, panels = plt.subplots(1, len(sys.argv) - 2, squeeze=False, layout="constrained",
                                  figsize=(6 * (len(sys.argv) - 2), 5))
    for axes, file in zip(panels[0], sys.argv[2:]):
        points = pcl_ops.read(file).points
        points = points[np.isfinite(points).all(axis=1)]
        _, planes = pcl_ops.segment(points)
        plan = buildings.floor_plan(planes)
        near = points[np.abs(points[:, 2] - plan.height) < NEAR_CUT]
        axes.scatter(near[:, 0], near[:, 1], s=0.5, c="0.6", linewidths=0)
        draw_plan(axes, plan)
        show_rooms(axes, plan)
        print(f"{file}: {len(plan.walls)} walls, {len(plan.rooms)} rooms")
    figure.savefig(sys.argv[1], dpi=75)


main()
