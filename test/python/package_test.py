# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The stubs, the version, the code of the pages and the wheel for pip fit the module."""

import ast
import contextlib
import importlib.util
import inspect
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
import venv
import zipfile

import numpy as np
import pcl_ops
from scene import las, room

source = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(source / "src/python"))
import build_backend  # noqa: E402

package = pathlib.Path(pcl_ops.__file__).parent
names = [name for name in pcl_ops.__all__ if not name.startswith("_")]


def keywords(function):
    """The names of the keyword-only parameters of a function."""
    signature = inspect.signature(function).parameters.values()
    return {one.name for one in signature if one.kind == one.KEYWORD_ONLY}


class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.texts = [file.read_text() for file in package.glob("*.pyi")]
        cls.stubs = {}  # the syntax tree of each function and class, by name
        for text in cls.texts:
            for node in ast.parse(text).body:
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                    cls.stubs[node.name] = node

    def test_are_there_with_documentation_for_all_names(self):
        self.assertTrue((package / "py.typed").exists())
        members_in_stub = set()
        for node in self.stubs["Plane"].body:
            # A property is a variable with an annotation in the stub; methods have a name.
            is_variable = isinstance(node, ast.AnnAssign)
            members_in_stub.add(
                ast.unparse(node.target) if is_variable else getattr(node, "name", ""))
        for name in names:
            self.assertIn(name, self.stubs)
            self.assertTrue(inspect.getdoc(getattr(pcl_ops, name)), name)
        for name in dir(pcl_ops.Plane):
            if not name.startswith("_"):
                self.assertTrue(getattr(pcl_ops.Plane, name).__doc__, name)
                self.assertIn(name, members_in_stub)

    def test_name_types_that_exist(self):
        for text in self.texts:
            # Fails if a type of an annotation is not imported.
            exec(text, {"__name__": "pcl_ops.stub", "__package__": "pcl_ops"})

    def test_have_the_keyword_parameters_of_each_function_with_their_types(self):
        methods = ("ops", "fspf", "kht")
        of_segment = {name for method in methods for name in pcl_ops.parameters(method)}
        self.assertEqual(keywords(pcl_ops.segment), {"viewpoint", "pieces", "piece_gap"} | of_segment)
        for name in names:
            if isinstance(self.stubs[name], ast.FunctionDef):
                given = {arg.arg for arg in self.stubs[name].args.kwonlyargs}
                self.assertEqual(given, keywords(getattr(pcl_ops, name)), name)
                self.assertIsNone(self.stubs[name].args.kwarg)
        types = {}  # by function and parameter
        for function in ("segment", "filter_planes"):
            types[function] = {arg.arg: ast.unparse(arg.annotation)
                               for arg in self.stubs[function].args.kwonlyargs}
        for function, parameter, expected in (
            ("segment", "threads", "int"),
            ("segment", "up", "Union[Vector, Literal['auto', 'camera']]"),
            ("segment", "distance_threshold", "Optional[float]"),
            ("segment", "sampling", "Literal['points', 'surfels', 'neighborhoods', 'automatic']"),
            ("segment", "merging_enabled", "bool"),
            ("filter_planes", "up", "Optional[Up]"),
            ("filter_planes", "orientation", "Optional[Literal['horizontal', 'vertical', 'other']]"),
        ):
            self.assertEqual(types[function][parameter], expected, (function, parameter))


class Version(unittest.TestCase):
    def test_is_that_of_the_project(self):
        project = (source / "CMakeLists.txt").read_text()
        version = re.search(r"project\(pcl_ops\s+VERSION (\S+)", project)[1]
        self.assertEqual(pcl_ops.__version__, version)
        for file, pattern in (("package.xml", r"<version>(.*)</version>"),
                              ("CITATION.cff", r"(?m)^version: (.*)$"),
                              ("src/doc/Doxyfile", r"(?m)^PROJECT_NUMBER *= (.*)$")):
            text = (source / file).read_text()
            self.assertEqual(re.search(pattern, text)[1], version, file)


