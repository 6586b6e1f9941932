# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example, run with the module as it is installed."""

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

script = pathlib.Path(__file__).parents[2] / "apps/examples/07_python/plane_picture.py"


class Installed(unittest.TestCase):
    def test_module_is_that_of_the_prefix(self):
        self.assertTrue(pcl_ops.__file__.startswith(os.environ["PYTHONPATH"]), pcl_ops.__file__)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class Example(unittest.TestCase):
    def picture_of(self, *cloud):
        """What the example prints, and its picture."""
        import matplotlib.pyplot as plt

        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "picture.png")
            command = [sys.executable, "-B", script, file, *cloud]
            said = subprocess.check_output(command, text=True, env={**os.environ, "MPLCONFIGDIR": folder})
            return said, plt.imread(file)

    def test_draws_its_room(self):
        said, picture = self.picture_of()
        self.assertRegex(said, r"horizontal, (19|20)\.\d\d m2.*(\n.*){3}\n4 planes\n$")
        colors = np.unique(picture.reshape(-1, picture.shape[2]), axis=0)
        self.assertGreater(len(colors), 100)

    def test_draws_an_array_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            array, text = pathlib.Path(folder, "room.npy"), pathlib.Path(folder, "room.xyz")
            np.save(array, room())
            np.savetxt(text, room())
            for file in (array, text):
                self.assertIn("\n3 planes\n", self.picture_of(file)[0])


if __name__ == "__main__":
    unittest.main()
