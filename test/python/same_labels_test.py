# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module gives the same labels, planes and files as the programs."""

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
class SameAsPrograms(unittest.TestCase):
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
        """Fails unless segment with these arguments finds what the program with these options does."""
        self.run_program(f"pcl_ops_segment room.pcd out.pcd --planes out.json --quiet {options}")
        expected_planes = json.loads((self.folder / "out.json").read_text())["planes"]
        points, viewpoint = self.room.points, self.room.viewpoint
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

    def test_labels_and_planes_by_each_method_preset_and_parameter(self):
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

    def test_bytes_of_labeled_clouds(self):
        (self.folder / "room.las").write_bytes(las(room()[np.isfinite(room()[:, 0])]))
        self.run_program("pcl_ops_segment room.pcd colored.pcd --quiet")
        for cloud, output, options, arguments in (
            ("room.pcd", "out.pcd", "", {}),
            ("room.pcd", "out.ply", "--distances", {}),
            ("colored.pcd", "out.pcd", "--keep-color", {"keep_color": True}),
            ("colored.pcd", "out.ply", "", {}),
            ("room.las", "out.las", "", {}),
            ("room.las", "out.pcd", "", {}),
        ):
            with self.subTest(output, options=options):
                self.run_program(f"pcl_ops_segment {cloud} {output} --quiet {options}")
                of_program = pcl_ops.read(self.folder / output)
                pcl_ops.write(self.folder / f"py_{output}", pcl_ops.read(self.folder / cloud),
                              of_program.labels, distances=of_program.fields.get("distance"),
                              **arguments)
                written = (self.folder / f"py_{output}").read_bytes()
                self.assertTrue(written == (self.folder / output).read_bytes())

    def test_maps_of_planes(self):
        planes = pcl_ops.segment(self.room.points, viewpoint=self.room.viewpoint)[1]
        self.run_program("pcl_ops_segment room.pcd --planes map.geojson --crs EPSG:25832 --quiet")
        pcl_ops.write_planes(self.folder / "py_map.geojson", planes, crs="EPSG:25832")
        of_program, written = (json.loads((self.folder / name).read_text())
                               for name in ("map.geojson", "py_map.geojson"))
        self.assertEqual(written["crs"], of_program["crs"])
        self.assertEqual(len(written["features"]), len(planes))
        for feature, expected in zip(written["features"], of_program["features"]):
            self.assertEqual(feature["geometry"]["type"], expected["geometry"]["type"])
            np.testing.assert_allclose(feature["geometry"]["coordinates"],
                                       expected["geometry"]["coordinates"], atol=1e-5)
            self.assertSameRow(feature["properties"], expected["properties"])

    def test_tables_of_planes(self):
        planes = pcl_ops.segment(self.room.points, viewpoint=self.room.viewpoint)[1]
        self.run_program("pcl_ops_segment room.pcd --planes map.csv --quiet")
        pcl_ops.write_planes(self.folder / "py_map.csv", planes)
        of_program, written = (list(csv.DictReader((self.folder / name).read_text().splitlines()))
                               for name in ("map.csv", "py_map.csv"))
        self.assertEqual(len(written), len(planes))
        for row, expected in zip(written, of_program):
            number = re.compile(r"-?[0-9.]+")
            corners, expected_corners = (np.float64(number.findall(outline.pop("wkt")))
                                         for outline in (row, expected))
            np.testing.assert_allclose(corners, expected_corners, atol=1e-5)
            self.assertSameRow(row, expected)

    def assertSameRow(self, row, expected):
        """Fails unless a row or feature of a plane has the properties that are expected."""
        self.assertEqual(list(row), list(expected))
        for name, value in row.items():
            if name in ("orientation", "kind", "id", "points"):
                self.assertEqual(value, expected[name])
            else:
                # Lengths are in meters, areas in square meters, slopes and aspects in degrees.
                tolerance = 0.01 if name == "aspect" else 1e-4
                self.assertAlmostEqual(float(value), float(expected[name]), delta=tolerance)

    def test_labels_of_points_in_double_precision_and_in_any_order(self):
        points = self.room.points.astype(np.float64)
        points = points[np.isfinite(points).all(axis=1)]
        labels_of_single_precision = pcl_ops.segment(points.astype(np.float32))[0]
        missing_readings = np.zeros((len(points) // 10, 3))
        # Powers of two [m]: so far from zero single precision has no digits for millimeters.
        far = points + (2**19, 2**22, 256)
        for name, cloud in (("near zero", np.round(points, 6)),
                            ("far", far),
                            ("far, with missing readings", np.vstack([missing_readings, far]))):
            with self.subTest(name):
                labels = pcl_ops.segment(cloud)[0]
                for order in (np.random.default_rng(1).permutation(len(cloud)),
                              np.argsort(cloud[:, 0])):
                    labels_in_order = pcl_ops.segment(cloud[order])[0]
                    self.assertGreater(np.mean(labels_in_order == labels[order]), 0.999)
                np.savetxt(self.folder / "far.xyz", cloud, fmt="%.17g")
                self.run_program("pcl_ops_segment far.xyz far.pcd --quiet")
                np.testing.assert_array_equal(labels, pcl_ops.read(self.folder / "far.pcd").labels)
                labels_of_points = labels[-len(points):]
                self.assertGreater(np.mean(labels_of_points == labels_of_single_precision), 0.9)

    def test_metrics(self):
        self.assertSame("")  # writes out.pcd
        of_program = json.loads(self.run_program("pcl_ops_evaluate compare room.pcd out.pcd --json"))
        points = self.room.points
        result = pcl_ops.segment(points)[0]
        by_labels = pcl_ops.evaluate(self.room.labels, result, points)
        self.assertGreater(by_labels["f_score"], 0.2)
        for name, value in by_labels.items():
            self.assertAlmostEqual(of_program[name], value, places=9, msg=name)
        # In the file the label of points on no plane is 0, in cloud.labels it is -1.
        labels_of_file = self.room.fields["label"]
        self.assertEqual(pcl_ops.evaluate(labels_of_file, result, points, none=0), by_labels)
        self.assertNotEqual(pcl_ops.evaluate(labels_of_file, result, points, none=-1), by_labels)


class Parameters(unittest.TestCase):
    def test_of_the_preset_paper_have_its_values_and_give_its_labels(self):
        points = room()
        for method, name, value in (("ops", "strategy", "divide_then_detect"),
                                    ("fspf", "inner_radius", 0.07),
                                    ("kht", "refit_enabled", False)):
            parameters = pcl_ops.parameters(method, "paper")
            self.assertEqual(parameters[name], value)
            self.assertNotEqual(pcl_ops.parameters(method)[name], value)
            by_preset = pcl_ops.segment(points, method, "paper")[0]
            by_parameters = pcl_ops.segment(points, method, **parameters)[0]
            np.testing.assert_array_equal(by_preset, by_parameters)
        self.assertIsNone(pcl_ops.parameters()["distance_threshold"])