class Pages(unittest.TestCase):
    def test_have_python_blocks_that_run_one_after_the_other(self):
        self.addCleanup(os.chdir, os.getcwd())
        pages = [source / "README.md", *sorted((source / "src/doc").glob("*.md"))]
        blocks_of = {page: re.findall(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S)
                     for page in pages}
        self.assertTrue(blocks_of[source / "src/doc/python.md"])
        for page, blocks in blocks_of.items():
            with tempfile.TemporaryDirectory() as folder, self.subTest(page.name):
                os.chdir(folder)
                np.save("room.npy", room())
                np.savetxt("room.xyz", room())
                pcl_ops.write("room.pcd", room())
                pathlib.Path("roofs.las").write_bytes(las(room()[np.isfinite(room()[:, 0])]))
                if importlib.util.find_spec("open3d") is None:
                    blocks = [block for block in blocks if "import open3d" not in block]
                code = "".join(blocks)
                variables = {"pcl_ops": pcl_ops, "points": room()}
                with contextlib.redirect_stdout(io.StringIO()):
                    exec(compile(code, str(page), "exec"), variables)
                if "planes.geojson" in code:
                    features = json.loads(pathlib.Path("planes.geojson").read_text())["features"]
                    self.assertEqual(len(features), len(variables["planes"]))
                if "largest" in variables:  # the floor, with 12,000 of the points of room()
                    self.assertAlmostEqual(len(variables["largest"].points), 12000, delta=50)


class Wheel(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def installed_files(self):
        return {path for path in (self.folder / "venv").rglob("*")
                if path.is_file() and path.suffix != ".pyc"}

    def run_python(self, *arguments):
        return subprocess.check_output([self.folder / "venv/bin/python", "-I", *arguments],
                                       text=True, cwd=self.folder)

    @unittest.skipUnless(importlib.util.find_spec("ensurepip"), "venv is not installed")
    def test_is_installed_by_pip_and_uninstalled_without_remains(self):
        version = build_backend.version()
        wheel = self.folder / build_backend.write_wheel(package, self.folder)
        venv.create(self.folder / "venv", system_site_packages=True, with_pip=True)
        before = self.installed_files()
        self.run_python("-m", "pip", "install", "--no-index", "--no-compile", wheel)
        new = {path.name for path in self.installed_files() - before}
        self.assertLessEqual({"__init__.py", "_segmentation.pyi", "py.typed", "LICENSE"}, new)
        printed = self.run_python(
            "-c", "import pcl_ops; print(pcl_ops.__version__, pcl_ops.__file__)")
        self.assertRegex(printed, rf"^{version} {self.folder}/venv/")
        self.assertRegex(self.run_python("-m", "pip", "show", "pcl_ops"),
                         rf"Version: {version}\n(.*\n)*Requires: numpy\n")
        self.run_python("-m", "pip", "uninstall", "--yes", "pcl_ops")
        self.assertEqual(self.installed_files(), before)

    def test_has_the_metadata_that_the_build_backend_prepares(self):
        metadata = self.folder / build_backend.prepare_metadata_for_build_wheel(self.folder)
        wheel = self.folder / build_backend.write_wheel(package, self.folder)
        with zipfile.ZipFile(wheel) as archive:
            # RECORD lists the files of the wheel: the build backend cannot prepare it.
            in_wheel = {name: archive.read(name) for name in archive.namelist()
                        if name.startswith(metadata.name) and not name.endswith("RECORD")}
        prepared = {f"{metadata.name}/{path.name}": path.read_bytes()
                    for path in metadata.iterdir()}
        self.assertEqual(prepared, in_wheel)
        self.assertEqual({path.name for path in metadata.iterdir()},
                         {"METADATA", "WHEEL", "LICENSE"})


class SourceArchive(unittest.TestCase):
    @unittest.skipUnless((source / ".git").exists(), "no git repository")
    def test_has_what_a_build_needs(self):
        with tempfile.TemporaryDirectory() as folder:
            name = build_backend.build_sdist(pathlib.Path(folder))
            with tarfile.open(pathlib.Path(folder) / name) as archive:
                files = set(archive.getnames())
        top_folder = name[:-len(".tar.gz")]
        needed = ("PKG-INFO", "pyproject.toml", "CMakeLists.txt", "src/python/module.cpp")
        self.assertEqual({f"{top_folder}/{file}" for file in needed} - files, set())
