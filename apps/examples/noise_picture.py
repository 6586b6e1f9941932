# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Draws clouds from above, each point in a color for the noise around its plane.
import sys

import matplotlib
import numpy as np
import pcl_ops

matplotlib.use("Agg")  # without a display
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm


def load(file):
    points = np.load(file) if file.endswith(".npy") else pcl_ops.read(file).points
    return points[np.isfinite(points).all(axis=1)]


def noise_around(points):
    """The noise around the plane of each point, as far as it is known; NaN elsewhere and on
    ceilings, which would hide what is below."""
    labels, planes = pcl_ops.segment(points)
    of_plane = [plane.noise or np.nan for plane in planes]
    is_ceiling = [plane.kind == "ceiling" for plane in planes]
    return np.array(of_plane + [np.nan])[labels], np.array(is_ceiling + [False])[labels]


def draw(axes, points, noise, scale):
    """From above, what is higher in front; 60,000 points are enough."""
    some = np.random.default_rng(1).permutation(len(points))[:60000]
    some = some[np.argsort(points[some, 2], kind="stable")]
    known = np.isfinite(noise[some])
    axes.scatter(*points[some[~known], :2].T, s=0.3, color="0.8", linewidths=0)
    return axes.scatter(*points[some[known], :2].T, s=0.5, c=1e3 * noise[some[known]],
                        linewidths=0, norm=scale, cmap="turbo")


def show_most(axes, points):
    """A square around all but the outermost points."""
    low, high = np.quantile(points[:, :2], (0.02, 0.98), axis=0)
    half = (high - low).max() / 2
    for limit, middle in zip((axes.set_xlim, axes.set_ylim), (low + high) / 2):
        limit(middle - half, middle + half)
    axes.set(aspect="equal", xticks=[], yticks=[])


def title_of(file, noise):
    name = file.rsplit("/", 1)[-1].rsplit(".", 1)[0]
    if np.isnan(noise).all():
        return f"{name}: not known"
    return f"{name}: {1e3 * np.nanmin(noise):.1f} to {1e3 * np.nanmax(noise):.1f} mm"


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
    known = known if len(known) > 0 else np.array([1e-3])
    scale = LogNorm(1e3 * known.min(), 1e3 * known.max() * 1.01)
    figure, panels = plt.subplots(1, len(files), figsize=(3 * len(files), 3.4), squeeze=False)
    for axes, file, (points, noise) in zip(panels[0], files, clouds):
        drawn = draw(axes, points, noise, scale)
        show_most(axes, points)
        axes.set_title(title_of(file, noise).replace(": ", "\n"), fontsize=9)
    figure.colorbar(drawn, ax=panels[0].tolist(), label="noise [mm]", shrink=0.8)
    figure.savefig(sys.argv[1], dpi=100, bbox_inches="tight")


main()
