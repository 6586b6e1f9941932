# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""report_test.py REPORT EVALUATE: the report of a small run."""
import csv
import pathlib
import subprocess
import sys
import tempfile

report, evaluate = sys.argv[1:]
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run([evaluate, "run", name, "simulated:3000", "--detectors", "ops-3-30"],
                   check=True, capture_output=True)
    results = folder / "results.csv"
    header, row = results.read_text(encoding="utf-8").splitlines()
    stopped = ["streets", "a", "exact", "pcl-sac", "42"] + ["nan"] * (header.count(",") - 4)
    with results.open("a", encoding="utf-8") as stream:
        print(row.replace("simulated", "rooms"), row.replace("simulated", "streets"),
              ",".join(stopped), sep="\n", file=stream)
    (folder / "scaling.csv").write_text(
        "series,x,points,measure,cloud,detection_ms\nthreads,1,9,ops,a,2\n"
        "threads,2,9,ops,a,1\npoints,9,9,ops,b,1\n", encoding="utf-8")
    subprocess.run([evaluate, "run", folder / "strip", "simulated:3000", "--detectors", "ops",
                    "--labels", folder / "labels"], check=True, capture_output=True)
    (folder / "detectors.txt").write_text(
        subprocess.run([evaluate, "detectors"], check=True, capture_output=True, text=True).stdout,
        encoding="utf-8")
    said = subprocess.run([sys.executable, report, name], check=True, capture_output=True,
                          text=True)
    tables = (folder / "report.md").read_text(encoding="utf-8")
    for part in ("Table III", "87.39", "0.6455", "below 0.03", "| ops-3-30 | 1 |",
                 "| pcl-sac | 0 | 1 | - |"):
        assert part in tables, part
    assert "Table II," not in tables
    with open(folder / "comparison.csv", newline="", encoding="utf-8") as stream:
        compared = {(row["data_set"], row["method"]): row for row in csv.DictReader(stream)}
    ours = compared["rooms", "ops-3-30"]
    assert ours["version"].startswith("pcl_ops ") and ours["values"] == "paper", ours
    assert 0 < float(ours["seconds_per_million_points"]) < 1000, ours
    assert compared["streets", "pcl-sac"]["stopped"] == "1"
    assert compared["streets", "pcl-sac"]["f_score"] == ""
    assert tables == said.stdout
    if "no plots" not in said.stderr:
        for plot in ("simulated-exact/classification_accuracy_over_time.png",
                     "time_over_points.png", "throughput.png", "figure.png",
                     "strip-scan-3000.png"):
            assert (folder / plot).stat().st_size > 1000, plot
assert subprocess.run([sys.executable, report, name], check=False,
                      capture_output=True).returncode == 1
