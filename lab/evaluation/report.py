#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""report.py FOLDER: tables and plots of what a program wrote into the folder.

Of results.csv (pcl_ops_evaluate run) report.md: for each data set all metrics, numbers of
planes, true planes found by size, times of the stages and, where it is of a kind the paper
has, the tables of the paper with its figures beside ours; how many planes a grown truth has
by the points of the smallest (truth.png); comparison.csv, a row for each data set and method,
with versions of detectors.txt (pcl_ops_evaluate detectors); plots of the accuracy over time
and over the sampling rate. Of comparison.csv figure.png: all methods on simulated and on real
data sets or, where there is one kind, on rooms and streets or the first two. Of labels/
(pcl_ops_evaluate run --labels) strips of pictures. Of scaling.csv (pcl_ops_benchmark --scaling)
throughput.png and plots of the time over what grows. Of steadiness.csv (scripts/accuracy
steadiness) steadiness.png.
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

TRUE_PLANES_OF_PAPER = 25.38  # per cloud
# The beginnings of the names of data sets beside whose numbers those of the paper stand.
OF_PAPER = ("sunrgbd", "rooms", "streets", "simulated")
STAGES = ("search", "normals", "extraction", "assignment", "merging", "detection")


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


# What the paper reports (Sun & Mordohai, ICRA 2019, Tables I to IV and section IV-B), on
# SUN RGB-D with one thread of an Intel Core i7-7700: accuracies [%], times [s] and planes per
# cloud; NaN: not given.
PAPER = {row["configuration"]: {"table": row["table"], **{
    name: float(value or "nan") for name, value in list(row.items())[2:]}}
         for row in rows_of(pathlib.Path(__file__).with_name("paper.csv"))}


KEY_COLUMNS = 5  # data set, cloud, truth, configuration, seed; numbers are behind them


def latest(rows):
    """The last of rows with the same key: a user's own labels get a row for each run."""
    return list({tuple(list(row.values())[:KEY_COLUMNS]): row for row in rows}.values())


def means_of(rows):
    """The mean of each column of numbers over the clouds, by configuration; and the numbers of
    clouds with a result and of stopped runs."""
    by_configuration = defaultdict(list)
    for row in rows:
        by_configuration[row["configuration"]].append(row)
    numbers = list(rows[0])[KEY_COLUMNS:]
    means = {}
    for configuration, all_rows in by_configuration.items():
        finished = [row for row in all_rows if row["result_planes"] != "nan"]  # and not stopped
        count = len(finished)
        means[configuration] = {
            name: sum(float(row[name]) for row in finished) / count if count else math.nan
            for name in numbers}
        means[configuration]["clouds"] = count
        means[configuration]["stopped"] = len(all_rows) - count
    return means


def text(number, decimals):
    """A number; "-" where there is none, as of a detector that took too long."""
    return "-" if math.isnan(number) else f"{number:.{decimals}f}"


