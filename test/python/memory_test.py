# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""An array whose rows lie in order is read where it is."""

import os
import subprocess
import sys
import unittest

import numpy as np
import pcl_ops
from scene import surface

number = 1_000_000
peak_file = "/proc/self/clear_refs"


def status(key):
    """A line of the kernel's on this process [bytes]."""
    with open("/proc/self/status") as lines:
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(key))


def bytes_per_point(order):
    """How far memory grows over what it was, at most, for each point of a floor."""
    floor = surface((0, 0, 0), (4, 0, 0), (0, 3, 0), number)
    points = np.array(floor, np.float32, order=order)
    del floor
    pcl_ops.segment(points[:1000])
    with open(peak_file, "w") as peak:
        peak.write("5")
    before = status("VmRSS")
    pcl_ops.segment(points)
    return (status("VmHWM") - before) / number


@unittest.skipUnless(os.access(peak_file, os.W_OK), "the kernel does not tell peaks anew")
class Memory(unittest.TestCase):
    def measured(self, order):
        # Each in a process of its own: memory that was freed is not seen to grow.
        return float(subprocess.check_output([sys.executable, "-B", __file__, order]))

    def test_rows_in_order_are_not_copied(self):
        in_order = self.measured("C")
        # The library's own 12 of coordinates, 4 of indices and what it works with, 8 of
        # labels and inliers; 12 more would be a copy.
        self.assertLess(in_order, 36)
        self.assertGreater(self.measured("F"), in_order + 6)


if __name__ == "__main__":
    if len(sys.argv) == 2:
        print(bytes_per_point(sys.argv[1]))
    else:
        unittest.main()
