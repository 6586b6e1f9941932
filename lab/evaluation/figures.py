# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plots of report.py, by matplotlib."""
import csv
from collections import defaultdict
from typing import NamedTuple

import matplotlib
import numpy as np
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

# Names of methods in pictures, by their names in pcl_ops_evaluate.
NAMES = {"ops": "pcl_ops", "ops-3-30": "pcl_ops, paper", "kht": "3D-KHT", "fspf": "FSPF",
         "pcl-sac": "PCL SACSegmentation loop", "pcl-region-growing": "PCL RegionGrowing",
         "pcl-organized": "PCL OrganizedMultiPlane", "cgal-ransac": "CGAL Efficient RANSAC",
         "cgal-region-growing": "CGAL region growing", "open3d": "Open3D segment_plane loop",
         "voxel-octree": "voxel octree (VoxelMap)"}
OURS = ("ops", "ops-3-30", "kht", "fspf")
# Methods in strips of pictures, in this order.
IN_STRIP = ("truth", "ops", "cgal-region-growing", "cgal-ransac", "pcl-region-growing", "pcl-sac")
MEASURED = "-measured"  # end of a method's name, where its parameters come from the cloud
OUR_COLOR, PEER_COLOR, OWN_COLOR = "C3", "C0", "C2"  # own: labels of a user's detector
COLORS_OF_PNG = 128  # enough for the pictures; a file takes half the bytes
MIN_POINTS_OF_PLANE = 50  # of a true plane by default (pcl_ops_evaluate run --min-plane-points)


def finish(axes, x_label, y_label, file):
    """Names the axes, saves the plot and closes it."""
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    axes.grid(True)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=7)
    axes.figure.savefig(file, dpi=120, bbox_inches="tight")
    plt.close(axes.figure)


def save(figure, file):
    """Saves a figure as a PNG of COLORS_OF_PNG colors and closes it."""
    figure.set_dpi(100)
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())[..., :3]
    image = Image.fromarray(pixels).quantize(COLORS_OF_PNG, dither=Image.Dither.NONE)
    image.save(file, optimize=True)
    plt.close(figure)


def draw_own(axes, accuracies):
    """A line at the accuracy of each of a user's own detectors, whose labels tell no time."""
    for name, accuracy in accuracies.items():
        axes.axhline(accuracy, color=OWN_COLOR, linestyle="--", linewidth=1.2)
        axes.annotate(name, (0, accuracy), xycoords=("axes fraction", "data"), xytext=(4, 3),
                      textcoords="offset points", fontsize=10, color=OWN_COLOR)


def plot_accuracy(name, means, folder):
    """Accuracies of a data set over the time, and over the sampling rate of OPS."""
    own = {configuration: mean for configuration, mean in means.items()
           if mean["clouds"] and np.isnan(mean["detection_ms"])}
    means = {configuration: mean for configuration, mean in means.items()
             if configuration not in own}
    for metric in ("classification_accuracy", "segmentation_accuracy"):
        label = metric.replace("_", " ") + " [%]"

        axes = plt.subplots()[1]
        axes.set(title=name, xscale="log", ylim=(0, 100))
        for family in dict.fromkeys(configuration.partition("-")[0] for configuration in means):
            points = {configuration: (mean["detection_ms"] / 1e3, 100 * mean[metric])
                      for configuration, mean in means.items()
                      if configuration.partition("-")[0] == family}
            axes.scatter(*zip(*points.values()), label=family)
            for configuration, point in points.items():
                axes.annotate(configuration, point, fontsize=5)
        draw_own(axes, {configuration: 100 * mean[metric] for configuration, mean in own.items()})
        finish(axes, "time [s]", label, folder / f"{metric}_over_time.png")

        axes = plt.subplots()[1]
        axes.set(title=name, xscale="log", ylim=(0, 100))
        for k in (10, 20, 30):
            points = [(float(rate), 100 * means[f"ops-{rate}-{k}"][metric])
                      for rate in ("0.3", "0.5", "0.7", "1", "3") if f"ops-{rate}-{k}" in means]
            if points:
                axes.plot(*zip(*points), marker="o", label=f"k {k}")
        if axes.lines:
            finish(axes, "sampling rate [%]", label, folder / f"{metric}_over_sampling_rate.png")
        plt.close("all")


