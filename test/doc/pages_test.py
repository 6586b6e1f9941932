# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What README.md and the pages of src/doc say can be done, is done.

python3 pages_test.py SOURCES PROGRAMS: the project's folder, and that of its programs.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCES, PROGRAMS = pathlib.Path(sys.argv[1]), sys.argv[2]
README = SOURCES / "README.md"
PAGES = [README, *sorted((SOURCES / "src/doc").glob("*.md"))]
ROOM = " --seed 1 --width 160 --height 120"
# Commands that need no display, no data of others and no minutes.
RUN = ("pcl_ops_simulate ", "pcl_ops_segment ", "cat room.pcd | ", "pcl_ops_tiles ",
       "pcl_ops_evaluate compare ", "pcl_ops_evaluate planes ", "pcl_ops_evaluate track ",
       "printf ")


def code_of(page, language):
    """The lines of a page that stand in fences of this language."""
    return "".join(re.findall(rf"^```{language}\n(.*?)^```", page.read_text(),
                              re.MULTILINE | re.DOTALL)).splitlines()


def smaller(command):
    """A command with options that keep a simulation short."""
    sized = ("--points", "--scene street")
    if not command.startswith("pcl_ops_simulate ") or any(s in command for s in sized):
        return command
    if "--scene walk" in command:
        return command + " --frames 5 --width 80 --height 60"
    return command + (" --points 5000" if "--scene" in command else ROOM[9:])


def sections_of(page):
    """What links name headings by: small letters, no punctuation, hyphens for blanks."""
    return [re.sub(r"[^a-z0-9 -]", "", heading.lower()).replace(" ", "-")
            for heading in re.findall(r"^#+ (.*)", page.read_text(), re.MULTILINE)]


class Pages(unittest.TestCase):
    def run_in(self, folder, command):
        done = subprocess.run(
            ["sh", "-c", command], cwd=folder, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, check=False,
            env={**os.environ, "PATH": PROGRAMS + os.pathsep + os.environ["PATH"]})
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}")

    def test_commands_run(self):
        for page in PAGES:
            commands = [smaller(c) for c in code_of(page, "sh") if c.startswith(RUN)]
            if not commands:
                continue
            # The clouds the pages speak of: room.pcd and a folder of scans.
            with self.subTest(page.name), tempfile.TemporaryDirectory() as folder:
                os.mkdir(os.path.join(folder, "scans"))
                for cloud in ("room", "scans/first", "scans/second"):
                    self.run_in(folder, f"pcl_ops_simulate {cloud}.pcd{ROOM}")
                for command in commands:
                    self.run_in(folder, command)

    def test_links_lead_to_files_and_sections(self):
        for page in PAGES:
            for name, section in re.findall(r"\]\(([^)#:]+)(?:#([^)]+))?\)",
                                            page.read_text()):
                target = page.parent / name
                self.assertTrue(target.exists(), f"{page.name} links to {name}")
                self.assertTrue(not section or section in sections_of(target),
                                f"{page.name} links to {name}#{section}")

    def test_main_page_and_readme_link_to_all(self):
        starts = [README, SOURCES / "src/doc/main.md"]
        for start in starts:
            for page in PAGES:
                if page not in starts:
                    self.assertIn(page.name + ")", start.read_text(), start.name)

    def test_readme_has_the_lines_of_the_first_example(self):
        example = (SOURCES / "apps/examples/01_minimal/minimal.cpp").read_text()
        lines = code_of(README, "cpp")
        self.assertGreaterEqual(len(lines), 4)
        for line in lines:
            # The example asks whether the call succeeded, the README says what it gives.
            self.assertIn(line.partition(";")[0], example)

    def test_readme_is_short(self):
        self.assertLessEqual(len(README.read_text().splitlines()), 220)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
