# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What pip installs and takes away again."""

import importlib.util
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

import pcl_ops

source = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(source / "src/python"))
import build_backend  # noqa: E402


def files_of(folder):
    return {path for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc"}


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)

    def run_python(self, *arguments):
        python = self.folder / "venv/bin/python"
        return subprocess.run([python, "-I", *arguments], check=True, capture_output=True, text=True,
                              cwd=self.folder).stdout

    @unittest.skipUnless(importlib.util.find_spec("ensurepip"), "venv is not installed")
    def test_is_installed_and_leaves_nothing_behind(self):
        package = pathlib.Path(pcl_ops.__file__).parent
        wheel = self.folder / build_backend.write_wheel(package, self.folder)
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "venv"],
                       cwd=self.folder, check=True)
        before = files_of(self.folder / "venv")
        self.run_python("-m", "pip", "install", "--no-index", "--no-compile", wheel)
        new = {path.name for path in files_of(self.folder / "venv") - before}
        self.assertLessEqual({"__init__.py", "_segmentation.pyi", "py.typed", "LICENSE"}, new)
        said = self.run_python("-c", "import pcl_ops; print(pcl_ops.__version__, pcl_ops.__file__)")
        self.assertRegex(said, rf"^{build_backend.version()} {self.folder}/venv/")
        self.assertIn("Requires: numpy\n", self.run_python("-m", "pip", "show", "pcl_ops"))
        self.run_python("-m", "pip", "uninstall", "--yes", "pcl_ops")
        self.assertEqual(files_of(self.folder / "venv"), before)

    @unittest.skipUnless((source / ".git").exists(), "no git repository")
    def test_archive_of_sources_has_what_a_build_needs(self):
        name = build_backend.build_sdist(self.folder)
        with tarfile.open(self.folder / name) as archive:
            files = set(archive.getnames())
        needed = ("PKG-INFO", "pyproject.toml", "CMakeLists.txt", "src/python/module.cpp")
        self.assertEqual({f"{name[:-len('.tar.gz')]}/{file}" for file in needed} - files, set())


if __name__ == "__main__":
    unittest.main()