def styles_of(truths, data_sets):
    """The color of the data set and the line of the number of neighbors of each truth.

    truths: pairs of a name, as of plot_true_planes, and counts
    """
    names = [name for name, _ in truths]
    neighbors = list(dict.fromkeys(name.rpartition("-k")[2] for name in names))
    return [f"C{data_sets.index(name.partition(',')[0])}o" +
            ("-", "--", ":", "-.")[neighbors.index(name.rpartition("-k")[2]) % 4]
            for name in names]


def plot_true_planes(truths, bounds, of_paper, file):
    """How many planes a grown truth has, by the points of the smallest that counts.

    truths: by name, the number of all planes and of those of at least each of the bounds. A
        name is "DATA_SET, truth grown-kNEIGHBORS", as report_results (report.py) makes it.
    """
    axes = plt.subplots(figsize=(8, 5))[1]
    all_bounds = (MIN_POINTS_OF_PLANE, *bounds)
    axes.set(xscale="log", yscale="log", xticks=all_bounds, yticks=(1, 10, 100, 1000))
    axes.minorticks_off()
    axes.xaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_major_formatter("{x:g}")
    data_sets = list(dict.fromkeys(name.partition(",")[0] for name in truths))
    by_neighbors = sorted(truths.items(), key=lambda truth: int(truth[0].rpartition("-k")[2]))
    for (name, counts), style in zip(by_neighbors, styles_of(by_neighbors, data_sets)):
        label = name.replace("truth grown-k", "normals of ") + " neighbors"
        axes.plot(all_bounds, counts, style, label=label)
    axes.axhline(of_paper, color="black", linestyle="--", linewidth=1, label="the paper")
    finish(axes, "points of the smallest plane", "true planes per cloud", file)


def label_dots(axes, dots):
    """Names beside their dots, each at the first offset from it that is free; a line leads
    to a name that is above or below its dot.

    dots: (name, position, color) of each
    """
    dot_size = 12  # [px]
    renderer = axes.figure.canvas.get_renderer()
    taken = [matplotlib.transforms.Bbox.from_bounds(x - dot_size / 2, y - dot_size / 2,
                                                    dot_size, dot_size)
             for x, y in axes.transData.transform([dot for _, dot, _ in dots])]
    # Offsets of a name [points], the nearest first, and which of its sides is there; chosen by eye.
    offsets = [(x, y, "left" if x > 0 else "right" if x < 0 else "center")
               for far in (1, 2, 3, 4)
               for x, y in ((8, -4), (-8, -4), (0, 9 * far), (0, -17 * far), (8, 7 * far),
                            (-8, 7 * far), (8, -14 * far), (-8, -14 * far))]
    frame = axes.get_window_extent()
    for name, dot, color in dots:
        for x, y, side in offsets:
            label = axes.annotate(name, dot, xytext=(x, y), textcoords="offset points", ha=side,
                                  fontsize=12, color=color)
            box = label.get_window_extent(renderer)
            fits = (frame.x0 < box.x0 and box.x1 < frame.x1 and frame.y0 < box.y0 and
                    not box.count_overlaps(taken))
            if fits or (x, y, side) == offsets[-1]:
                break
            label.remove()
        # A line leads to the lower edge of a name above, or to the upper edge of one below.
        if name and abs(y) > 9:
            axes.annotate("", dot, xytext=(x, y + 9 * (y < 0)), textcoords="offset points",
                          arrowprops={"arrowstyle": "-", "color": color, "linewidth": 0.7})
        taken.append(box)


def panels_of(data_sets):
    """The data sets of each panel of the figure, by its title."""
    simulated = [name for name in ("rooms", "streets") if name in data_sets]
    real = [name for name in data_sets if name.startswith("real-")]
    if simulated and real:
        return {f"simulated {' and '.join(simulated)}": simulated,
                "real rooms, facades and roofs, labeled by people": real}
    return {name: [name] for name in simulated or data_sets[:2]}


