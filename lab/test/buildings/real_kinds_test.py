# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""How often the kinds of planes of real clouds are right, by area.

python3 real_kinds_test.py PROGRAMS: the folder of pcl_ops_segment. The clouds are below
PCL_OPS_DATA_DIR; without them this is skipped. kinds_of_real_planes.tsv says what is true.
"""

import json
import os
import pathlib
import subprocess
import sys
import unittest

PROGRAMS = pathlib.Path(sys.argv[1])
DATA = pathlib.Path(os.environ.get("PCL_OPS_DATA_DIR", "no data"))
NAMED = pathlib.Path(__file__).with_name("kinds_of_real_planes.tsv")
RIGHT = {"ground": {"floor", "ramp", "other"}}


def named_planes():
    """Rows of the table by cloud: place, area and what the plane is."""
    clouds = {}
    for line in NAMED.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            cloud, place, area, kind = line.split("\t")
            clouds.setdefault(cloud, []).append(
                ([float(value) for value in place.split(",")], float(area), kind))
    return clouds


def planes_of(cloud):
    done = subprocess.run([PROGRAMS / "pcl_ops_segment", DATA / cloud, "--planes", "-", "--quiet"],
                          stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)["planes"]


def plane_at(place, planes):
    """The nearest of the planes that pass a place and reach it."""
    best, best_height = None, float("inf")
    for plane in planes:
        off = [a - b for a, b in zip(place, plane["centroid"])]
        height = abs(sum(a * b for a, b in zip(plane["normal"], off)))
        reaches = sum(value * value for value in off) <= 0.25 * plane["extent"]["length"] ** 2
        if reaches and height < min(best_height, max(3.0 * plane["rms"], 0.05)):
            best, best_height = plane, height
    return best


def right_share(rows, planes):
    right = 0.0
    for place, area, kind in rows:
        plane = plane_at(place, planes)
        if plane and plane["kind"] in RIGHT.get(kind, {kind}):
            right += area
    return right / sum(area for _, area, _ in rows)


class RealKinds(unittest.TestCase):
    def test_nine_tenths_by_area_are_right(self):
        shares = []
        for cloud, rows in named_planes().items():
            if not (DATA / cloud).exists():
                self.skipTest(f"no {DATA / cloud}")
            shares.append(right_share(rows, planes_of(cloud)))
            print(f"| {cloud} | {len(rows)} planes | {100 * shares[-1]:.1f} % |")
        self.assertEqual(len(shares), 10)
        print(f"| mean | | {100 * sum(shares) / len(shares):.1f} % |")
        self.assertGreater(sum(shares) / len(shares), 0.9)
        self.assertGreater(min(shares), 0.7)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
