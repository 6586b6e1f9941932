# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Draws clouds from above, each point in a color for the noise around its plane. Lengths are in
# meters.
import sys

import matplotlib
import numpy as np
import pcl_ops

matplotlib.use("Agg")  # without a display
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm

MM_PER_M = 1e3
MAX_DRAWN = 60000  # points of a cloud; more would not change the picture


def load(file):
    """Returns the finite points of a file."""
    points = pcl_ops.read(file).points
    return points[np.isfinite(points).all(axis=1)]


def noise_around(points):
    """Returns for each point the noise around its plane, NaN where it is not known, and whether
    it is on a ceiling, which would hide what is below."""
    labels, planes = pcl_ops.segment(points)
    # The last entry is for points on no plane: their label -1 is its index.
    noise_of_planes = np.array([plane.noise or np.nan for plane in planes] + [np.nan])
    are_ceilings = np.array([plane.kind == "ceiling" for plane in planes] + [False])
    return noise_of_planes[labels], are_ceilings[labels]


def draw(axes, points, noise, scale):
    """Draws points from above: gray ones, then colored ones in front of them, of both the higher
    ones in front. Returns those drawn in a color.

    scale: from noise [mm] to colors; points with unknown noise are gray.
    """
    drawn = np.random.default_rng(1).permutation(len(points))[:MAX_DRAWN]
    drawn = drawn[np.argsort(points[drawn, 2], kind="stable")]
    known = np.isfinite(noise[drawn])
    axes.scatter(*points[drawn[~known], :2].T, s=0.3, color="0.8", linewidths=0)
    return axes.scatter(*points[drawn[known], :2].T, s=0.5, c=MM_PER_M * noise[drawn[known]],
                        linewidths=0, norm=scale, cmap="turbo")


def show_most(axes, points):
    """Shows a square around all but the outermost points."""
    low, high = np.quantile(points[:, :2], (0.02, 0.98), axis=0)
    half = (high - low).max() / 2
    for limit, middle in zip((axes.set_xlim, axes.set_ylim), (low + high) / 2):
        limit(middle - half, middle + half)
    axes.set(aspect="equal", xticks=[], yticks=[])


def title_of(file, noise):
    """Returns the name of a cloud and its smallest and largest noise."""
    name = file.rsplit("/", 1)[-1].rsplit(".", 1)[0]
    if np.isnan(noise).all():
        return f"{name}: not known"
    return f"{name}: {MM_PER_M * np.nanmin(noise):.1f} to {MM_PER_M * np.nanmax(noise):.1f} mm"


def main():
    if len(sys.argv) < 3 or sys.argv[1].startswith("-"):
        sys.exit("Usage: noise_picture.py PICTURE.png CLOUD.npy|CLOUD.pcd|... [...]")
    files = sys.argv[2:]
    clouds = []
    for file in files:
        points = load(file)
        noise, is_ceiling = noise_around(points)
        clouds.append((points[~is_ceiling], noise[~is_ceiling]))
        print(title_of(file, clouds[-1][1]))
    known = np.concatenate([noise[np.isfinite(noise)] for _, noise in clouds])
    known = known if len(known) > 0 else np.array([1e-3])  # any: nothing is in color then
    # One for all clouds. A factor above 1, as the ends must differ.
    scale = LogNorm(MM_PER_M * known.min(), MM_PER_M * known.max() * 1.01)
    figure, panels = plt.subplots(1, len(files), figsize=(3 * len(files), 3.4), squeeze=False)
    for axes, file, (points, noise) in zip(panels[0], files, clouds):
        colored = draw(axes, points, noise, scale)
        show_most(axes, points)
        axes.set_title(title_of(file, noise).replace(": ", "\n"), fontsize=9)
    figure.colorbar(colored, ax=panels[0].tolist(), label="noise [mm]", shrink=0.8)
    figure.savefig(sys.argv[1], dpi=100, bbox_inches="tight")


main()