def dots_of(rows, data_sets):
    """Time and F-score of each method that has all of the data sets: the geometric mean of
    the times and the mean of the scores."""
    rows_of_method = defaultdict(list)
    for row in rows:
        if row["data_set"] in data_sets and row["values"] != "own":
            rows_of_method[row["method"]].append(row)
    return {method: (np.exp(np.mean([np.log(float(row["seconds_per_million_points"]))
                                     for row in of_method])),
                     np.mean([float(row["f_score"]) for row in of_method]))
            for method, of_method in rows_of_method.items() if len(of_method) == len(data_sets)}


def add_legend_of_settings(axes, has_own):
    """Says what filled and empty dots are and, with labels of one's own, what their line is."""
    marks = [axes.scatter([], [], color="gray", s=45, label="values of tutorials"),
             axes.scatter([], [], color="gray", s=45, facecolors="none",
                          label="values measured from the cloud")]
    if has_own:
        marks += axes.plot([], [], color=OWN_COLOR, linestyle="--",
                           label="labels of one's own, no time")
    axes.legend(handles=marks, fontsize=12, loc="upper right")


def plot_comparison(rows, folder):
    """F-score over the time per million points: a panel for simulated data sets, and one for
    real ones; where there is one kind, for rooms and streets or the first two data sets."""
    rows = [row for row in rows if row["f_score"]]
    panels_by_title = panels_of(list(dict.fromkeys(row["data_set"] for row in rows)))
    if not panels_by_title:
        return
    best = max(float(row["f_score"]) for row in rows
               if any(row["data_set"] in names for names in panels_by_title.values()))
    count = len(panels_by_title)
    labels_of_axes = {}
    figure, panels = plt.subplots(count, 1, sharex=True, squeeze=False,
                                  figsize=(8.3, 3.7 * count), layout="constrained")
    for axes, (title, data_sets) in zip(panels[:, 0], panels_by_title.items()):
        dots = dots_of(rows, data_sets)
        axes.set_title(title, fontsize=14)
        axes.set_ylabel("F-score at an overlap of 0.5", fontsize=13)
        axes.tick_params(labelsize=12)
        axes.set(xscale="log", ylim=(0, max(0.9, best + 0.05)))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.margins(x=0.15)
        axes.grid(True, alpha=0.3)
        labels = labels_of_axes[axes] = []
        for method, dot in dots.items():
            tutorial = method.removesuffix(MEASURED)  # the method with values of its tutorial
            color = OUR_COLOR if tutorial in OURS else PEER_COLOR
            axes.scatter(*dot, s=45, edgecolors=color,
                         facecolors="none" if tutorial != method else color)
            if tutorial != method and tutorial in dots:
                axes.plot(*zip(dots[tutorial], dot), color=color, linewidth=0.7, alpha=0.5)
            labels.append(("" if tutorial != method else NAMES.get(method, method), dot, color))
        draw_own(axes, {row["method"]: float(row["f_score"]) for row in rows
                        if row["data_set"] in data_sets and row["values"] == "own"})
    panels[-1][0].set_xlabel("processor time per million points [s]", fontsize=13)
    add_legend_of_settings(panels[0][0], any(row["values"] == "own" for row in rows))
    figure.canvas.draw()
    figure.set_layout_engine("none")
    for axes, labels in labels_of_axes.items():
        label_dots(axes, labels)
    save(figure, folder / "figure.png")


CHANGES = ("moved", "turned", "thinned", "jittered", "rounded")  # columns of steadiness.csv


