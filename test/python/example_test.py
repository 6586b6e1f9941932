# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples, run with the installed module."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import pcl_ops
from scene import room

examples = pathlib.Path(__file__).parents[2] / "apps/examples"


def run_example(folder, example, *arguments, check=True):
    """Runs an example in a folder and returns its output and errors.

    check: whether the example has to succeed
    """
    return subprocess.run([sys.executable, "-B", examples / example, *arguments],
                          check=check, capture_output=True, text=True, cwd=folder,
                          env={**os.environ, "MPLCONFIGDIR": str(folder)})


class Installed(unittest.TestCase):
    def test_module_is_imported_from_PYTHONPATH(self):
        self.assertTrue(pcl_ops.__file__.startswith(os.environ["PYTHONPATH"]), pcl_ops.__file__)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class Pictures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_of_planes_show_the_room_of_the_example_or_those_of_files(self):
        import matplotlib.pyplot as plt

        np.save(self.folder / "room.npy", room())
        np.savetxt(self.folder / "room.xyz", room())
        for files, expected in (
            # A floor of 5 m x 4 m, two walls and a table top.
            ([], r"horizontal, (19|20)\.\d\d m2.*(\n.*){3}\n4 planes\n$"),
            (["room.npy"], "\n3 planes\n"),
            (["room.xyz"], "\n3 planes\n"),
        ):
            with self.subTest(files):
                run = run_example(self.folder, "plane_picture.py", "picture.png", *files)
                self.assertRegex(run.stdout, expected)
                picture = plt.imread(self.folder / "picture.png")
                saturation = np.ptp(picture[..., :3], axis=2)  # 0: gray
                self.assertGreater(np.count_nonzero(saturation > 0.3), 100)

    def test_of_planes_come_with_normals_towards_the_sensor_of_the_file(self):
        for height_of_sensor, z_of_normal in ((1.5, r"1\."), (-9.0, r"-1\.")):
            cloud = pcl_ops.Cloud(room(), np.array([2.0, 1.5, height_of_sensor]), {})
            pcl_ops.write(self.folder / "room.pcd", cloud)
            run = run_example(self.folder, "plane_picture.py", "picture.png", "room.pcd")
            self.assertRegex(run.stdout, rf"horizontal, .* {z_of_normal} *\]\n")

    def test_have_a_usage_that_is_told_if_an_option_stands_for_the_file(self):
        # matplotlib would write --help.png.
        for example in ("plane_picture.py", "noise_picture.py", "plan_picture.py"):
            run = run_example(self.folder, example, "--help", "room.npy", check=False)
            self.assertIn("Usage: ", run.stderr)
            self.assertFalse(list(self.folder.glob("*.png")))

    def test_of_floor_plans_have_black_walls(self):
        import matplotlib.pyplot as plt

        pcl_ops.write(self.folder / "room.pcd", room())
        run = run_example(self.folder, "plan_picture.py", "plan.png", "room.pcd")
        self.assertEqual(run.stdout, "room.pcd: 2 walls, 0 rooms\n")
        colors = plt.imread(self.folder / "plan.png")[..., :3]
        is_black = colors.max(axis=2) < 0.1
        self.assertGreater(is_black.mean(), 0.001)

    def test_of_the_noise_of_two_clouds_are_wide(self):
        import matplotlib.pyplot as plt

        np.save(self.folder / "room.npy", room())
        np.save(self.folder / "few.npy", room()[:20])  # too few points for a noise
        run = run_example(self.folder, "noise_picture.py", "noise.png", "room.npy", "few.npy")
        self.assertRegex(run.stdout, r"^room: \d\.\d to \d\.\d mm\nfew: not known\n$")
        height, width, _ = plt.imread(self.folder / "noise.png").shape
        self.assertGreater(width, height)
