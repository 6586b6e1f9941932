#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""report.py FOLDER: tables and plots of what a program wrote into the folder.

Of results.csv (pcl_ops_evaluate run) report.md: for each data set all metrics, the tables of
the paper with its figures beside ours, numbers of planes, true planes found by size, and
times of the stages; plots of the accuracy over time and over the sampling rate; and where
there are rooms or streets figure.png, all detectors on both. Of scaling.csv
(pcl_ops_benchmark --scaling) plots of the time over what grows.
"""
import csv
import math
import pathlib
import sys
from collections import defaultdict

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
except ImportError:
    plt = None

# What the paper reports (Sun & Mordohai, ICRA 2019, Tables I to IV and section IV-B), on
# SUN RGB-D with one thread of an Intel Core i7-7700: classification accuracy [%], time
# before merging [s], of merging [s], in total [s]; None: not given.
TABLES = {
    "Table I, FSPF by radii [m]": {
        "fspf-0.03-0.03": (61.34, 0.0974, 0.1895, 0.2997),
        "fspf-0.05-0.05": (68.07, 0.1102, 0.2103, 0.3003),
        "fspf-0.07-0.07": (69.68, 0.2106, 0.1937, 0.4043),
        "fspf-0.1-0.1": (71.14, 0.2479, 0.2145, 0.4642),
        "fspf-0.3-0.3": (73.12, 2.6423, 0.3293, 2.9716),
        "fspf-0.03-0.06": (69.01, 0.1139, 0.2415, 0.3554),
        "fspf-0.05-0.1": (71.11, 0.1973, 0.2487, 0.4460),
        "fspf-0.07-0.14": (72.50, 0.3441, 0.2785, 0.6226),
        "fspf-0.1-0.2": (73.61, 0.7277, 0.3180, 1.0457),
        "fspf-0.3-0.6": (66.26, 2.7624, 0.4960, 3.2584),
    },
    "Table II, 3D-KHT by angular and radial bins": {
        "kht-30-300": (67.08, None, None, 0.0837),
        "kht-40-400": (67.86, None, None, 0.1448),
        "kht-60-600": (69.53, None, None, 0.3674),
        "kht-80-800": (71.01, None, None, 0.7941),
    },
    "Table III, OPS by sampling rate [%] and neighbors; s1: strategy 1": {
        "ops-0.3-10": (71.52, 0.0244, None, 0.0359),
        "ops-0.3-20": (72.18, 0.0347, None, 0.0460),
        "ops-0.3-30": (72.29, 0.0458, None, 0.0565),
        "ops-0.5-10": (77.11, 0.0452, None, 0.0625),
        "ops-0.5-20": (77.48, 0.0644, None, 0.0803),
        "ops-0.5-30": (77.59, 0.0833, None, 0.0987),
        "ops-0.7-10": (80.04, 0.0656, None, 0.0853),
        "ops-0.7-20": (80.28, 0.0906, None, 0.1093),
        "ops-0.7-30": (80.34, 0.1184, None, 0.1363),
        "ops-1-10": (82.55, 0.1008, None, 0.1233),
        "ops-1-20": (82.66, 0.1375, None, 0.1587),
        "ops-1-30": (82.71, 0.1759, None, 0.1967),
        "ops-3-10": (86.91, 0.4092, None, 0.4377),
        "ops-3-20": (87.23, 0.5096, None, 0.5366),
        "ops-3-30": (87.39, 0.6188, None, 0.6455),
        "ops-s1-3-10": (74.25, None, None, None),
        "ops-s1-3-20": (75.04, None, None, None),
        "ops-s1-3-30": (75.89, None, None, None),
    },
}
# Table IV: segmentation accuracy [%], planes before merging and in the end per cloud.
BEST = {
    "fspf-0.07-0.14": (74.72, 386.92, 29.44),
    "kht-80-800": (62.26, None, None),
    "ops-3-30": (82.99, 34.62, 27.59),
}
TRUE_PLANES = 25.38  # of the paper, per cloud
STAGES = ("search", "normals", "extraction", "assignment", "merging", "detection")
FAMILIES = {"OPS": "ops", "FSPF": "fspf", "3D-KHT": "kht", "PCL": "pcl", "CGAL": "cgal",
            "Open3D": "open3d", "voxel octree": "voxel"}


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def means_of(rows):
    """The mean of each column of numbers over the clouds, by configuration."""
    by_configuration = defaultdict(list)
    for row in rows:
        by_configuration[row["configuration"]].append(row)
    numbers = list(rows[0])[5:]  # behind data set, cloud, truth, configuration, seed
    means = {}
    for configuration, rows_of in by_configuration.items():
        finished = [row for row in rows_of if row["f_score"] != "nan"]  # and not stopped
        count = len(finished)
        means[configuration] = {
            name: sum(float(row[name]) for row in finished) / count if count else math.nan
            for name in numbers}
        means[configuration]["clouds"] = count
        means[configuration]["stopped"] = len(rows_of) - count
    return means


def text(number, decimals):
    """A number; "-" where there is none, as of a detector that took too long."""
    return "-" if number is None or math.isnan(number) else f"{number:.{decimals}f}"


def table(title, header, rows):
    """A table in Markdown; empty without a row."""
    if not rows:
        return ""
    lines = [f"**{title}**", "", "| " + " | ".join(header) + " |",
             "|:--" + "|--:" * (len(header) - 1) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n\n"


METRICS = {"class. %": "classification_accuracy", "segm. %": "segmentation_accuracy",
           "all points %": "segmentation_accuracy_all", "F 0.5": "f_score",
           "F 0.75": "f_score_75", "precision": "precision", "recall": "recall",
           "mean IoU": "mean_iou", "PQ": "panoptic_quality", "over": "over_segmentation",
           "under": "under_segmentation", "noise": "noise", "missed": "missed",
           "off planes %": "points_off_planes_called_planes"}


def metrics_table(name, means):
    rows = [[configuration, str(mean["clouds"]), str(mean["stopped"])] +
            [text(100 * mean[column], 2) if "%" in title else text(mean[column], 3)
             for title, column in METRICS.items()] + [text(mean["detection_ms"] / 1e3, 4)]
            for configuration, mean in means.items()]
    return table(name, ["configuration", "clouds", "stopped", *METRICS, "total s"], rows)


def paper_tables(name, means):
    header = ["configuration", "clouds", "accuracy %", "paper", "before merging s", "paper",
              "merging s", "paper", "total s", "paper"]
    report = ""
    for title, figures in TABLES.items():
        rows = []
        for configuration, (accuracy, detection, merging, total) in figures.items():
            if configuration not in means:
                continue
            mean = means[configuration]
            seconds = mean["detection_ms"] / 1e3
            of_merging = mean["merging_ms"] / 1e3
            rows.append([configuration, str(mean["clouds"]),
                         text(100 * mean["classification_accuracy"], 2), text(accuracy, 2),
                         text(seconds - of_merging, 4), text(detection, 4),
                         text(of_merging, 4), text(merging, 4),
                         text(seconds, 4), text(total, 4)])
        report += table(f"{title}: {name}", header, rows)
    rows = [[configuration, text(100 * means[configuration]["segmentation_accuracy"], 2),
             text(figures[0], 2)]
            for configuration, figures in BEST.items() if configuration in means]
    return report + table(f"Table IV, segmentation accuracy: {name}",
                          ["configuration", "accuracy %", "paper"], rows)


def other_tables(name, means):
    planes, stages = [], []
    for configuration, mean in means.items():
        _, before, found = BEST.get(configuration, (None, None, None))
        planes.append([configuration, text(mean["planes_before_merging"], 2), text(before, 2),
                       text(mean["result_planes"], 2), text(found, 2),
                       text(mean["truth_planes"], 2)])
        stages.append([configuration] + [text(mean[stage + "_ms"] / 1e3, 4) for stage in STAGES] +
                      [text(1e3 * mean["detection_ms"] / mean["points"], 3)])
    report = table(f"Planes per cloud (the paper's truth: {TRUE_PLANES}): {name}",
                   ["configuration", "before merging", "paper", "found", "paper", "truth"],
                   planes)
    for by, unit in (("points", ""), ("width", " [m]")):
        prefix = f"planes_by_{by}_"
        classes = [column[len(prefix):] for column in next(iter(means.values()))
                   if column.startswith(prefix)]
        rows = [[configuration] +
                [" / ".join(text(mean[f"{what}_by_{by}_{size}"] * mean["clouds"], 0)
                            for what in ("found", "found_75", "planes")) for size in classes]
                for configuration, mean in means.items()]
        report += table(f"True planes by {by}{unit}, found at 0.5 / at 0.75 / all: {name}",
                        ["configuration"] + [size.replace("_", " ") for size in classes], rows)
    return report + table(f"Time per stage [s]: {name}",
                          ["configuration", *STAGES[:-1], "total", "us per point"], stages)


def finish(axes, x_label, y_label, file):
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    axes.grid(True)
    axes.legend(fontsize=7)
    axes.figure.savefig(file, dpi=120, bbox_inches="tight")
    plt.close(axes.figure)


def plot_accuracy(name, means, folder):
    for metric in ("classification_accuracy", "segmentation_accuracy"):
        label = metric.replace("_", " ") + " [%]"
        axes = plt.subplots()[1]
        axes.set(title=name, xscale="log", ylim=(0, 100))
        for family, prefix in FAMILIES.items():
            points = {configuration: (mean["detection_ms"] / 1e3, 100 * mean[metric])
                      for configuration, mean in means.items()
                      if configuration.startswith(prefix)}
            if points:
                axes.scatter(*zip(*points.values()), label=family)
            for configuration, point in points.items():
                axes.annotate(configuration, point, fontsize=5)
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


def plot_figure(means_of_sets, folder):
    """F-score over the time per million points, a panel each for rooms and streets."""
    shown = {name: means for name, means in means_of_sets.items() if name in ("rooms", "streets")}
    if not shown:
        return
    figure, panels = plt.subplots(1, len(shown), sharey=True, squeeze=False,
                                  figsize=(5.5 * len(shown), 4.5))
    for axes, (name, means) in zip(panels[0], sorted(shown.items())):
        clouds = max(mean["clouds"] for mean in means.values())
        axes.set(title=f"{name} (mean of {clouds})", xscale="log", ylim=(0, 1))
        axes.margins(x=0.25)
        axes.grid(True, alpha=0.3)
        for number, (family, prefix) in enumerate(FAMILIES.items()):
            dots = {configuration: (1e3 * mean["detection_ms"] / mean["points"], mean["f_score"])
                    for configuration, mean in means.items()
                    if configuration.startswith(prefix) and not math.isnan(mean["f_score"])}
            for configuration, dot in dots.items():
                is_measured = configuration.endswith("-measured")
                axes.scatter(*dot, color=f"C{number}", label=None if is_measured else family,
                             facecolors="none" if is_measured else None)
                axes.annotate(configuration.replace("-measured", ""), dot, xytext=(4, 3),
                              textcoords="offset points", fontsize=6)
        axes.set_xlabel("time per million points [s]; open dots: at measured values")
    panels[0][0].set_ylabel("F-score of planes at an overlap of 0.5")
    handles, labels = panels[0][-1].get_legend_handles_labels()
    panels[0][-1].legend(*zip(*dict(zip(labels, zip(handles, labels))).values()), fontsize=7)
    figure.savefig(folder / "figure.png", dpi=120, bbox_inches="tight")
    plt.close(figure)


def report_results(folder):
    groups = defaultdict(list)
    for row in rows_of(folder / "results.csv"):
        groups[row["data_set"], row["truth"]].append(row)
    report, means_of_sets = "", {}
    for (data_set, truth), rows in sorted(groups.items()):
        name = f"{data_set}, truth {truth}"
        means = means_of_sets[data_set] = means_of(rows)
        report += metrics_table(name, means) + paper_tables(name, means) + other_tables(name, means)
        if plt:
            plots = folder / f"{data_set}-{truth}"
            plots.mkdir(exist_ok=True)
            plot_accuracy(name, means, plots)
    if plt:
        plot_figure(means_of_sets, folder)
    (folder / "report.md").write_text(report, encoding="utf-8")
    print(report, end="")


def plot_scaling(folder):
    if not plt:
        return
    rows = rows_of(folder / "scaling.csv")
    for series in dict.fromkeys(row["series"] for row in rows):
        per_point = series == "points"
        axes = plt.subplots()[1]
        if series != "threads":
            axes.set(xscale="log", yscale="log")
        for measure in dict.fromkeys(row["measure"] for row in rows if row["series"] == series):
            points = [(float(row["x"]), float(row["detection_ms"]) *
                       (1e3 / float(row["points"]) if per_point else 1))
                      for row in rows if row["series"] == series and row["measure"] == measure]
            axes.plot(*zip(*points), marker="o", label=measure)
        finish(axes, "sampling rate [%]" if series == "sampling_rate" else series,
               "time per point [us]" if per_point else "time [ms]",
               folder / f"time_over_{series}.png")


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__.strip(), file=sys.stdout if sys.argv[1:] == ["--help"] else sys.stderr)
        return 0 if sys.argv[1:] == ["--help"] else 2
    folder = pathlib.Path(sys.argv[1])
    reports = {"results.csv": report_results, "scaling.csv": plot_scaling}
    found = [name for name in reports if (folder / name).is_file()]
    if not found:
        print(f"report.py: {folder}: has no {' or '.join(reports)}", file=sys.stderr)
        return 1
    if not plt:
        print("report.py: no plots: install matplotlib (python3-matplotlib)", file=sys.stderr)
    for name in found:
        reports[name](folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
