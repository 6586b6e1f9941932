# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The help and the progress of the scripts, and the installation of packages.

python3 common_test.py SOURCES: the project's folder.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(sys.argv[1]) / "scripts"


def bash(command, **environment):
    """Begins a command of bash that has the functions of common.sh."""
    return subprocess.Popen(["bash", "-c", f"source '{SCRIPTS}/common.sh'; {command}"],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env={**os.environ, **environment})


class Help(unittest.TestCase):
    def test_of_every_script_is_what_is_said_at_its_head(self):
        for script in SCRIPTS.iterdir():
            if script.suffix:
                continue
            for option in ("--help", "-h"):
                done = subprocess.run([script, option], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done)
                self.assertTrue(done.stdout.startswith(f"scripts/{script.name}"), done)
                self.assertNotIn("shellcheck", done.stdout)


class Progress(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def progress(self, log):
        (self.folder / "log").write_text(log)
        return bash(f"progress_of '{self.folder}/log'").communicate()[0].strip()

    def test_of_an_installation_is_what_is_fetched_then_unpacked_then_set_up(self):
        head = ("0 upgraded, 3 newly installed, 0 to remove and 0 not upgraded.\n"
                "Need to get 1,050 MB/1,060 MB of archives.\n")
        fetched = "Get:1 http://a b [200 MB]\nGet:2 http://a c [1,000 kB]\n"
        unpacked = "Unpacking b (1) ...\nUnpacking c (1) ...\n"
        self.assertEqual(self.progress(head + fetched),
                         "201 of 1050 MB are fetched for 3 packages")
        self.assertEqual(self.progress(head + fetched + unpacked), "2 of 3 packages are unpacked")
        self.assertEqual(self.progress(head + fetched + unpacked + "Setting up b (1) ...\n"),
                         "1 of 3 packages are set up")

    def test_of_a_build_is_its_last_step(self):
        self.assertEqual(self.progress("[1/37] Building\n[12/37] Building\nnote\n"),
                         "12/37 steps are done")
        self.assertEqual(self.progress("[ 57%] Building\n"), "57% is built")

    def test_of_tests_is_how_many_are_done(self):
        self.assertEqual(self.progress("  Start 3: a\n 12/137 Test  #3: a ... Passed  1 sec\n"),
                         "12/137 tests are done")

    def test_of_anything_else_is_its_last_line(self):
        self.assertEqual(self.progress("first\nlast\n\n"), "last")

    def test_is_said_while_a_command_is_at_work(self):
        for how in ("quietly", "aloud"):
            os.mkfifo(self.folder / how)
            # The command ends once the FIFO is written; until then its last line is its progress.
            script = bash(f"{how} '{self.folder}/log' sh -c "
                          f"'echo \"[1/2] step\"; read line < \"{self.folder}/{how}\"'; echo end",
                          PCL_OPS_SILENCE="0.1")
            lines = iter(script.stdout.readline, "")
            self.assertTrue(any("1/2 steps are done, goes on" in line for line in lines))
            (self.folder / how).write_text("go\n")
            rest, errors = script.communicate()
            self.assertTrue(rest.endswith("end\n"))
            self.assertEqual((script.returncode, errors), (0, ""))

    def test_ends_with_a_command_that_fails(self):
        script = bash(f"quietly '{self.folder}/log' sh -c 'echo broken; exit 3'")
        _, errors = script.communicate()
        self.assertEqual(script.returncode, 1)
        self.assertTrue(errors.startswith("broken\n"))
        script = bash(f"aloud '{self.folder}/log' sh -c 'echo broken; exit 3'")
        self.assertEqual(script.communicate()[0], "broken\n")
        self.assertEqual(script.returncode, 3)


# Writes each call to the file "asked". With --print-uris it prints sizes. An installation itself
# prints an error and ends with the exit code STATUS; with 0 it counts as done.
APT_GET = """#!/bin/sh
echo "$*" >> "$FOLDER/asked"
case "$*" in
  *--print-uris*) echo '0 upgraded, 3 newly installed, 0 to remove and 0 not upgraded.'
                  echo 'Need to get 12.5 MB of archives.' ;;
  *install*) echo 'E: the disk is full' >&2; exit "$STATUS" ;;
esac
"""


class Installation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in {"apt-get": APT_GET, "sudo": '#!/bin/sh\nexec "$@"\n',
                           "dpkg-query": "#!/bin/sh\nexit 1\n"}.items():
            (self.folder / name).write_text(text)
            (self.folder / name).chmod(0o755)

    def install(self, status):
        """The exit code, output and errors of install_packages, where apt-get ends with a status."""
        script = bash(f"root='{self.folder}'; install_packages a b", FOLDER=str(self.folder),
                      STATUS=status, PATH=f"{self.folder}:{os.environ['PATH']}")
        output, errors = script.communicate()
        return script.returncode, output, errors

    def test_is_asked_for_its_size_before_anything_is_installed(self):
        status, output, errors = self.install("0")
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual(output, "==> installing a b\n==>   packages: 3\n==>   to fetch: 12.5 MB\n")
        # The calls are: update, install --print-uris, install.
        asked = [line.split() for line in (self.folder / "asked").read_text().splitlines()]
        self.assertEqual(["install" in words and "--print-uris" not in words for words in asked],
                         [False, False, True])

    def test_shows_the_errors_of_an_installation_that_fails(self):
        status, _, errors = self.install("100")
        self.assertEqual(status, 1)
        self.assertTrue(errors.startswith("E: the disk is full\n"), errors)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
