# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages for a browser, by write_html."""

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
        """The groups of points of a page: those of each plane, then those on no plane.

        Yields for each group its number of points, and the positions of the points that are shown.
        """
        # Three integers for each shown point: steps from the origin of its group.
        steps_left = np.frombuffer(base64.b64decode(part_of(page, "steps")), "<u2").reshape(-1, 3)
        for group in json.loads(part_of(page, "groups")):
            steps, steps_left = np.split(steps_left, [group["shown"]])
            yield group["all"], np.asarray(group["origin"]) + steps * group["step"]
        self.assertEqual(len(steps_left), 0)

    def test_has_all_points_in_groups_by_plane_also_far_from_zero(self):
        for shift in (0.0, 5e6):
            moved = points.astype(float) + shift
            moved_labels, moved_planes = pcl_ops.segment(moved, viewpoint=viewpoint + shift)
            groups = list(self.groups(self.page(moved, moved_labels, moved_planes)))
            self.assertEqual(len(groups), len(moved_planes) + 1)
            is_finite = np.isfinite(moved).all(axis=1)
            for label, (number, positions) in zip([*range(len(moved_planes)), -1], groups):
                expected = moved[is_finite & (moved_labels == label)]
                self.assertEqual((number, len(positions)), (len(expected), len(expected)))
                # The order of a page is another one. A step of 4 m / 65535 is 0.06 mm.
                for axis in range(3):
                    np.testing.assert_allclose(np.sort(positions[:, axis]),
                                               np.sort(expected[:, axis]), rtol=0, atol=1e-4)

    def test_describes_planes_and_their_edges(self):
        description = json.loads(part_of(self.page(points, labels, planes), "description"))
        self.assertEqual(description["title"], "room.html")
        self.assertFalse(description["backs"], "the viewpoint sees planes from the front")
        for plane, shown in zip(planes, description["planes"]):
            self.assertEqual((shown["orientation"], shown["area"], shown["rms"]),
                             (plane.orientation, plane.area, plane.rms))
            np.testing.assert_array_equal(shown["hull"], plane.hull)
        self.assertEqual([round(shown["slope"]) for shown in description["planes"]], [0, 90, 90])
        self.assertEqual(len({shown["color"] for shown in description["planes"]}), 3)
        edges, _ = pcl_ops.find_plane_edges(planes)
        self.assertEqual(len(description["edges"]), len(edges))
        middle_of_room = (2, 1.5, 1)
        self.assertGreater(np.dot(description["view"], viewpoint - middle_of_room), 0,
                           "the view is from the side of the sensor")

    def test_shows_at_most_max_points_and_some_of_each_plane(self):
        # A title with a tag of HTML does not break the page.
        groups = list(self.groups(self.page(points, labels, planes, max_points=1000, title="<b>")))
        self.assertLessEqual(sum(len(positions) for _, positions in groups), 1000)
        # Evenly drawn, the smallest of the three planes has a quarter of them.
        self.assertTrue(all(len(positions) >= 100 for _, positions in groups[:3]))
        self.assertEqual(groups[0][0], np.count_nonzero(labels == 0))

    def test_without_planes_has_all_finite_points_in_one_group(self):
        page = self.page(points, np.full(len(points), -1), [])
        finite = np.count_nonzero(np.isfinite(points).all(axis=1))
        self.assertEqual([number for number, _ in self.groups(page)], [finite])

    def test_is_not_written_if_an_argument_is_wrong_which_the_error_names(self):
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

    def test_in_a_folder_that_does_not_exist_is_an_os_error(self):
        path = self.path.parent / "nowhere" / "room.html"
        with self.assertRaisesRegex(OSError, "its folder does not exist"):
            pcl_ops.write_html(path, points, labels, planes)
        self.assertEqual(os.listdir(self.path.parent), [])

    def test_does_not_replace_a_file_of_another_kind(self):
        path = self.path.parent / "room.pcd"
        path.write_text("mine")
        with self.assertRaisesRegex(ValueError, "room.pcd: has an unknown extension; give .html"):
            pcl_ops.write_html(path, points, labels, planes)
        self.assertEqual(path.read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
