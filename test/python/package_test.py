# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What editors, type checkers and pages are told is what there is."""

import ast
import contextlib
import inspect
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
methods = ("ops", "fspf", "kht")
names = [name for name in pcl_ops.__all__ if not name.startswith("_")]


def keywords(function):
    signature = inspect.signature(function).parameters.values()
    return {one.name for one in signature if one.kind == one.KEYWORD_ONLY}


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(pcl_ops.__file__).parent
        cls.texts = [file.read_text() for file in folder.glob("*.pyi")]
        cls.stubs = {node.name: node for text in cls.texts for node in ast.parse(text).body
                     if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        cls.is_typed = (folder / "py.typed").exists()

    def test_all_has_stubs_and_documentation(self):
        self.assertTrue(self.is_typed)
        for name in names:
            self.assertIn(name, self.stubs)
            self.assertTrue(inspect.getdoc(getattr(pcl_ops, name)), name)
        for name in dir(pcl_ops.Plane):
            self.assertTrue(name.startswith("_") or getattr(pcl_ops.Plane, name).__doc__, name)

    def test_stubs_name_types_that_there_are(self):
        for text in self.texts:
            exec(text, {"__name__": "pcl_ops.stub", "__package__": "pcl_ops"})

    def test_stubs_and_help_have_each_parameter_by_name(self):
        of_segment = {name for method in methods for name in pcl_ops.parameters(method)}
        self.assertEqual(keywords(pcl_ops.segment), {"viewpoint"} | of_segment)
        for name in names:
            if isinstance(self.stubs[name], ast.FunctionDef):
                given = {arg.arg for arg in self.stubs[name].args.kwonlyargs}
                self.assertEqual(given, keywords(getattr(pcl_ops, name)), name)
                self.assertIsNone(self.stubs[name].args.kwarg)
        kinds = {arg.arg: ast.unparse(arg.annotation)
                 for arg in self.stubs["segment"].args.kwonlyargs}
        self.assertEqual(kinds["threads"], "int")
        self.assertEqual(kinds["up"], "Vector")
        self.assertEqual(kinds["distance_threshold"], "Optional[float]")
        self.assertEqual(kinds["sampling"], "Literal['points', 'surfels']")

    def test_version_is_that_of_the_project(self):
        project = (source / "CMakeLists.txt").read_text()
        self.assertEqual(pcl_ops.__version__, re.search(r"VERSION (\d+\.\d+\.\d+)", project)[1])


class Pages(unittest.TestCase):
    def test_code_runs(self):
        self.addCleanup(os.chdir, os.getcwd())
        pages = [source / "README.md", *sorted((source / "src/doc").glob("*.md"))]
        blocks = {page: re.findall(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S)
                  for page in pages}
        self.assertTrue(blocks[source / "src/doc/python.md"])
        for page, code in blocks.items():
            with tempfile.TemporaryDirectory() as folder, self.subTest(page.name):
                os.chdir(folder)
                np.save("room.npy", room())
                np.savetxt("room.xyz", room())
                known = {"pcl_ops": pcl_ops, "points": room()}
                with contextlib.redirect_stdout(io.StringIO()):
                    exec(compile("".join(code), str(page), "exec"), known)


if __name__ == "__main__":
    unittest.main()
