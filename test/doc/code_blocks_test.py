# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The C++ blocks of README.md and of the pages of src/doc compile as they are written.

python3 code_blocks_test.py SOURCES COMPILER FLAGS: the project's folder, the compiler, and a file
with the options it needs for the library's headers.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCES, COMPILER, FLAGS = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
PAGES = [SOURCES / "README.md", *sorted((SOURCES / "src/doc").glob("*.md"))]

# What blocks without a main function may use: a cloud and a detector as in the first example,
# and planes. Each block includes its other headers itself.
GIVEN_HEADER = "#include <pcl_ops/oriented_point_sampling.h>\n"
GIVEN = """
void
example (const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud,
         pcl_ops::OrientedPointSampling<pcl::PointXYZ>& ops,
         std::vector<pcl_ops::PlaneSegment>& planes,
         const pcl_ops::PlaneSegment& plane,
         const std::vector<pcl_ops::PlaneSegment>& previous,
         const std::vector<pcl_ops::PlaneSegment>& current,
         const Eigen::Isometry3d& pose)
{
  (void) cloud, (void) ops, (void) planes, (void) plane;
  (void) previous, (void) current, (void) pose;
  {
"""


def blocks_of(page):
    return re.findall(r"^```cpp\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)


def is_program(block):
    return re.search(r"^main \(", block, re.MULTILINE) is not None


def body_of(block):
    """A block without a main function as the body of a function."""
    lines = block.splitlines(keepends=True)
    headers = [line for line in lines if line.startswith("#")]
    return "".join([*headers, GIVEN, *(line for line in lines if line not in headers), "}\n}\n"])


class Blocks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Precompiled, as compiling this header would take most of the time of a block.
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.given = pathlib.Path(cls.folder.name, "given.h")
        cls.given.write_text(GIVEN_HEADER)
        done = cls.compile("-x", "c++-header", cls.given, "-o", f"{cls.given}.gch")
        assert done.returncode == 0, done.stdout

    @staticmethod
    def compile(*options):
        return subprocess.run([COMPILER, "-std=c++17", f"@{FLAGS}", *options],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)

    def assertCompiles(self, block):
        source = pathlib.Path(self.folder.name, "block.cpp")
        source.write_text(block if is_program(block) else body_of(block))
        given = [] if is_program(block) else ["-include", self.given]
        done = self.compile("-fsyntax-only", *given, source)
        self.assertEqual(done.returncode, 0, f"{block}\n{done.stdout}")

    def test_compile_as_written(self):
        blocks = [(page, block) for page in PAGES for block in blocks_of(page)]
        self.assertGreater(len(blocks), 10)
        for page, block in blocks:
            with self.subTest(page.name, block=block.splitlines()[0]):
                self.assertCompiles(block)

    def test_a_block_without_its_header_does_not_compile(self):
        outlines = next(block for block in blocks_of(SOURCES / "src/doc/library.md")
                        if block.startswith("#include <pcl_ops/plane_extent.h>\n"))
        self.assertCompiles(outlines)
        with self.assertRaises(AssertionError):
            self.assertCompiles(outlines.replace("#include <pcl_ops/plane_extent.h>", ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
