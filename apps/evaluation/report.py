#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""report.py FOLDER: tables and plots of what a program wrote into the folder.

Of results.csv (pcl_ops_evaluate run) report.md: for each data set all metrics, the tables of
the paper with its figures beside ours, numbers of planes, true planes found by size, and
times of the stages; comparison.csv, a row for each data set and method, with versions of
detectors.txt (pcl_ops_evaluate detectors); plots of the accuracy over time and over the
sampling rate. Of comparison.csv, where it has rooms or streets, figure.png: all methods on
both. Of labels/ (pcl_ops_evaluate run --labels) strips of pictures. Of scaling.csv
(pcl_ops_benchmark --scaling) throughput.png and plots of the time over what grows.
"""
import csv
import math
import pathlib
import sys
from collections import defaultdict

try:
    import figures
except ImportError:
    figures = None

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
    return report + table(f"Wall time per stage, processor time in total [s]: {name}",
                          ["configuration", *STAGES[:-1], "total", "us per point"], stages)


SUMMARY = ("classification_accuracy", "segmentation_accuracy", "f_score", "f_score_75")


def values_of(method):
    """Where the values of a method's parameters come from."""
    if method.startswith(("pcl-", "cgal-", "open3d", "voxel-octree")):
        return "cloud" if method.endswith("-measured") else "tutorial"
    return "paper" if "-" in method else "default"


def write_comparison(means_of_sets, folder):
    """A row for each data set and method: what pages and the figure are made of."""
    listed = folder / "detectors.txt"
    lines = listed.read_text(encoding="utf-8").splitlines() if listed.is_file() else []
    versions = {line.split()[0]: line.partition(", ")[2] for line in lines}
    with open(folder / "comparison.csv", "w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(("data_set", "method", "version", "values", "clouds", "stopped", *SUMMARY,
                        "seconds_per_million_points"))
        for data_set, means in means_of_sets.items():
            for method, mean in means.items():
                seconds = 1e3 * mean["detection_ms"] / mean["points"] if mean["clouds"] else ""
                table.writerow([data_set, method, versions.get(method, ""), values_of(method),
                                mean["clouds"], mean["stopped"]] +
                               [round(mean[column], 4) if mean["clouds"] else ""
                                for column in SUMMARY] + [seconds and f"{seconds:.3g}"])


def report_results(all_rows, folder):
    groups = defaultdict(list)
    for row in all_rows:
        groups[row["data_set"], row["truth"]].append(row)
    report, means_of_sets = "", {}
    for (data_set, truth), rows in sorted(groups.items()):
        name = f"{data_set}, truth {truth}"
        means = means_of_sets[data_set] = means_of(rows)
        report += metrics_table(name, means) + paper_tables(name, means) + other_tables(name, means)
        if figures:
            plots = folder / f"{data_set}-{truth}"
            plots.mkdir(exist_ok=True)
            figures.plot_accuracy(name, means, plots)
    write_comparison(means_of_sets, folder)
    (folder / "report.md").write_text(report, encoding="utf-8")
    print(report, end="")


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__.strip(), file=sys.stdout if sys.argv[1:] == ["--help"] else sys.stderr)
        return 0 if sys.argv[1:] == ["--help"] else 2
    folder = pathlib.Path(sys.argv[1])
    known = ("results.csv", "comparison.csv", "labels", "scaling.csv")
    if not any((folder / name).exists() for name in known):
        print(f"report.py: {folder}: has no {' or '.join(known)}", file=sys.stderr)
        return 1
    if not figures:
        print("report.py: no plots: install matplotlib (python3-matplotlib)", file=sys.stderr)
    plots = [figures and figures.plot_comparison, figures and figures.plot_strips,
             figures and figures.plot_scaling]
    for name, report in zip(known, [report_results, *plots]):
        if report and (folder / name).exists():
            report(rows_of(folder / name) if name.endswith(".csv") else None, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