def table(title, header, rows):
    """A table in Markdown; empty without a row."""
    if not rows:
        return ""
    lines = [f"**{title}**", "", "| " + " | ".join(header) + " |",
             "|:--" + "|--:" * (len(header) - 1) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n\n"


# Columns of results.csv by their titles in tables.
METRICS = {"class. %": "classification_accuracy", "segm. %": "segmentation_accuracy",
           "all points %": "segmentation_accuracy_all", "F 0.5": "f_score",
           "F 0.75": "f_score_75", "precision": "precision", "recall": "recall",
           "mean IoU": "mean_iou", "PQ": "panoptic_quality", "over": "over_segmentation",
           "under": "under_segmentation", "noise": "noise", "missed": "missed",
           "off planes %": "points_off_planes_called_planes",
           "VOI": "variation_of_information", "RI": "rand_index", "SC": "segmentation_covering",
           "on planes %": "on_planes_share", "thick, factor %": "thick_factor_share",
           "thick, length %": "thick_length_share", "rms of largest": "rms_largest"}


def metrics_table(name, means):
    """All metrics of each configuration; shares whose title has a % are percentages."""
    rows = [[configuration, str(mean["clouds"]), str(mean["stopped"])] +
            [text(100 * mean[column], 2) if "%" in title else text(mean[column], 3)
             for title, column in METRICS.items()] + [text(mean["detection_ms"] / 1e3, 4)]
            for configuration, mean in means.items()]
    return table(name, ["configuration", "clouds", "stopped", *METRICS, "total s"], rows)


def is_of_paper(data_set):
    return data_set.partition("-")[0] in OF_PAPER


def paper_tables(name, means):
    """The tables of the paper: each of our numbers with that of the paper behind it."""
    tables, best = defaultdict(list), []
    for configuration, paper in PAPER.items():
        if configuration not in means:
            continue
        mean = means[configuration]
        seconds, of_merging = mean["detection_ms"] / 1e3, mean["merging_ms"] / 1e3
        cells = [configuration, str(mean["clouds"]),
                 text(100 * mean["classification_accuracy"], 2),
                 text(paper["classification_accuracy"], 2)]
        for ours, column in ((seconds - of_merging, "seconds_before_merging"),
                             (of_merging, "seconds_of_merging"), (seconds, "seconds")):
            cells += [text(ours, 4), text(paper[column], 4)]
        tables[paper["table"]].append(cells)
        if not math.isnan(paper["segmentation_accuracy"]):
            best.append([configuration, text(100 * mean["segmentation_accuracy"], 2),
                         text(paper["segmentation_accuracy"], 2)])
    header = ["configuration", "clouds", "accuracy %", "paper", "before merging s", "paper",
              "merging s", "paper", "total s", "paper"]
    report = "".join(table(f"{title}: {name}", header, rows) for title, rows in tables.items())
    return report + table(f"Table IV, segmentation accuracy: {name}",
                          ["configuration", "accuracy %", "paper"], best)


def planes_table(name, means, has_paper):
    """Numbers of planes, ours and those of the paper unless it has none like these."""
    # Title, column, and whether it is a column of the paper.
    columns = [("before merging", "planes_before_merging", False),
               ("paper", "planes_before_merging", True), ("found", "result_planes", False),
               ("paper", "planes", True), ("truth", "truth_planes", False)]
    columns = [column for column in columns if has_paper or not column[2]]
    rows = [[configuration] + [text((PAPER.get(configuration, {}) if is_paper else mean)
                                    .get(column, math.nan), 2) for _, column, is_paper in columns]
            for configuration, mean in means.items()]
    title = f"Planes per cloud (the paper's truth: {TRUE_PLANES_OF_PAPER})" if has_paper else \
        "Planes per cloud"
    return table(f"{title}: {name}", ["configuration"] + [title for title, *_ in columns], rows)


def other_tables(name, means):
    """How many true planes of all clouds were found, by size; times of the stages."""
    report, stages = "", []
    for configuration, mean in means.items():
        stages.append([configuration] + [text(mean[stage + "_ms"] / 1e3, 4) for stage in STAGES] +
                      [text(1e3 * mean["detection_ms"] / mean["points"], 3)])
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


# Columns of results.csv in comparison.csv.
SUMMARY = ("classification_accuracy", "segmentation_accuracy", "f_score", "f_score_75")


def is_own(mean):
    """Whether the labels are of a user's own detector: such labels tell no time."""
    return mean["clouds"] > 0 and math.isnan(mean["detection_ms"])


def values_of(method, mean):
    """Where the values of a method's parameters come from."""
    if is_own(mean):
        return "own"
    if method.startswith(("pcl-", "cgal-", "open3d", "voxel-octree")):
        return "cloud" if method.endswith("-measured") else "tutorial"
    return "paper" if method in PAPER else "default"


def write_comparison(means_of_sets, folder):
    """A row for each data set and method: what pages and the figure are made of."""
    listed = folder / "detectors.txt"
    lines = listed.read_text(encoding="utf-8").splitlines() if listed.is_file() else []
    versions = {line.split()[0]: line.partition(", ")[2] for line in lines}
    with open(folder / "comparison.csv", "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(("data_set", "method", "version", "values", "clouds", "stopped", *SUMMARY,
                        "seconds_per_million_points"))
        for data_set, means in means_of_sets.items():
            for method, mean in means.items():
                has_time = mean["clouds"] > 0 and not is_own(mean)
                seconds = 1e3 * mean["detection_ms"] / mean["points"] if has_time else ""
                writer.writerow([data_set, method, versions.get(method, ""),
                                values_of(method, mean), mean["clouds"], mean["stopped"]] +
                               ["" if math.isnan(mean[column]) else round(mean[column], 4)
                                for column in SUMMARY] + [seconds and f"{seconds:.3g}"])


