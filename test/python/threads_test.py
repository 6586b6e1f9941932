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


def ticks_during(call):
    """How often another thread had its turn while a call was at work."""
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(time.perf_counter())

    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        pool.submit(tick)
        begin = time.perf_counter()
        call()
        end = time.perf_counter()
        done.set()
    return sum(begin < tick < end for tick in ticks)


class Threads(unittest.TestCase):
    def test_others_work_during_segment_and_evaluate(self):
        labels = pcl_ops.segment(large(np.float32))[0]
        for kind in (np.float32, np.float64):
            points = large(kind)
            for call in (*(lambda method=method: pcl_ops.segment(points, method)
                           for method in ("ops", "fspf", "kht")),
                         lambda: pcl_ops.evaluate(labels, labels, points)):
                # With the interpreter held there are none, but for one as it begins and ends.
                self.assertGreater(max(ticks_during(call) for _ in range(3)), 5)

    def test_calls_at_once_find_the_same(self):
        points = room()
        expected = pcl_ops.segment(points)[0]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for labels, _ in pool.map(lambda _: pcl_ops.segment(points), range(20)):
                np.testing.assert_array_equal(labels, expected)

    def test_end_of_python_during_a_call_is_quiet(self):
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

    def test_interruption_is_not_lost(self):
        points = large(np.float32)
        with self.assertRaises(KeyboardInterrupt):
            threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGINT)).start()
            pcl_ops.segment(points)
            time.sleep(10)
