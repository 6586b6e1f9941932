# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The module finds what the C++ classes find: pcl_ops_segment runs them on a file."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import numpy as np
import pcl_ops

types = {"F": "f", "U": "u", "I": "i"}


def read_pcd(file):
    """The points of a binary PCD, as a structured array, and where they were seen from."""
    header, data = file.read_bytes().split(b"DATA binary\n", 1)
    lines = dict(line.split(" ", 1) for line in header.decode().splitlines() if " " in line)
    fields = zip(lines["FIELDS"].split(), lines["TYPE"].split(), lines["SIZE"].split())
    layout = [(name, types[kind] + size) for name, kind, size in fields]
    viewpoint = [float(number) for number in lines["VIEWPOINT"].split()[:3]]
    return np.frombuffer(data, layout, int(lines["POINTS"])), viewpoint


def xyz(cloud):
    return np.stack([cloud["x"], cloud["y"], cloud["z"]], axis=1)


@unittest.skipUnless(shutil.which("pcl_ops_segment"), "the programs are not built")
class SameLabels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.run_program("pcl_ops_simulate", "room.pcd", "--width", "320", "--height", "240")
        room, cls.viewpoint = read_pcd(cls.folder / "room.pcd")
        cls.points = xyz(room)
        cls.true_labels = room["label"].astype(np.int64) - 1

    @classmethod
    def run_program(cls, *command):
        subprocess.run([*command, "--quiet"], cwd=cls.folder, check=True)

    def by_program(self, *options):
        """Labels and planes of pcl_ops_segment; 0 stands for no plane there."""
        self.run_program("pcl_ops_segment", "room.pcd", "out.pcd", "--planes", "out.json", *options)
        labels = read_pcd(self.folder / "out.pcd")[0]["label"].astype(np.int64) - 1
        return labels, json.loads((self.folder / "out.json").read_text())["planes"]

    def assertSame(self, options, **arguments):
        expected_labels, expected_planes = self.by_program(*options)
        labels, planes = pcl_ops.segment(self.points, viewpoint=self.viewpoint, **arguments)
        self.assertGreater(len(planes), 2)
        np.testing.assert_array_equal(labels, expected_labels)
        self.assertEqual(len(planes), len(expected_planes))
        for plane, expected in zip(planes, expected_planes):
            self.assertEqual(plane.orientation, expected["orientation"])
            self.assertEqual(len(plane.inliers), expected["points"])
            near = dict(rtol=1e-5, atol=1e-5)
            np.testing.assert_allclose(plane.coefficients, expected["coefficients"], **near)
            np.testing.assert_allclose(plane.centroid, expected["centroid"], **near)
            np.testing.assert_allclose(plane.rms, expected["rms"], **near)
            np.testing.assert_allclose(plane.area, expected["area"], **near)
            np.testing.assert_allclose(plane.hull, expected["hull"], **near)

    def test_by_each_method_and_preset(self):
        for method in ("ops", "fspf", "kht"):
            for preset in ("default", "paper"):
                with self.subTest(method=method, preset=preset):
                    options = ("--method", method, "--preset", preset)
                    self.assertSame(options, method=method, preset=preset)

    def test_with_parameters(self):
        self.assertSame(("--sampling-rate", "0.01", "--min-inliers", "40"),
                        sampling_rate=0.01, min_inliers=40)
        self.assertSame(("--method", "kht", "--threshold", "0.03"),
                        method="kht", distance_threshold=0.03)
        self.assertSame(("--preset", "paper", "--seed", "7"), preset="paper", seed=7)
        self.assertSame(("--up", "0,1,0"), up=(0, 1, 0))

    def test_by_any_number_of_threads(self):
        self.assertSame((), threads=3)
        self.assertSame((), threads=0)

    def test_without_merging_there_are_more_planes(self):
        merged = pcl_ops.segment(self.points, "fspf")[1]
        apart = pcl_ops.segment(self.points, "fspf", merging_enabled=False)[1]
        self.assertGreater(len(apart), 2 * len(merged))

    def test_the_programs_metrics(self):
        self.by_program()
        said = subprocess.run(
            ["pcl_ops_evaluate", "compare", "room.pcd", "out.pcd", "--json"],
            cwd=self.folder, check=True, capture_output=True).stdout
        result = pcl_ops.segment(self.points)[0]
        metrics = pcl_ops.evaluate(self.true_labels, result, self.points)
        self.assertGreater(metrics["f_score"], 0.2)
        for name, value in metrics.items():
            self.assertAlmostEqual(json.loads(said)[name], value, places=9, msg=name)


class Parameters(unittest.TestCase):
    def test_of_a_preset_give_its_planes(self):
        draws = np.random.default_rng(1)
        points = draws.uniform(0, 2, (20000, 3)).astype(np.float32)
        points[:15000, 2] = 0.5
        for method in ("ops", "fspf", "kht"):
            paper = pcl_ops.segment(points, method, "paper")[0]
            given = pcl_ops.segment(points, method, **pcl_ops.parameters(method, "paper"))[0]
            np.testing.assert_array_equal(paper, given)

    def test_are_those_of_the_presets(self):
        self.assertIsNone(pcl_ops.parameters()["distance_threshold"])
        paper = pcl_ops.parameters("ops", "paper")
        self.assertEqual(paper["distance_threshold"], 0.05)
        self.assertEqual(paper["sampling"], "points")
        self.assertEqual(paper["strategy"], "divide_then_detect")
        self.assertEqual(pcl_ops.parameters("kht", "paper")["phi_num"], 80)
        self.assertFalse(pcl_ops.parameters("kht", "paper")["refit_enabled"])
        self.assertEqual(pcl_ops.parameters("fspf", "paper")["inner_radius"], 0.07)


if __name__ == "__main__":
    unittest.main()