SMALLEST = (200, 500, 1000, 3000, 10000)  # bounds of size classes of true planes [points]


def true_planes_of(means):
    """How many true planes a cloud has on average, and how many of at least each number
    of points in SMALLEST. The first configuration is read: all have the same truth."""
    mean = next(iter(means.values()))
    counts = [mean[f"planes_by_points_below_{bound}"] for bound in SMALLEST]
    counts.append(mean[f"planes_by_points_from_{SMALLEST[-1]}"])
    return [sum(counts[i:]) for i in range(len(counts))]


def truth_table(truths):
    """Numbers of true planes of each truth; see true_planes_of."""
    rows = [[name, *(text(count, 1) for count in counts)] for name, counts in truths.items()]
    return table("True planes per cloud by the points of the smallest "
                 f"(the paper: {TRUE_PLANES_OF_PAPER})",
                 ["truth", "all", *(f"{bound} and more" for bound in SMALLEST)], rows)


def say_of_truths(groups):
    """Says which truth comparison.csv and the figure have where a data set has several."""
    truths = defaultdict(list)
    for data_set, truth in sorted(groups):
        truths[data_set].append(truth)
    for data_set, names in truths.items():
        if len(names) > 1:
            print(f"report.py: {data_set}: has the truths {', '.join(names)}; comparison.csv and "
                  f"figure.png have {names[-1]} alone", file=sys.stderr)


def report_results(all_rows, folder):
    """Writes and prints report.md, and writes comparison.csv and the plots of accuracies."""
    groups = defaultdict(list)
    for row in latest(all_rows):
        groups[row["data_set"], row["truth"]].append(row)
    say_of_truths(groups)
    report, truths = "", {}
    means_of_sets = {}  # of several truths of a data set the last one by name
    for (data_set, truth), rows in sorted(groups.items()):
        name = f"{data_set}, truth {truth}"
        means = means_of_sets[data_set] = means_of(rows)
        if truth.startswith("grown"):
            truths[name] = true_planes_of(means)
        report += metrics_table(name, means)
        if is_of_paper(data_set):
            report += paper_tables(name, means)
        report += planes_table(name, means, is_of_paper(data_set)) + other_tables(name, means)
        if figures:
            plots = folder / f"{data_set}-{truth}"
            plots.mkdir(exist_ok=True)
            figures.plot_accuracy(name, means, plots)
    report += truth_table(truths)
    if figures and truths:
        figures.plot_true_planes(truths, SMALLEST, TRUE_PLANES_OF_PAPER, folder / "truth.png")
    write_comparison(means_of_sets, folder)
    (folder / "report.md").write_text(report, encoding="utf-8")
    print(report, end="")


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__.strip(), file=sys.stdout if sys.argv[1:] == ["--help"] else sys.stderr)
        return 0 if sys.argv[1:] == ["--help"] else 2
    folder = pathlib.Path(sys.argv[1])
    known = ("results.csv", "comparison.csv", "labels", "scaling.csv", "steadiness.csv")
    if not any((folder / name).exists() for name in known):
        print(f"report.py: {folder}: has no {' or '.join(known)}", file=sys.stderr)
        return 1
    if not figures:
        print("report.py: no plots: install matplotlib (python3-matplotlib)", file=sys.stderr)
    plots = [figures and figures.plot_comparison, figures and figures.plot_strips,
             figures and figures.plot_scaling, figures and figures.plot_steadiness]
    for name, report in zip(known, [report_results, *plots]):
        if report and (folder / name).exists():
            report(rows_of(folder / name) if name.endswith(".csv") else None, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
