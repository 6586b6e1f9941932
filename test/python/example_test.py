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
script = examples / "plane_picture.py"


class Installed(unittest.TestCase):
    def test_module_is_that_of_the_prefix(self):
        self.assertTrue(pcl_ops.__file__.startswith(os.environ["PYTHONPATH"]), pcl_ops.__file__)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class Example(unittest.TestCase):
    def test_draws_its_room_and_arrays_of_files(self):
        import matplotlib.pyplot as plt

        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            np.save(folder / "room.npy", room())
            np.savetxt(folder / "room.xyz", room())
            for cloud, said in (
                ([], r"horizontal, (19|20)\.\d\d m2.*(\n.*){3}\n4 planes\n$"),
                (["room.npy"], "\n3 planes\n"),
                (["room.xyz"], "\n3 planes\n"),
            ):
                run = subprocess.run([sys.executable, "-B", script, "picture.png", *cloud],
                                     check=True, capture_output=True, text=True, cwd=folder,
                                     env={**os.environ, "MPLCONFIGDIR": name})
                self.assertRegex(run.stdout, said)
                picture = plt.imread(folder / "picture.png")
                colors = np.unique(picture.reshape(-1, picture.shape[2]), axis=0)
                self.assertGreater(len(colors), 100)

    def test_finds_planes_with_normals_towards_the_sensor_of_the_file(self):
        with tempfile.TemporaryDirectory() as name:
            for height, normal in ((1.5, r"1\."), (-9.0, r"-1\.")):
                cloud = pcl_ops.Cloud(room(), np.array([2.0, 1.5, height]), {})
                pcl_ops.write(pathlib.Path(name) / "room.pcd", cloud)
                run = subprocess.run([sys.executable, "-B", script, "picture.png", "room.pcd"],
                                     check=True, capture_output=True, text=True, cwd=name,
                                     env={**os.environ, "MPLCONFIGDIR": name})
                self.assertRegex(run.stdout, rf"horizontal, .* {normal} *\]\n")

    def test_writes_no_picture_that_is_called_as_an_option(self):
        for example in (script, examples / "noise_picture.py", examples / "plan_picture.py"):
            with tempfile.TemporaryDirectory() as name:
                run = subprocess.run([sys.executable, "-B", example, "--help", "room.npy"],
                                     capture_output=True, text=True, cwd=name,
                                     env={**os.environ, "MPLCONFIGDIR": name})
                self.assertIn("Usage: ", run.stderr)
                self.assertFalse(list(pathlib.Path(name).glob("*.png")))

    def test_draws_plans_over_points(self):
        import matplotlib.pyplot as plt

        with tempfile.TemporaryDirectory() as name:
            pcl_ops.write(pathlib.Path(name) / "room.pcd", room())
            run = subprocess.run(
                [sys.executable, "-B", examples / "plan_picture.py", "plan.png", "room.pcd"],
                check=True, capture_output=True, text=True, cwd=name,
                env={**os.environ, "MPLCONFIGDIR": name})
            self.assertEqual(run.stdout, "room.pcd: 2 walls, 0 rooms\n")
            picture = plt.imread(pathlib.Path(name) / "plan.png")[..., :3]
            self.assertGreater((picture.max(axis=2) < 0.1).mean(), 0.001, "walls are black")

    def test_draws_the_noise_of_clouds(self):
        import matplotlib.pyplot as plt

        with tempfile.TemporaryDirectory() as name:
            np.save(pathlib.Path(name) / "room.npy", room())
            np.save(pathlib.Path(name) / "few.npy", room()[:20])
            run = subprocess.run(
                [sys.executable, "-B", examples / "noise_picture.py", "noise.png", "room.npy",
                 "few.npy"], check=True, capture_output=True, text=True, cwd=name,
                env={**os.environ, "MPLCONFIGDIR": name})
            self.assertRegex(run.stdout, r"^room: \d\.\d to \d\.\d mm\nfew: not known\n$")
            picture = plt.imread(pathlib.Path(name) / "noise.png")
            self.assertGreater(picture.shape[1], picture.shape[0])

