# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Finds the planes of an array of points and draws a picture of them.
import sys

import matplotlib
import numpy as np
import pcl_ops

matplotlib.use("Agg")  # without a display
import matplotlib.pyplot as plt


SENSOR_IN_BOX_ROOM = (2.5, 1, 1.6)  # [m]
MAX_DRAWN = 20000  # points; more would take long


def box_room(points_per_side=15000):
    """Points of a room of 5 m x 4 m x 2.5 m with a table, with 3 mm of noise."""
    random = np.random.default_rng(1)
    noise = 0.003  # standard deviation [m]
    # Of floor, two walls and table top: a corner, and the size along x, y and z [m].
    sides = [((0, 0, 0), (5, 4, 0)), ((0, 4, 0), (5, 0, 2.5)), ((0, 0, 0), (0, 4, 2.5)),
             ((3, 2, 0.75), (1.4, 0.8, 0))]
    clouds = [corner + random.uniform(size=(points_per_side, 3)) * size for corner, size in sides]
    return np.vstack(clouds) + random.normal(0, noise, (len(sides) * points_per_side, 3))


def load(file):
    """The points of a file and the position of the sensor: zero if the file does not say it."""
    if file.endswith(".npy"):
        return np.load(file), (0, 0, 0)
    cloud = pcl_ops.read(file)
    return cloud.points, cloud.viewpoint


def draw(axes, points, labels, planes):
    """Draws points in the colors of their planes, outlines, and texts on the largest planes."""
    colors = plt.get_cmap("tab20")(labels % 20)
    colors[labels < 0] = (0.6, 0.6, 0.6, 0.3)
    drawn = np.random.default_rng(1).permutation(len(points))[:MAX_DRAWN]
    axes.scatter(*points[drawn].T, s=0.5, c=colors[drawn])
    for plane in planes:
        axes.plot(*np.vstack([plane.hull, plane.hull[:1]]).T, color="black", linewidth=1)
    described_planes = 6  # the largest ones; more texts would overlap
    for plane in planes[:described_planes]:
        axes.text(*plane.centroid, f"{plane.orientation}\n{plane.area:.1f} m²", ha="center")
    axes.set_box_aspect(np.ptp(points[np.isfinite(points).all(axis=1)], axis=0))


def main():
    if not 2 <= len(sys.argv) <= 3 or sys.argv[1].startswith("-"):
        sys.exit("Usage: plane_picture.py PICTURE.png [CLOUD.npy|CLOUD.pcd|...]")
    points, viewpoint = load(sys.argv[2]) if len(sys.argv) == 3 else (box_room(), SENSOR_IN_BOX_ROOM)

    labels, planes = pcl_ops.segment(points, viewpoint=viewpoint)  # normals point to the viewpoint

    for plane in planes:
        print(f"{len(plane.inliers):7d} points, {plane.orientation}, {plane.area:.2f} m2, "
              f"rms {plane.rms:.4f} m, normal {np.round(plane.normal, 3)}")
    print(f"{len(planes)} planes")
    figure, axes = plt.subplots(figsize=(9, 7), subplot_kw={"projection": "3d"})
    draw(axes, points, labels, planes)
    figure.savefig(sys.argv[1], dpi=100, bbox_inches="tight")


main()
