# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages for a browser."""

import base64
import json
import os
import pathlib
import re
import tempfile
import unittest

import numpy as np
import pcl_ops
from scene import room

viewpoint = np.array([3.5, 0.3, 1.5])
points = room()
labels, planes = pcl_ops.segment(points, viewpoint=viewpoint)


def part_of(page, name):
    """The text of the script element of this id."""
    return re.search(rf'id="{name}">(.*?)</script>', page, re.DOTALL)[1]


class Page(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.path = pathlib.Path(temporary.name, "room.html")

    def page(self, *arguments, **options):
        pcl_ops.write_html(self.path, *arguments, viewpoint=viewpoint, **options)
        return self.path.read_text(encoding="utf-8")

    def groups(self, page):
        """The number of points and the positions of the shown ones of each group of a page."""
        numbers = np.frombuffer(base64.b64decode(part_of(page, "places")), "<u2").reshape(-1, 3)
        for group in json.loads(part_of(page, "groups")):
            steps, numbers = numbers[:group["shown"]], numbers[group["shown"]:]
            yield group["all"], np.asarray(group["origin"]) + steps * group["step"]
        self.assertEqual(len(numbers), 0)

    def test_has_all_points_by_planes_far_from_zero_too(self):
        for shift in (0.0, 5e6):
            moved = points.astype(float) + shift
            found = pcl_ops.segment(moved, viewpoint=viewpoint + shift)
            groups = list(self.groups(self.page(moved, *found)))
            self.assertEqual(len(groups), len(found[1]) + 1)
            finite = np.isfinite(moved).all(axis=1)
            for i, (number, positions) in enumerate(groups):
                inside = moved[finite & (found[0] == (i if i < len(found[1]) else -1))]
                self.assertEqual((number, len(positions)), (len(inside), len(inside)))
                for axis in range(3):
                    np.testing.assert_allclose(np.sort(positions[:, axis]), np.sort(inside[:, axis]),
                                               rtol=0, atol=1e-4)

    def test_describes_planes_and_where_they_meet(self):
        description = json.loads(part_of(self.page(points, labels, planes), "description"))
        self.assertEqual(description["title"], "room.html")
        self.assertFalse(description["backs"])
        for plane, shown in zip(planes, description["planes"]):
            self.assertEqual((shown["orientation"], shown["area"], shown["rms"]),
                             (plane.orientation, plane.area, plane.rms))
            np.testing.assert_array_equal(shown["hull"], plane.hull)
        self.assertEqual([round(one["slope"]) for one in description["planes"]], [0, 90, 90])
        self.assertEqual(len({one["color"] for one in description["planes"]}), 3)
        self.assertEqual(len(description["edges"]), len(pcl_ops.find_plane_edges(planes)[0]))
        self.assertGreater(np.dot(description["view"], viewpoint - (2, 1.5, 1)), 0)

    def test_of_many_points_shows_some_of_each_plane(self):
        groups = list(self.groups(self.page(points, labels, planes, max_points=1000, title="<b>")))
        self.assertLessEqual(sum(len(positions) for _, positions in groups), 1000)
        self.assertTrue(all(len(positions) >= 100 for _, positions in groups[:3]))
        self.assertEqual(groups[0][0], np.count_nonzero(labels == 0))

    def test_without_planes_is_a_page(self):
        page = self.page(points, np.full(len(points), -1), [])
        self.assertEqual([number for number, _ in self.groups(page)], [29500])

    def test_wrong_arguments_name_the_one_at_fault(self):
        for problem, arguments, options in (
            ("labels: shape", (points, labels[1:], planes), {}),
            ("labels: the label 2 is none of 2 planes", (points, labels, planes[:2]), {}),
            ("planes: not a list", (points, labels, [1]), {}),
            ("max_points", (points, labels, planes), {"max_points": -1}),
            ("up: has no direction", (points, labels, planes), {"up": (0, 0, 0)}),
        ):
            with self.assertRaisesRegex((ValueError, TypeError), problem):
                self.page(*arguments, **options)
        self.assertFalse(self.path.exists())

    def test_a_file_that_cannot_be_written_is_an_error_of_the_system(self):
        path = self.path.parent / "nowhere" / "room.html"
        with self.assertRaisesRegex(OSError, "its folder does not exist"):
            pcl_ops.write_html(path, points, labels, planes)
        self.assertEqual(os.listdir(self.path.parent), [])


if __name__ == "__main__":
    unittest.main()
