# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check refuses includes that point up, to a layer above that of the file, and unknown options.

python3 check_test.py SOURCES: the project's folder.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv[1])


class Includes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ("include", "src", "apps", "lab", "scripts"):
            shutil.copytree(SOURCES / name, self.root / name, ignore=shutil.ignore_patterns("doc"))

    def check(self, file="", include=""):
        """What scripts/check says where a file has one more include."""
        if file:
            with open(self.root / file, "a", encoding="utf-8") as source:
                source.write(f"#include {include}\n")
        done = subprocess.run([self.root / "scripts/check", "--includes"], stderr=subprocess.PIPE,
                              stdout=subprocess.DEVNULL, text=True, check=False)
        return done.stderr if done.returncode else "good"

    def test_of_the_project_are_good(self):
        self.assertEqual(self.check(), "good")

    def test_of_buildings_are_refused_in_the_core(self):
        for header in ("<pcl_ops/buildings/plane_kinds.h>", '"buildings/stories.h"',
                       '"../buildings/stories.h"'):
            with self.subTest(header):
                self.setUp()  # a copy without the include of the header before
                self.assertIn("the core must not include buildings",
                              self.check("src/plane_filter.cpp", header))

    def test_of_buildings_are_refused_in_public_headers_of_the_core(self):
        self.assertIn("include/pcl_ops/plane_filter.h",
                      self.check("include/pcl_ops/plane_filter.h", '"buildings/plane_kinds.h"'))

    def test_of_what_the_core_hides_are_refused_in_buildings(self):
        for header in ('"geometry/inliers.h"', "<pcl_ops/detail/detection.h>"):
            with self.subTest(header):
                self.setUp()  # a copy without the include of the header before
                self.assertIn("buildings must do with the public headers",
                              self.check("src/buildings/floor_plan.cpp", header))

    def test_of_a_later_layer_are_refused(self):
        self.assertIn("geometry must not include what is above it",
                      self.check("src/geometry/plane.cpp", '"ops/constants.h"'))


class Options(unittest.TestCase):
    def test_that_do_not_exist_are_refused_before_any_check(self):
        for options in (["--quik"], ["--quick", "src/plane_filter.cpp"]):
            done = subprocess.run([SOURCES / "scripts/check", *options], capture_output=True,
                                  text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertTrue(done.stderr.startswith(f"check: {options[0]}: "))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
