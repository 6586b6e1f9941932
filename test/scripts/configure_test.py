# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""A second run of CMake leaves generated sources as they are: else all would be compiled again.

python3 configure_test.py SOURCES CMAKE COMPILER: the project's folder, the programs that build it.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCES, CMAKE, COMPILER = sys.argv[1:4]
COMPILED_EXTENSIONS = {".h", ".hpp", ".cpp", ".cxx", ".c"}


def configure(folder):
    # Both kinds of generated sources: stand-ins for headers of PCL, and unity files.
    subprocess.run([CMAKE, "-S", SOURCES, "-B", folder, "-DPCL_OPS_WITHOUT_PCL=ON", "-DBUILD_TESTING=OFF",
                    "-DPCL_OPS_BUILD_PYTHON=OFF", "-DPCL_OPS_BUILD_SURFACE=OFF", "-DCMAKE_UNITY_BUILD=ON",
                    f"-DCMAKE_CXX_COMPILER={COMPILER}"],
                   check=True, stdout=subprocess.DEVNULL)


def times_of_compiled_files(folder):
    return {file.relative_to(folder): file.stat().st_mtime_ns
            for file in folder.rglob("*") if file.suffix in COMPILED_EXTENSIONS}


class Configuring(unittest.TestCase):
    def test_a_second_run_leaves_generated_sources_untouched(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            configure(folder)
            before = times_of_compiled_files(folder)
            configure(folder)
            self.assertIn("point_types.h", {file.name for file in before})
            self.assertEqual(times_of_compiled_files(folder), before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
