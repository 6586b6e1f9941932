# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""While planes are looked for, Python goes on."""

import concurrent.futures
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np
import pcl_ops
from scene import room


def large(kind):
    """Points enough for some tenths of a second."""
    points = np.tile(room(), (20, 1)).astype(kind)
    return points + np.random.default_rng(1).normal(0, 0.002, points.shape).astype(kind)


class Threads(unittest.TestCase):
    def ticks_during(self, call):
        """How often another thread had its turn while a call was at work."""
        ticks = []
        done = threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(time.perf_counter())

        with concurrent.futures.ThreadPoolExecutor() as pool:
            pool.submit(tick)
            begin = time.perf_counter()
            try:
                call()
            finally:
                done.set()
            end = time.perf_counter()
        return sum(begin < tick < end for tick in ticks)

    def assertLetsOthersWork(self, call):
        # With the interpreter held there are none, but for one as it begins and ends.
        self.assertGreater(max(self.ticks_during(call) for _ in range(3)), 5)

    def test_others_work_during_segment(self):
        for kind in (np.float32, np.float64):
            points = large(kind)
            for method in ("ops", "fspf", "kht"):
                self.assertLetsOthersWork(lambda: pcl_ops.segment(points, method))

    def test_others_work_during_evaluate(self):
        points = large(np.float32)
        labels = pcl_ops.segment(points)[0]
        self.assertLetsOthersWork(lambda: pcl_ops.evaluate(labels, labels, points))

    def test_calls_at_once_find_the_same(self):
        points = room()
        expected = pcl_ops.segment(points)[0]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for labels, _ in pool.map(lambda _: pcl_ops.segment(points), range(20)):
                np.testing.assert_array_equal(labels, expected)


class End(unittest.TestCase):
    def test_of_python_during_a_call_is_quiet(self):
        script = """
import threading, time
import pcl_ops
from scene import room
points = room()
def work():
    while True:
        pcl_ops.segment(points.astype("f8") + 0.1, "fspf")
        pcl_ops.evaluate(labels, labels, points)
labels = pcl_ops.segment(points)[0]
for _ in range(2):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.2)
"""
        here = os.path.dirname(os.path.abspath(__file__))
        for _ in range(5):
            run = subprocess.run([sys.executable, "-B", "-c", script], cwd=here, capture_output=True)
            self.assertEqual((run.returncode, run.stderr), (0, b""))


class Interruption(unittest.TestCase):
    def test_is_not_lost(self):
        points = large(np.float32)
        with self.assertRaises(KeyboardInterrupt):
            threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGINT)).start()
            pcl_ops.segment(points)
            time.sleep(10)


if __name__ == "__main__":
    unittest.main()