def plot_steadiness(rows, folder):
    """How right and how steady each method is: over its number, the share of points that stay on
    their plane in the worst tenth of clouds, as a dot at the mean of all changes and a line from
    the worst to the best change. The number is the one of scripts/accuracy over all sets, the
    higher the better: of F-scores and, for sets without a truth, of the share of points on thin
    planes less that on thick ones. Of two settings of a method, the one with the higher number."""
    best = {row["detector"].removesuffix(MEASURED): row
            for row in sorted(rows, key=lambda row: float(row["number"]))}
    figure, axes = plt.subplots(figsize=(8.3, 4.2), layout="constrained")
    axes.set_xlabel("how right: number over real clouds", fontsize=13)
    axes.set_ylabel("points that stay on their plane,\nworst tenth of clouds", fontsize=13)
    axes.tick_params(labelsize=12)
    axes.set(ylim=(0.3, 1.02))
    axes.margins(x=0.35)
    axes.grid(True, alpha=0.3)
    labels = []
    for method, row in best.items():
        shares = [float(row[f"{change}_tenth"]) for change in CHANGES]
        dot = (float(row["number"]), np.mean(shares))
        color = OUR_COLOR if method in OURS else PEER_COLOR
        axes.plot((dot[0], dot[0]), (min(shares), max(shares)), color=color, linewidth=1)
        axes.scatter(*dot, s=45, color=color)
        labels.append((NAMES.get(method, method), dot, color))
    figure.canvas.draw()
    figure.set_layout_engine("none")
    label_dots(axes, labels)
    save(figure, folder / "steadiness.png")


def labeled_points(file):
    """Points, labels and the sensor's position and axes of a PCD of pcl_ops_evaluate. The
    columns of the axes are those of the sensor in the frame of the points."""
    header, _, data = file.read_bytes().partition(b"DATA binary\n")
    pose = next(line for line in header.decode().splitlines() if line.startswith("VIEWPOINT"))
    origin, (w, x, y, z) = np.split(np.array(pose.split()[1:], dtype=float), [3])
    axes = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    points = np.frombuffer(data, dtype=[("position", "<f4", 3), ("label", "<u4")])
    return points["position"], points["label"], origin, axes


def colors_like(truth, labels):
    """The number of a color for each point: that of the true plane that has most points in common
    with the plane of the point's label, the largest common part first; other labels have numbers
    behind those of the truth."""
    colors = np.zeros(labels.max() + 1, dtype=int)
    pairs, counts = np.unique(np.stack([labels, truth]), axis=1, return_counts=True)
    used = {0}
    for label, true in pairs[:, np.argsort(-counts, kind="stable")].T:
        if label and not colors[label] and true not in used:
            colors[label] = true
            used.add(true)
    unmatched = (colors == 0) & (np.arange(colors.size) > 0)
    colors[unmatched] = truth.max() + 1 + np.arange(unmatched.sum())
    return colors[labels]


def corner_camera(points):
    """The position of a camera 0.6 m above a corner of a room's ceiling, and its axes
    (right, down, forward) as columns. It looks across the room, at 0.4 m above the
    middle of the floor."""
    low, high = np.quantile(points, (0.02, 0.98), axis=0)
    eye = np.array([low[0], high[1], high[2] + 0.6])  # [m]
    forward = np.append((low + high)[:2] / 2, low[2] + 0.4) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, (0, 0, 1))
    right /= np.linalg.norm(right)
    return eye, np.stack([right, np.cross(forward, right), forward], axis=1)


class View(NamedTuple):
    """Points in a picture: which are shown, and of these the position in it and the depth."""

    shown: np.ndarray  # a bool for each point
    columns: np.ndarray  # to the right, in any unit
    rows: np.ndarray  # downwards, in the same unit
    depths: np.ndarray  # away from the eye [m]


def seen_by(points, eye, axes, nearest=0.0, reach=np.inf):
    """The view of a camera at eye. Columns of axes point to the right, down, forward.

    nearest: nearer points are not shown [m]
    reach: tangent of half the angle of view
    """
    columns, rows, depth = ((points - eye) @ axes).T
    shown = (depth > nearest) & (np.maximum(abs(columns), abs(rows)) < reach * depth)
    depth = depth[shown]
    return View(shown, columns[shown] / depth, rows[shown] / depth, depth)


def from_above(points, center):
    """The view of the surroundings of a center from above, at a slant: turned by 37 degrees
    about z, then looking down by 30 degrees. All within 30 m, and at least 20,000 points."""
    distances = np.hypot(*(points - center).T[:2])
    radius = max(30, np.sort(distances)[min(20000, distances.size) - 1])
    shown = distances <= radius
    x, y, z = (points[shown] - center).T
    across, along = 0.8 * x + 0.6 * y, 0.8 * y - 0.6 * x
    return View(shown, across, -0.5 * along - 0.87 * z, 0.87 * along - 0.5 * z)


