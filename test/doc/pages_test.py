# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of README.md and of the pages of src/doc run, their links lead somewhere, and their
numbers are those of the CSV files.

python3 pages_test.py SOURCES PROGRAMS: the project's folder, and that of its programs.
python3 pages_test.py SOURCES --fill: writes the numbers of src/doc/comparison.csv into tables.
"""

import csv
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

SOURCES, PROGRAMS = pathlib.Path(sys.argv[1]), sys.argv[2]
README = SOURCES / "README.md"
PAGES = [README, *sorted((SOURCES / "src/doc").glob("*.md"))]
ROOM_OPTIONS = "--seed 1 --width 160 --height 120"
# Beginnings of the commands that are run. Others need a display, real data or minutes.
RUN = ("pcl_ops_simulate ", "pcl_ops_segment ", "cat room.pcd | ", "pcl_ops_tiles ",
       "pcl_ops_evaluate compare ", "pcl_ops_evaluate ground ", "pcl_ops_evaluate planes ",
       "pcl_ops_evaluate track ",
       "printf ")

# Columns of src/doc/comparison.csv by their titles in tables of the pages: the column, a factor and
# the number of decimals, or None for two significant digits.
MEASURES = {"class.": ("classification_accuracy", 100, 1),
            "segm.": ("segmentation_accuracy", 100, 1), "F 0.5": ("f_score", 1, 2),
            "F 0.75": ("f_score_75", 1, 2), "s": ("seconds_per_million_points", 1, None)}
# Data sets and methods of src/doc/comparison.csv by their titles in tables of the pages.
DATA_SETS = {"rooms": "rooms", "rooms, raw depth": "rooms-raw", "frames": "sunrgbd",
             "frames, raw depth": "sunrgbd-raw", "64 beams": "streets", "32 beams": "streets-32",
             "16 beams": "streets-16", "roofs": "roofs", "CAD": "cad", "surveys": "survey",
             "furniture": "furniture", "round shapes": "shapes",
             "ScanNet": "real-room_scannet", "NavVis": "real-room_navvis",
             "facades": "real-facade_nuist",
             "facades, parts apart": "real-instances-facade_nuist",
             "RoofN3D": "real-roof_roofn3d"}
METHODS = {"pcl_ops": "ops", "pcl_ops, as in the paper": "ops-3-30", "3D-KHT": "kht",
           "FSPF": "fspf", "PCL `SACSegmentation` loop": "pcl-sac",
           "PCL `RegionGrowing`": "pcl-region-growing",
           "PCL `OrganizedMultiPlaneSegmentation`": "pcl-organized",
           "PCL organized planes": "pcl-organized",
           "CGAL Efficient RANSAC": "cgal-ransac",
           "CGAL region growing": "cgal-region-growing",
           "Open3D `segment_plane` loop": "open3d", "Voxel octree as in VoxelMap": "voxel-octree"}
OURS = ("ops", "ops-3-30", "kht", "fspf")
# Pages with such tables, and how many.
COMPARISONS = {README: 1, SOURCES / "src/doc/accuracy.md": 4}
# Sentences of README with figures: a pattern with a group for each, and the table's cell it is.
REGION_GROWING = "CGAL region growing"
CLAIMS = [
    (r"CGAL's region growing, told their noise, has an F of (\S+) in a room of ScanNet and of "
     r"(\S+) in an office of NavVis",
     [("ScanNet", REGION_GROWING, "F 0.5"), ("NavVis", REGION_GROWING, "F 0.5")])]
# A figure of accuracy or time: a decimal fraction, a percentage, a time.
FIGURE = re.compile(r"(?<![\w.])(?:\d*\.\d+|\d[\d,]*(?= ?(?:%|(?:ms|s|seconds|minutes)\b)))")
# Rows of the table of scenes with faults: data set, number of clouds, F at both overlaps or a dash.
FAULTS = re.compile(r"^\| `([a-z-]+):1-(\d+)` \| (-|[\d.]+/[\d.]+) \|", re.MULTILINE)
# Rows of the table of stability, and the columns of accuracy.csv.
CHANGES = {"moved": "moved", "turned": "turned", "1 % of the points left out": "thinned",
           "jitter of .1 mm": "jittered", "rounded to whole millimeters": "rounded"}
# Rows of the table of steadiness: a detector, its number, and the median and the worst tenth of
# the agreements of five changes.
STEADY = re.compile(r"(?m)^\| (.+?) (\| \.\d+(?: \| [\d.]+/[\d.]+){5} \|)$")
NUMBER = re.compile(r"The number of the default is (\.\d+) over all (\d+) clouds of the (\d+) sets")
# Figures in sentences that are no results: the overlap from which a plane counts as found.
DEFINITIONS = {"0.5"}


def compared():
    """The rows of the comparison by data set and method."""
    with open(SOURCES / "src/doc/comparison.csv", newline="", encoding="utf-8") as stream:
        return {(row["data_set"], row["method"]): row for row in csv.DictReader(stream)}


def comparison_tables(page):
    """The tables whose first cell names measures, each as a list of rows of cells."""
    for block in re.findall(r"(?:^\|.*\n)+", page.read_text(), re.MULTILINE):
        rows = [[cell.strip() for cell in line.strip("|").split("|")]
                for line in block.splitlines()]
        if set(measures_of(rows[0][0])) <= set(MEASURES):
            yield rows


def measures_of(cell):
    """The titles of measures in the first cell of a table: those of "F 0.5 / s [better]"."""
    return re.sub(r" \[.*?\]|, better.*", "", cell).split(" / ")


def expected_cell(rows, measures):
    """The best value of each measure over the settings of a method; a dash if it has none."""
    rows = [row for row in rows if row["f_score"]]
    if not rows:
        return "-"
    texts = []
    for name, factor, decimals in (MEASURES[measure] for measure in measures):
        values = [factor * float(row[name]) for row in rows]
        # Only times have no number of decimals: the shortest is the best.
        texts.append(f"{min(values):.2g}" if decimals is None else f"{max(values):.{decimals}f}")
    return "/".join(texts)


def expected_row(header, label, table):
    """The cells that the row of a method should have.

    table: see compared
    """
    names = METHODS[label], METHODS[label] + "-measured"
    cells = []
    for column in header[1:]:
        data_set, unit, clouds = re.match(r"(.*?)( \[s\])?(?: \((\d+)\))?$", column).groups()
        rows = [table[DATA_SETS[data_set], name] for name in names
                if (DATA_SETS[data_set], name) in table]
        for row in rows:
            if clouds and int(row["clouds"]) + int(row["stopped"]) != int(clouds):
                raise AssertionError(f"{column}: {row}")
        cells.append(expected_cell(rows, ["s"] if unit else measures_of(header[0])))
    return [label, *cells]


def without_fences(text):
    """A text without its blocks of code."""
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def prose_of(page):
    """What a page says in sentences, one line: no code, tables and targets of links."""
    text = without_fences(page.read_text())
    lines = [line for line in text.splitlines() if not line.startswith(("|", "#", "!"))]
    text = re.sub(r"\]\([^)]*\)", "]", " ".join(lines))
    return re.sub(r"\s+", " ", text)


def without_code(text):
    return re.sub(r"`[^`]*`", "", text)


def fill_tables(page):
    """Writes the numbers of the comparison into the tables of a page."""
    table, text = compared(), page.read_text()
    for header, _, *rows in comparison_tables(page):
        for row in rows:
            new = expected_row(header, row[0], table)
            text = text.replace(f"| {' | '.join(row)} |\n", f"| {' | '.join(new)} |\n")
    page.write_text(text)


def stored_accuracy():
    """The rows of what scripts/accuracy stored, by set."""
    with open(SOURCES / "src/doc/accuracy.csv", newline="", encoding="utf-8") as stream:
        return {row["set"]: row for row in csv.DictReader(stream)}


def faults_scores():
    """The F-scores of the default on scenes with faults by set, and the number of clouds."""
    return {name: (row["clouds"], "/".join(f"{float(row[measure] or 'nan'):.2f}"
                                           for measure in ("f_score", "f_score_75")))
            for name, row in stored_accuracy().items()}


def thousandths(value):
    """A share as ".123"."""
    return f"{float(value):.3f}".removeprefix("0")


def stored_number():
    """The one number over all sets, and the numbers of clouds and of sets, as texts.

    The head of scripts/accuracy says how the number is made.
    """
    sets = [row for row in stored_accuracy().values() if row["clouds"]]
    truth = [float(row["f_score"]) for row in sets if row["f_score"]]
    thin = [float(row["on_planes_share"]) - 2.0 * float(row["thick_length_share"])
            for row in sets if not row["f_score"]]
    number = 0.75 * statistics.fmean(truth) + 0.25 * statistics.fmean(thin)
    clouds = sum(int(row["clouds"]) for row in sets)
    return thousandths(number), str(clouds), str(len(sets))


def stability_cells(change):
    """The median and the worst tenth of the agreements of a change over real clouds."""
    stored = stored_accuracy()
    return [thousandths(stored[row][CHANGES[change]]) for row in ("real-median", "real-tenth")]


def steadiness_cells(label):
    """The cells of a detector, by that of its settings that has the higher number."""
    with open(SOURCES / "src/doc/steadiness.csv", newline="", encoding="utf-8") as stream:
        rows = [row for row in csv.DictReader(stream)
                if row["detector"].removesuffix("-measured") == METHODS[label]]
    best = max(rows, key=lambda row: float(row["number"]))
    agreements = ["/".join(thousandths(best[f"{change}_{end}"]) for end in ("median", "tenth"))
                  for change in CHANGES.values()]
    return f"| {' | '.join([thousandths(best['number']), *agreements])} |"


def fill_accuracy(page):
    """Writes what scripts/accuracy stored into a page."""
    scores = faults_scores()
    text = FAULTS.sub(lambda row: f"| `{row[1]}:1-{row[2]}` | {scores[row[1]][1]} |",
                      page.read_text())
    number, clouds, sets = stored_number()
    text = NUMBER.sub(f"The number of the default is {number} over all {clouds} clouds of the "
                      f"{sets} sets", text)
    for change in CHANGES:
        text = re.sub(rf"(?m)^\| {re.escape(change)} \| [\d.]+ \| [\d.]+ \|",
                      f"| {change} | {' | '.join(stability_cells(change))} |", text)
    text = STEADY.sub(lambda row: f"| {row[1]} {steadiness_cells(row[1])}", text)
    page.write_text(text)


def code_in(text, language):
    """The lines of a text that stand in fences of this language."""
    return "".join(re.findall(rf"^```{language}\n(.*?)^```", text,
                              re.MULTILINE | re.DOTALL)).splitlines()


def code_of(page, language):
    return code_in(page.read_text(), language)


def section_of(page, heading):
    """What a page says below a heading of the second level."""
    return page.read_text().partition(f"\n## {heading}\n")[2].partition("\n## ")[0]


def smaller(command):
    """A command with options that keep a simulation short."""
    sized = ("--points", "--scene street", "--scene drive")
    if not command.startswith("pcl_ops_simulate ") or any(option in command for option in sized):
        return command
    if "--scene walk" in command:
        return command + " --frames 5 --width 80 --height 60"
    return command + (" --points 5000" if "--scene" in command else " --width 160 --height 120")


def sections_in(text):
    """The names of headings in links: small letters, digits and _, hyphens for blanks."""
    return [re.sub(r"[^a-z0-9_ -]", "", heading.lower()).replace(" ", "-")
            for heading in re.findall(r"^#+ (.*)", without_fences(text), re.MULTILINE)]


class Pages(unittest.TestCase):
    def run_in(self, folder, command):
        done = subprocess.run(
            ["sh", "-c", command], cwd=folder, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, check=False,
            env={**os.environ, "PATH": PROGRAMS + os.pathsep + os.environ["PATH"]})
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}")

    def test_commands_run(self):
        for page in PAGES:
            commands = [smaller(command) for command in code_of(page, "sh")
                        if command.startswith(RUN)]
            if not commands:
                continue
            # The clouds that the commands of the pages read: room.pcd and a folder of scans.
            with self.subTest(page.name), tempfile.TemporaryDirectory() as folder:
                os.mkdir(os.path.join(folder, "scans"))
                for cloud in ("room", "scans/first", "scans/second"):
                    self.run_in(folder, f"pcl_ops_simulate {cloud}.pcd {ROOM_OPTIONS}")
                for command in commands:
                    self.run_in(folder, command)

    def test_the_section_for_ones_own_detector_gives_it_a_row(self):
        section = section_of(SOURCES / "src/doc/accuracy.md", "Compare your detector")
        has_numpy = subprocess.run([sys.executable, "-c", "import numpy"], check=False,
                                   stderr=subprocess.DEVNULL).returncode == 0
        if not has_numpy:
            self.skipTest("the example needs NumPy")
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            (here / "lab").symlink_to((SOURCES / "lab").resolve())
            # The commands of the page call python3: let it be this one, which has NumPy.
            (here / "python3").symlink_to(sys.executable)
            (here / "detector.py").write_text("\n".join(code_in(section, "python")))
            commands = code_in(section, "sh")
            self.assertEqual(len(commands), 4)
            for command in commands:
                self.run_in(folder, f'PATH="$PWD:$PATH"; {command}')
            with open(here / "out/comparison.csv", newline="", encoding="utf-8") as stream:
                rows = {row["method"]: row for row in csv.DictReader(stream)}
        self.assertEqual(rows["mine"]["values"], "own")
        self.assertGreater(float(rows["mine"]["classification_accuracy"]), 0.5)

    def test_links_lead_to_files_and_sections(self):
        for page in PAGES:
            # A link to a section of the page itself has no name.
            for name, section in re.findall(r"\]\(([^)#:]*)(?:#([^)]+))?\)",
                                            page.read_text()):
                target = page.parent / name if name else page
                self.assertTrue(target.exists(), f"{page.name} links to {name}")
                self.assertTrue(not section or section in sections_in(target.read_text()),
                                f"{page.name} links to {name}#{section}")

    def test_comments_of_code_are_no_sections(self):
        text = "# Title\n\n```sh\n# of each frame\ntrue\n```\n\n## Files, too\n"
        self.assertEqual(sections_in(text), ["title", "files-too"])

    def test_main_page_and_readme_link_to_all(self):
        starts = [README, SOURCES / "src/doc/main.md"]
        for start in starts:
            for page in PAGES:
                if page not in starts:
                    self.assertIn(page.name + ")", start.read_text(), start.name)

    def test_readme_has_the_lines_of_the_first_example(self):
        example = (SOURCES / "apps/examples/minimal.cpp").read_text()
        lines = code_of(README, "cpp")
        self.assertGreaterEqual(len(lines), 4)
        for line in lines:
            # README has comments behind some statements, which the example does not have.
            self.assertIn(line.partition(";")[0], example)

    def test_comparisons_have_the_numbers_of_the_csv(self):
        table = compared()
        for page, tables in COMPARISONS.items():
            found = list(comparison_tables(page))
            self.assertEqual(len(found), tables, page.name)
            for header, _, *rows in found:
                for row in rows:
                    self.assertEqual(row, expected_row(header, row[0], table), page.name)

    def test_figures_in_sentences_of_readme_are_those_of_the_csv(self):
        table, text = compared(), prose_of(README)
        for pattern, cells in CLAIMS:
            found = re.search(pattern, text)
            self.assertIsNotNone(found, pattern)
            expected = []
            for data_set, label, measure in cells:
                names = METHODS[label], METHODS[label] + "-measured"
                rows = [table[DATA_SETS[data_set], name] for name in names
                        if (DATA_SETS[data_set], name) in table]
                expected.append(expected_cell(rows, [measure]))
            self.assertEqual(list(found.groups()), expected, pattern)

    def test_readme_has_no_other_figures_in_sentences(self):
        text = prose_of(README)
        for pattern, _ in CLAIMS:
            text = re.sub(pattern, "", text)
        others = set(FIGURE.findall(without_code(text))) - DEFINITIONS
        self.assertEqual(others, set(), "these need a cell of a CSV, and a line in CLAIMS")

    def test_scenes_with_faults_have_the_f_scores_of_the_csv(self):
        stored = faults_scores()
        rows = FAULTS.findall((SOURCES / "src/doc/accuracy.md").read_text())
        self.assertGreaterEqual(len(rows), 5)
        for name, clouds, scores in rows:
            # A dash says that no value is known.
            if scores != "-":
                self.assertEqual((clouds, scores), stored[name], name)

    def test_accuracy_has_the_stored_number_and_agreements(self):
        page = (SOURCES / "src/doc/accuracy.md").read_text()
        found = NUMBER.search(page)
        self.assertIsNotNone(found)
        self.assertEqual(found.groups(), stored_number())
        for change in CHANGES:
            cells = re.search(rf"(?m)^\| {re.escape(change)} \| (.*?) \| (.*?) \|", page)
            self.assertIsNotNone(cells, change)
            self.assertEqual(list(cells.groups()), stability_cells(change), change)

    def test_accuracy_has_the_steadiness_of_detectors(self):
        rows = STEADY.findall((SOURCES / "src/doc/accuracy.md").read_text())
        self.assertGreaterEqual(len(rows), 5)
        for label, cells in rows:
            self.assertEqual(cells, steadiness_cells(label), label)

    def test_accuracy_has_the_bounds_of_the_test_of_worst_cases(self):
        test = (SOURCES / "lab/test/benchmark/measures_test.cpp").read_text()
        test = test.partition("TakeBoundedMultiplesOfTheTimeAndMemoryOfARoom")[2]
        bounds = [re.search(rf"{what}_bound = (\d+)\.0;", test)[1] for what in ("time", "memory")]
        self.assertIn("**Worst cases.** A test holds all presets to {} times the processor time, "
                      "and {} times the memory, of ".format(*bounds),
                      prose_of(SOURCES / "src/doc/accuracy.md"))

    def test_the_drawing_of_the_stages_has_the_functions_of_the_source(self):
        drawing = (SOURCES / "src/doc/images/stages.svg").read_text()
        source = (SOURCES / "src/ops/detect_on_places.cpp").read_text()
        main_function = source[source.index("LabeledPlanes\ndetectOnPlaces"):]
        names = ", ".join(re.findall(r'class="title">(.*?)<', drawing)).split(", ")
        self.assertGreater(len(names), 7)
        for name in names:
            self.assertIn(f"{name} (", main_function, name)

    def test_accuracy_says_where_others_are_ahead(self):
        page = (SOURCES / "src/doc/accuracy.md").read_text()
        paragraph = page.partition("**Where others are ahead.**")[2].partition("\n\n")[0]
        labels = {name: label for label, name in DATA_SETS.items()}
        table = compared()
        for (data_set, method), row in table.items():
            for measure in ("segmentation_accuracy", "f_score"):
                ours = float(table[data_set, "ops"][measure])
                if method not in OURS and row["f_score"] and float(row[measure]) > ours:
                    self.assertIn(labels[data_set], paragraph, f"{method}: {row}")

    def test_readme_is_short(self):
        self.assertLessEqual(len(README.read_text().splitlines()), 220)


if __name__ == "__main__" and PROGRAMS == "--fill":
    for page_with_tables in COMPARISONS:
        fill_tables(page_with_tables)
    fill_accuracy(SOURCES / "src/doc/accuracy.md")
elif __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
