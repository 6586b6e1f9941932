# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pages say can be done in Python is done."""

import contextlib
import io
import os
import pathlib
import re
import tempfile
import unittest

import numpy as np
import pcl_ops
from scene import room

source = pathlib.Path(__file__).parents[2]


def code_of(page):
    return re.findall(r"^```python\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)


class Pages(unittest.TestCase):
    def test_code_runs(self):
        pages = [source / "README.md", *sorted((source / "src/doc").glob("*.md"))]
        self.assertTrue(code_of(source / "src/doc/python.md"))
        self.addCleanup(os.chdir, os.getcwd())
        for page in pages:
            with tempfile.TemporaryDirectory() as folder, self.subTest(page.name):
                os.chdir(folder)
                np.save("room.npy", room())
                names = {"pcl_ops": pcl_ops, "points": room()}
                for code in code_of(page):
                    with contextlib.redirect_stdout(io.StringIO()):
                        exec(compile(code, str(page), "exec"), names)

    def test_parameters_of_the_page_are_those_there_are(self):
        page = (source / "src/doc/python.md").read_text()
        rows = re.findall(r"^\| `(ops|fspf|kht|all)` \| (.*) \|$", page, re.MULTILINE)
        said = {method: set(re.findall(r"`(\w+)`", names)) for method, names in rows}
        for method in ("ops", "fspf", "kht"):
            self.assertEqual(said[method] | said["all"], set(pcl_ops.parameters(method)))


if __name__ == "__main__":
    unittest.main()