def view_of(points, origin, axes):
    """The view of a cloud: from its sensor if all points are before it, as those of a
    depth camera; else from a corner if the cloud is a room, less than 20 m wide; else
    from above."""
    low, high = points.min(axis=0), points.max(axis=0)
    by_camera = seen_by(points, origin, axes, reach=2)  # 127 degrees: wider than depth cameras
    if by_camera.shown.all():
        return by_camera
    if max(high - low) < 20:  # [m]
        # What is nearer, as the walls at the corner, would hide the room.
        nearest = 0.25 * np.hypot(*(high - low)[:2])
        return seen_by(points, *corner_camera(points), nearest, reach=1.2)
    margin = 0.1 * (high - low)
    inside = (low + margin < origin) & (origin < high - margin)
    return from_above(points, origin if inside[:2].all() else (low + high) / 2)


def drawn(columns, rows, depth, colors, width):
    """The image [pixels] of points as squares that close the gaps between them, the nearest in
    front. A square has an edge of 2 to 4 pixels, by the number of points in a cell of 8 x 8."""
    scale = np.ptp(columns) / (width - 5)  # squares need room at the edge
    column = ((columns - columns.min()) / scale).astype(int)
    row = ((rows - rows.min()) / scale).astype(int)
    cell = row // 8 * width + column // 8
    size = np.clip(np.ceil(8 / np.sqrt(np.bincount(cell)[cell])), 2, 4)  # [pixels]
    squares = [(point, row[point] + down, column[point] + right)
               for down in range(4) for right in range(4)
               for point in [np.flatnonzero(size > max(down, right))]]
    point, row, column = (np.concatenate(parts) for parts in zip(*squares))
    far_first = np.argsort(-depth[point], kind="stable")
    image = np.ones((row.max() + 1, width, 3))
    image[row[far_first], column[far_first]] = colors[point[far_first]]
    return image


def picture_of(points, colors, origin, axes, width=424):
    """The image of points in the colors of their planes; those on no plane are gray.

    colors: the number of a color for each point; 0: on no plane
    width: of the image [pixels]; the default is a third of a strip, less the gaps
    """
    # Without grays, which would look like points on no plane.
    palette = np.array([color for name in ("tab20", "tab20b", "tab20c", "Set1", "Dark2")
                        for color in plt.get_cmap(name).colors if np.ptp(color) > 0.15])
    view = view_of(points, origin, axes)
    colors = colors[view.shown]
    shades = np.where(colors[:, None] > 0, palette[(colors - 1) % len(palette)], 0.75)
    return drawn(view.columns, view.rows, view.depths, shades, width)


def own_names(folder):
    """Names of the users' own detectors whose labels were compared."""
    file = folder / "comparison.csv"
    if not file.exists():
        return []
    with open(file, newline="", encoding="utf-8") as stream:
        return list(dict.fromkeys(row["method"] for row in csv.DictReader(stream)
                                  if row["values"] == "own"))


def scores_of(folder):
    """F-scores by data set, cloud and configuration."""
    file = folder / "results.csv"
    if not file.exists():
        return {}
    with open(file, newline="", encoding="utf-8") as stream:
        return {(row["data_set"], row["cloud"], row["configuration"]): float(row["f_score"])
                for row in csv.DictReader(stream)}


def panels_of_strip(truth, own, scores):
    """The title and the file of the truth and of each method, by the better of its settings."""
    def score_of(setting):
        score = scores.get((*truth.parts[-3:-1], setting), np.nan)
        return -1 if np.isnan(score) else score  # without a score it is below all others

    panels = {}
    for name in (*IN_STRIP, *own):
        settings = [setting for setting in ([name] if name in own else [name, name + MEASURED])
                    if truth.with_name(setting + ".pcd").is_file()]
        if settings:
            better = max(settings, key=score_of)
            score = score_of(better)
            title = NAMES.get(name, name) + (f"\nF {score:.2f}" if score >= 0 else "\n")
            panels[title] = truth.with_name(better + ".pcd")
    return panels


