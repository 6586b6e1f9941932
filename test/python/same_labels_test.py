# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The module finds what the C++ classes find: pcl_ops_segment runs them on a file."""

import csv
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import numpy as np
import pcl_ops
from scene import las, room


@unittest.skipUnless(shutil.which("pcl_ops_segment"), "the programs are not built")
class SameLabels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.run_program("pcl_ops_simulate room.pcd --width 320 --height 240 --quiet")
        cls.room = pcl_ops.read(cls.folder / "room.pcd")

    @classmethod
    def run_program(cls, command):
        return subprocess.run(command.split(), cwd=cls.folder, check=True,
                              stdout=subprocess.PIPE).stdout

    def assertSame(self, options, **arguments):
        self.run_program(f"pcl_ops_segment room.pcd out.pcd --planes out.json --quiet {options}")
        expected_planes = json.loads((self.folder / "out.json").read_text())["planes"]
        points, viewpoint = self.room[:2]
        labels, planes = pcl_ops.segment(points, viewpoint=viewpoint, **arguments)
        self.assertGreater(len(planes), 2)
        np.testing.assert_array_equal(labels, pcl_ops.read(self.folder / "out.pcd").labels)
        self.assertEqual(len(planes), len(expected_planes))
        for plane, expected in zip(planes, expected_planes):
            self.assertEqual(plane.orientation, expected["orientation"])
            self.assertEqual(len(plane.inliers), expected["points"])
            expected.update(expected["extent"])
            for name in ("coefficients", "normal", "centroid", "rms", "hull", "area", "length",
                         "width"):
                np.testing.assert_allclose(
                    getattr(plane, name), expected[name], rtol=1e-5, atol=1e-5)

    def test_by_each_method_preset_and_parameter(self):
        presets = [(f"--method {method} --preset {preset}", {"method": method, "preset": preset})
                   for method in ("ops", "fspf", "kht") for preset in ("default", "paper")]
        for options, arguments in (
            *presets,
            ("--sampling-rate 0.01 --min-inliers 40", {"sampling_rate": 0.01, "min_samples": 40}),
            ("--method kht --threshold 0.03", {"method": "kht", "distance_threshold": 0.03}),
            ("--preset paper --seed 7", {"preset": "paper", "seed": 7}),
            ("--up 0,1,0", {"up": (0, 1, 0)}),
            ("--up camera", {"up": pcl_ops.camera_up()}),
            ("", {"threads": 3}),
            ("", {"threads": 0}),
        ):
            with self.subTest(options):
                self.assertSame(options, **arguments)

    def test_are_written_as_the_program_does(self):
        (self.folder / "room.las").write_bytes(las(room()[np.isfinite(room()[:, 0])]))
        self.run_program("pcl_ops_segment room.pcd colored.pcd --quiet")
        for name, output, options, given in (
            ("room.pcd", "out.pcd", "", {}),
            ("room.pcd", "out.ply", "--distances", {}),
            ("colored.pcd", "out.pcd", "--keep-color", {"keep_color": True}),
            ("colored.pcd", "out.ply", "", {}),
            ("room.las", "out.las", "", {}),
            ("room.las", "out.pcd", "", {}),
        ):
            with self.subTest(output, options=options):
                self.run_program(f"pcl_ops_segment {name} {output} --quiet {options}")
                said = pcl_ops.read(self.folder / output)
                pcl_ops.write(self.folder / f"py_{output}", pcl_ops.read(self.folder / name),
                              said.labels, distances=said.fields.get("distance"), **given)
                written = (self.folder / f"py_{output}").read_bytes()
                self.assertTrue(written == (self.folder / output).read_bytes())

    def test_lists_of_planes_are_those_of_the_program(self):
        planes = pcl_ops.segment(self.room.points, viewpoint=self.room.viewpoint)[1]
        self.run_program("pcl_ops_segment room.pcd --planes map.geojson --crs EPSG:25832 --quiet")
        self.run_program("pcl_ops_segment room.pcd --planes map.csv --quiet")
        pcl_ops.write_planes(self.folder / "py_map.geojson", planes, crs="EPSG:25832")
        pcl_ops.write_planes(self.folder / "py_map.csv", planes)
        said, written = (json.loads((self.folder / name).read_text())
                         for name in ("map.geojson", "py_map.geojson"))
        self.assertEqual(written["crs"], said["crs"])
        self.assertEqual(len(written["features"]), len(planes))
        for feature, expected in zip(written["features"], said["features"]):
            self.assertEqual(feature["geometry"]["type"], expected["geometry"]["type"])
            np.testing.assert_allclose(feature["geometry"]["coordinates"],
                                       expected["geometry"]["coordinates"], atol=1e-5)
            self.assertSameRow(feature["properties"], expected["properties"])
        tables = [list(csv.DictReader((self.folder / name).read_text().splitlines()))
                  for name in ("map.csv", "py_map.csv")]
        self.assertEqual(len(tables[1]), len(planes))
        for row, expected in zip(*tables):
            number = re.compile(r"-?[0-9.]+")
            corners, of_program = (number.findall(one.pop("wkt")) for one in (row, expected))
            np.testing.assert_allclose(np.float64(corners), np.float64(of_program), atol=1e-5)
            self.assertSameRow(row, expected)

    def assertSameRow(self, row, expected):
        self.assertEqual(list(row), list(expected))
        for name, value in row.items():
            if name in ("orientation", "kind", "id", "points"):
                self.assertEqual(value, expected[name])
            else:
                # An aspect of 359.9999 is one of 0.
                tolerance = 0.01 if name == "aspect" else 1e-4
                self.assertAlmostEqual(float(value), float(expected[name]), delta=tolerance)

    def test_of_double_precision_in_any_order(self):
        points = self.room.points.astype(np.float64)
        points = points[np.isfinite(points).all(axis=1)]
        in_single = pcl_ops.segment(points.astype(np.float32))[0]
        zeros = np.zeros((len(points) // 10, 3))
        # After a move by powers of two, single precision has no digits for millimeters.
        for name, cloud in (("near zero", np.round(points, 6)),
                            ("far", points + (2**19, 2**22, 256)),
                            ("far, with missing readings",
                             np.vstack([zeros, points + (2**19, 2**22, 256)]))):
            with self.subTest(name):
                labels = pcl_ops.segment(cloud)[0]
                for order in (np.random.default_rng(1).permutation(len(cloud)),
                              np.argsort(cloud[:, 0])):
                    in_order = pcl_ops.segment(cloud[order])[0]
                    self.assertGreater(np.mean(in_order == labels[order]), 0.999)
                np.savetxt(self.folder / "far.xyz", cloud, fmt="%.17g")
                self.run_program("pcl_ops_segment far.xyz far.pcd --quiet")
                np.testing.assert_array_equal(labels, pcl_ops.read(self.folder / "far.pcd").labels)
                self.assertGreater(np.mean(labels[-len(points):] == in_single), 0.9)

    def test_the_programs_metrics(self):
        self.assertSame("")
        said = json.loads(self.run_program("pcl_ops_evaluate compare room.pcd out.pcd --json"))
        points = self.room.points
        result = pcl_ops.segment(points)[0]
        by_labels = pcl_ops.evaluate(self.room.labels, result, points)
        self.assertGreater(by_labels["f_score"], 0.2)
        for name, value in by_labels.items():
            self.assertAlmostEqual(said[name], value, places=9, msg=name)
        label = self.room.fields["label"]
        self.assertEqual(pcl_ops.evaluate(label, result, points, none=0), by_labels)
        self.assertNotEqual(pcl_ops.evaluate(label, result, points, none=-1), by_labels)


class Parameters(unittest.TestCase):
    def test_of_a_preset_are_and_give_its_planes(self):
        points = room()
        for method, name, value in (("ops", "strategy", "divide_then_detect"),
                                    ("fspf", "inner_radius", 0.07),
                                    ("kht", "refit_enabled", False)):
            parameters = pcl_ops.parameters(method, "paper")
            self.assertEqual(parameters[name], value)
            self.assertNotEqual(pcl_ops.parameters(method)[name], value)
            paper = pcl_ops.segment(points, method, "paper")[0]
            np.testing.assert_array_equal(paper, pcl_ops.segment(points, method, **parameters)[0])
        self.assertIsNone(pcl_ops.parameters()["distance_threshold"])
