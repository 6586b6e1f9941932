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
# Kinds that are right for a true kind, where it is not that kind alone.
RIGHT_KINDS = {"ground": {"floor", "ramp", "other"}}


def named_planes():
    """Rows of the table by cloud: a position on the plane, its area and its true kind."""
    clouds = {}
    for line in NAMED.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            cloud, position, area, kind = line.split("\t")
            clouds.setdefault(cloud, []).append(
                ([float(value) for value in position.split(",")], float(area), kind))
    return clouds


def planes_of(cloud):
    done = subprocess.run([PROGRAMS / "pcl_ops_segment", DATA / cloud, "--planes", "-", "--quiet"],
                          stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)["planes"]


def plane_at(position, planes):
    """The plane with the least distance to a position, of those that are near it (3 rms, at
    least 5 cm) and half of whose length reaches from the centroid to it; None if there is none."""
    nearest, least_distance = None, float("inf")
    for plane in planes:
        from_centroid = [a - b for a, b in zip(position, plane["centroid"])]
        distance = abs(sum(a * b for a, b in zip(plane["normal"], from_centroid)))
        half_length = 0.5 * plane["extent"]["length"]
        reaches = sum(value * value for value in from_centroid) <= half_length ** 2
        if reaches and distance < min(least_distance, max(3.0 * plane["rms"], 0.05)):
            nearest, least_distance = plane, distance
    return nearest


def right_share(rows, planes):
    """Share of the area of a cloud's named planes that has a right kind."""
    right_area = 0.0
    for position, area, kind in rows:
        plane = plane_at(position, planes)
        if plane and plane["kind"] in RIGHT_KINDS.get(kind, {kind}):
            right_area += area
    return right_area / sum(area for _, area, _ in rows)


class RealKinds(unittest.TestCase):
    def test_nine_tenths_by_area_are_right_and_seven_tenths_of_each_cloud(self):
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