def plot_strips(_, folder):
    """A picture for each cloud in labels/ (pcl_ops_evaluate run --labels), with the planes of
    every method. The first parameter is not used: other plots get rows of a table there."""
    own, scores = own_names(folder), scores_of(folder)
    for truth in sorted((folder / "labels").rglob("truth.pcd")):
        true_labels = labeled_points(truth)[1].astype(int)
        shown = {}
        for title, file in panels_of_strip(truth, own, scores).items():
            points, labels, *sensor = labeled_points(file)
            shown[title] = picture_of(points, colors_like(true_labels, labels.astype(int)), *sensor)
        rows = (len(shown) + 2) // 3
        height, title_height = len(next(iter(shown.values()))) / 100, 0.75  # [inch]
        row_height = height + title_height
        figure, panels = plt.subplots(rows, 3, squeeze=False,
                                      figsize=(12.8, row_height * rows),
                                      gridspec_kw={"left": 0, "right": 1, "bottom": 0,
                                                   "top": 1 - title_height / row_height / rows,
                                                   "wspace": 0.01, "hspace": title_height / height})
        for axes in panels.flat:
            axes.axis("off")
        for axes, (title, image) in zip(panels.flat, shown.items()):
            axes.imshow(image)
            axes.set_title(title, fontsize=20, pad=4)
        data_set, cloud = truth.parts[-3:-1]
        save(figure, folder / f"strip-{data_set}-{cloud}.png")


def plot_throughput(rows, folder):
    """Points per second over threads and kinds of clouds, and over their size."""
    shown = {"ops": "pcl_ops", "KdTreeFLANN construction": "kd-tree construction",
             "copy of the cloud": "copy of the cloud"}
    figure, (kinds, sizes) = plt.subplots(1, 2, figsize=(12.8, 4.6), layout="constrained")
    speeds, growing = defaultdict(dict), defaultdict(list)
    for row in rows:
        if row["measure"] not in shown:
            continue
        name = shown[row["measure"]]
        speed = float(row["points"]) / float(row["detection_ms"]) / 1e3  # [million points / s]
        if row["series"] == "points":
            growing[name].append((float(row["points"]), speed))
        elif row["series"] == "threads":
            threads = f", {row['x']} thread" + "s" * (row["x"] != "1")
            speeds[name + threads * (name == "pcl_ops")][row["cloud"]] = speed
    ours_first = sorted(speeds.items(), key=lambda speed: (shown["ops"] not in speed[0], speed[0]))
    for number, (name, of_clouds) in enumerate(ours_first):
        positions = np.arange(len(of_clouds)) + 0.2 * number
        bars = kinds.bar(positions, of_clouds.values(), width=0.19, label=name)
        kinds.bar_label(bars, fmt="%.3g", fontsize=9)
        kinds.set_xticks(positions - 0.1 * number, of_clouds)
    for name, dots in growing.items():
        sizes.plot(*zip(*dots), marker="o", label=name)
    sizes.set(xscale="log", xlabel="points")
    for axes in (kinds, sizes):
        axes.set(yscale="log", ylabel="million points per second")
        axes.grid(True, axis="y", alpha=0.3)
        axes.legend(fontsize=9, loc="upper left")
        axes.set_ylim(top=6 * axes.get_ylim()[1])  # room for the legend
    save(figure, folder / "throughput.png")


def plot_scaling(rows, folder):
    """The throughput, and the time over what grows in each series."""
    plot_throughput(rows, folder)
    for series in dict.fromkeys(row["series"] for row in rows if row["series"] != "threads"):
        per_point = series == "points"
        axes = plt.subplots()[1]
        axes.set(xscale="log", yscale="log")
        for measure in dict.fromkeys(row["measure"] for row in rows if row["series"] == series):
            points = [(float(row["x"]), float(row["detection_ms"]) *
                       (1e3 / float(row["points"]) if per_point else 1))
                      for row in rows if row["series"] == series and row["measure"] == measure]
            axes.plot(*zip(*points), marker="o", label=measure)
        finish(axes, "sampling rate [%]" if series == "sampling_rate" else series,
               "time per point [us]" if per_point else "time [ms]",
               folder / f"time_over_{series}.png")
