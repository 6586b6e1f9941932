# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What editors and type checkers are told is what there is."""

import ast
import inspect
import pathlib
import re
import unittest

import pcl_ops

folder = pathlib.Path(pcl_ops.__file__).parent


def public(names):
    return {name for name in names if not name.startswith("_")}


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        body = ast.parse((folder / "__init__.pyi").read_text()).body
        cls.functions = {node.name: node for node in body if isinstance(node, ast.FunctionDef)}
        cls.classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}

    def test_stubs_name_all(self):
        named = public(pcl_ops.__all__)
        self.assertEqual(named, public(self.functions) | public(self.classes))
        self.assertTrue((folder / "py.typed").exists())

    def test_stubs_have_the_arguments(self):
        for name, node in self.functions.items():
            signature = inspect.signature(getattr(pcl_ops, name)).parameters
            stub = {arg.arg for arg in node.args.args + node.args.kwonlyargs}
            real = {key for key, arg in signature.items() if arg.kind != arg.VAR_KEYWORD}
            self.assertLessEqual(real, stub, name)

    def test_stubs_have_what_a_plane_says(self):
        stub = {node.name for node in self.classes["Plane"].body}
        self.assertEqual(stub, public(dir(pcl_ops.Plane)))

    def test_all_is_documented(self):
        for name in public(pcl_ops.__all__):
            self.assertTrue(inspect.getdoc(getattr(pcl_ops, name)), name)
        for name in public(dir(pcl_ops.Plane)):
            self.assertTrue(getattr(pcl_ops.Plane, name).__doc__, name)

    def test_version_is_a_number(self):
        self.assertRegex(pcl_ops.__version__, r"^\d+\.\d+\.\d+$")

    def test_parameters_named_in_docstrings_exist(self):
        said = " ".join(pcl_ops.segment.__doc__.split())
        for name in re.findall(r"\b(distance_threshold|up|angle_tolerance|seed|threads)\b", said):
            for method in ("ops", "fspf", "kht"):
                self.assertIn(name, pcl_ops.parameters(method))


if __name__ == "__main__":
    unittest.main()
