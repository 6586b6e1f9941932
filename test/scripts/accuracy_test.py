# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/accuracy computes, prints and stores.

python3 accuracy_test.py SOURCES: the project's folder.
"""

import contextlib
import csv
import importlib.machinery
import importlib.util
import io
import math
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

SCRIPT = pathlib.Path(sys.argv[1]) / "scripts" / "accuracy"
sys.dont_write_bytecode = True
LOADER = importlib.machinery.SourceFileLoader("accuracy", str(SCRIPT))
accuracy = importlib.util.module_from_spec(importlib.util.spec_from_loader("accuracy", LOADER))
LOADER.exec_module(accuracy)


def with_truth(f_score, **others):
    """The values of a set with truth."""
    return {"clouds": 4, "f_score": f_score, "f_score_75": 0.5, "on_planes_share": 0.9,
            "thick_factor_share": 0.0, "thick_length_share": 0.0, **others}


def without_truth(on_planes, on_thick):
    """The values of a set without truth, by the shares of points on planes and on thick ones."""
    return {**with_truth(math.nan), "f_score_75": math.nan, "on_planes_share": on_planes,
            "thick_length_share": on_thick}


def agreeing(values, *agreements):
    """The values of a set, with the agreement of each of its clouds after a move."""
    mean = sum(agreements) / len(agreements)
    return {**values, "agreements": {"moved": agreements}, "moved": mean}


def printed(call, *arguments):
    """The lines that a call prints."""
    with contextlib.redirect_stdout(io.StringIO()) as output:
        call(*arguments)
    return output.getvalue().splitlines()


class Scores(unittest.TestCase):
    def test_a_set_with_truth_is_judged_by_its_f(self):
        self.assertEqual(accuracy.score(with_truth(0.6)), 0.6)

    def test_a_set_without_truth_is_judged_by_points_on_thin_planes_less_those_on_thick(self):
        # 90 of 100 points are on planes, 20 of these on thick ones: 70 less 20.
        self.assertAlmostEqual(accuracy.score(without_truth(0.9, 0.2)), 0.5)

    def test_sets_with_truth_are_three_quarters_of_the_number(self):
        sets = {"a": with_truth(0.4), "b": with_truth(0.8), "wild": without_truth(0.2, 0.0)}
        self.assertAlmostEqual(accuracy.number(sets), 0.75 * 0.6 + 0.25 * 0.2)

    def test_the_number_is_the_mean_where_all_sets_have_truth_or_none_has(self):
        self.assertAlmostEqual(accuracy.number({"a": with_truth(0.4)}), 0.4)
        self.assertAlmostEqual(accuracy.number({"wild": without_truth(0.2, 0.0)}), 0.2)


class Differences(unittest.TestCase):
    def test_a_change_within_twice_the_scatter_is_noise(self):
        before = with_truth(0.6, scatter=0.02)
        for change, expected in ((0.039, False), (-0.039, False), (0.041, True), (-0.041, True)):
            self.assertEqual(accuracy.differs(with_truth(0.6 + change), before), expected)

    def test_four_stored_digits_are_no_change_of_a_set_without_scatter(self):
        before = with_truth(0.6667, scatter=0.0)
        self.assertFalse(accuracy.differs(with_truth(2 / 3), before))
        self.assertTrue(accuracy.differs(with_truth(0.668), before))


class Lines(unittest.TestCase):
    def test_a_line_has_both_scores_their_difference_and_a_mark_if_they_differ(self):
        before = with_truth(0.6, scatter=0.02)
        self.assertEqual(accuracy.line("rooms", with_truth(0.7), before).split()[:7],
                         ["rooms", "4", "0.700", "0.600", "+0.100", "*", "0.020"])
        self.assertNotIn("*", accuracy.line("rooms", with_truth(0.61), before))

    def test_a_set_that_is_not_stored_has_no_score_before(self):
        self.assertEqual(accuracy.line("rooms", with_truth(0.7), None).split()[:5],
                         ["rooms", "4", "0.700", "-", "-"])

    def test_sets_are_compared_where_both_sides_have_them(self):
        now = {"rooms": with_truth(0.7), "tables": with_truth(0.1), "roofs": "absent"}
        before = {"rooms": with_truth(0.6, scatter=0.02), "cad": with_truth(0.9, scatter=0.0)}
        lines = printed(accuracy.compare, now, before, {})
        self.assertIn("roofs               absent", lines)
        self.assertEqual(lines[-4], "all 2 sets: 0.4000")
        self.assertEqual(lines[-3], "the 1 sets of both: 0.7000, before 0.6000 (+0.1000); "
                                    "1 differ by more than twice their scatter")

    def test_agreements_are_at_the_end_beside_those_before(self):
        now = {"rooms": agreeing(with_truth(0.7), 0.5), "wild-kitti": agreeing(with_truth(0.7), 1)}
        before = accuracy.overall({"rooms": agreeing(with_truth(0.7), 0.25)})
        lines = printed(accuracy.compare, now, {}, before)
        for line, start in ((-4, "all clouds: moved 0.750/0.500; turned -/-;"),
                             (-3, "all clouds, before: moved 0.250/0.250;"),
                             (-2, "real clouds: moved 1.000/1.000;"),
                             (-1, "real clouds, before: moved -/-;")):
            self.assertTrue(lines[line].startswith("agreement, " + start), lines[line])


class Agreements(unittest.TestCase):
    def test_the_median_and_the_worst_tenth_are_those_over_all_clouds(self):
        # Of twenty clouds two, a tenth, agree by less than 0.15.
        agreements = [number / 20 for number in range(20, 0, -1)]
        rows = accuracy.overall({"rooms": agreeing(with_truth(0.7), *agreements)})
        self.assertAlmostEqual(rows["all-median"]["moved"], 0.525)
        self.assertAlmostEqual(rows["all-tenth"]["moved"], 0.15)

    def test_a_row_of_steadiness_has_the_number_and_median_and_tenth_of_each_change(self):
        sets = {"real-a": agreeing(with_truth(0.6), 0.9, 1.0, 1.0),
                "wild-b": agreeing(without_truth(0.9, 0.2), 0.5)}
        row = accuracy.steadiness_of("loop", sets)
        self.assertEqual((row["detector"], row["clouds"], row["number"]), ("loop", 8, "0.575"))
        self.assertEqual((row["moved_median"], row["moved_tenth"]), ("0.950", "0.500"))
        self.assertEqual(row["turned_median"], "nan")

    def test_a_program_without_changes_has_none(self):
        self.assertEqual(accuracy.agreements_of([{"f_score": "1"}])["moved"], [])
        rows = [{"agreement_moved": text} for text in ("0.5", "nan", "1")]
        self.assertEqual(accuracy.agreements_of(rows)["moved"], [0.5, 1.0])

    def test_f_is_the_mean_of_the_positions_and_scatter_their_deviation(self):
        positions = [{**with_truth(f_score), "detection_ms": 1.0} for f_score in (0.5, 0.6, 0.7)]
        values = accuracy.over_positions([agreeing(positions[0], 0.9), *positions[1:]])
        self.assertAlmostEqual(values["f_score"], 0.6)
        self.assertAlmostEqual(values["scatter"], 0.1)
        self.assertEqual(values["moved"], 0.9)
        self.assertEqual(accuracy.over_positions([positions[0], "absent"]), "absent")


class Stored(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_what_is_stored_is_read_again(self):
        values = {"rooms": agreeing(with_truth(0.625, scatter=0.125), 1.0, 1.0),
                  "wild-kitti": agreeing(without_truth(0.75, 0.25), 0.5, 0.5)}
        with mock.patch.object(accuracy, "STORED", self.folder / "accuracy.csv"), \
                mock.patch.object(accuracy, "measure_all", lambda *_: values):
            printed(accuracy.store, self.folder, list(values), "ops")
            stored = accuracy.read_stored()
            over_clouds = accuracy.read_stored_overall()
        self.assertEqual(list(stored), list(values))
        for column in ("clouds", "f_score", "scatter", "moved"):
            self.assertEqual(stored["rooms"][column], values["rooms"][column])
        self.assertEqual(over_clouds["all-median"]["moved"], 0.75)
        self.assertEqual(over_clouds["real-tenth"]["moved"], 0.5)
        self.assertTrue(math.isnan(over_clouds["all-median"]["turned"]))
        self.assertEqual(accuracy.score(stored["wild-kitti"]), 0.25)

    def test_steadiness_of_one_detector_leaves_the_rows_of_others(self):
        file = self.folder / "steadiness.csv"
        values = {"real-a": agreeing(with_truth(0.5), 1.0)}
        with mock.patch.object(accuracy, "STEADINESS", file), \
                mock.patch.object(accuracy, "measure_all", lambda *_: values):
            for detector in ("ops", "loop"):
                printed(accuracy.store_steadiness, self.folder, detector)
        lines = file.read_text().splitlines()
        self.assertEqual([line.split(",")[0] for line in lines], ["detector", "loop", "ops"])

    def test_steadiness_is_not_stored_where_a_set_is_missing(self):
        file = self.folder / "steadiness.csv"
        values = {"real-a": agreeing(with_truth(0.5), 1.0), "wild-b": "absent"}
        with mock.patch.object(accuracy, "STEADINESS", file), \
                mock.patch.object(accuracy, "measure_all", lambda *_: values):
            with self.assertRaisesRegex(SystemExit, "wild-b absent"):
                printed(accuracy.store_steadiness, self.folder, "ops")
        self.assertFalse(file.exists())

    def test_the_file_of_the_project_has_only_sets_that_are_measured(self):
        with open(accuracy.STORED, newline="", encoding="utf-8") as file:
            stored = {row["set"] for row in csv.DictReader(file)}
        over_clouds = set(accuracy.overall({}))
        self.assertLessEqual(stored - over_clouds, set(accuracy.SETS))

    def test_a_file_without_agreements_is_read(self):
        file = self.folder / "accuracy.csv"
        file.write_text("set,clouds,f_score\nrooms,6,0.5\n")
        with mock.patch.object(accuracy, "STORED", file):
            self.assertEqual(accuracy.read_stored()["rooms"]["f_score"], 0.5)
            self.assertTrue(math.isnan(accuracy.read_stored()["rooms"]["moved"]))
            self.assertEqual(accuracy.read_stored_overall(), {})

    def test_real_clouds_are_left_out_where_they_are_absent(self):
        (self.folder / "roof_1.pcd").touch()
        with mock.patch.object(accuracy, "DATA", self.folder):
            self.assertEqual(accuracy.data("real", "roof*@0.2", "room*@0.03"),
                             [f"real:{self.folder}/roof*@0.2"])


class Arguments(unittest.TestCase):
    def refusal(self, *arguments):
        with mock.patch.object(sys, "argv", ["accuracy", *arguments]), \
                contextlib.redirect_stderr(io.StringIO()) as output, \
                self.assertRaises(SystemExit) as end:
            accuracy.arguments()
        self.assertEqual(end.exception.code, 2)
        return output.getvalue().strip().splitlines()[-1]

    def test_sets_that_are_none_are_refused(self):
        self.assertIn("--sets lunar: is no set; give a part of one of rooms, ",
                      self.refusal("--sets", "lunar"))
        self.assertIn("--sets (: is no expression; ", self.refusal("--sets", "("))

    def test_quick_values_are_not_stored_among_the_others(self):
        self.assertIn("give --stored FILE", self.refusal("store", "--quick"))

    def test_a_folder_without_the_program_is_refused(self):
        self.assertIn("has no pcl_ops_evaluate", self.refusal("--bin", "/"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
