# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes that are wanted, and planes found again in another frame."""

import unittest

import numpy as np
import pcl_ops
from scene import room


def turn(degrees):
    """About z, as a 4 x 4 matrix."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    pose = np.eye(4)
    pose[:2, :2] = [[c, -s], [s, c]]
    return pose


def seen_from(pose, points):
    """The points in the frame that has this pose."""
    return ((points - pose[:3, 3]) @ pose[:3, :3]).astype(np.float32)


class FilterPlanes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # A floor of 12 m^2, a wall of 10 and one of 7.5.
        cls.planes = pcl_ops.segment(room(), viewpoint=(2, 1.5, 1))[1]

    def test_keeps_all_by_default(self):
        kept, dropped = pcl_ops.filter_planes(self.planes)
        self.assertEqual(kept, self.planes)
        self.assertEqual(set(dropped.values()), {0})

    def test_keeps_what_each_argument_asks_for(self):
        floor, wall, side = self.planes
        for argument, value, expected in [
            ("orientation", "horizontal", [floor]),
            ("direction", (0, 2, 0), [wall]),
            ("min_points", 9000, [floor, wall]),
            ("min_area", 9.0, [floor, wall]),
            ("min_width", 2.8, [floor]),
            ("max_planes", 2, [floor, wall]),
        ]:
            with self.subTest(argument):
                kept, dropped = pcl_ops.filter_planes(self.planes, **{argument: value})
                self.assertEqual(kept, expected)
                self.assertEqual(dropped[argument], 3 - len(expected))
                self.assertEqual(sum(dropped.values()), 3 - len(expected))
        self.assertEqual(len(pcl_ops.filter_planes(
            self.planes, direction=(0, 1, 0.3), direction_tolerance=0.1)[0]), 0)

    def test_counts_a_plane_once_and_takes_the_first_of_those_left(self):
        kept, dropped = pcl_ops.filter_planes(
            self.planes, orientation="vertical", min_area=20.0, max_planes=1)
        self.assertEqual(kept, [])
        self.assertEqual((dropped["orientation"], dropped["min_area"]), (1, 2))
        kept, _ = pcl_ops.filter_planes(self.planes, orientation="vertical", max_planes=1)
        self.assertEqual(kept, [self.planes[1]])

    def test_refuses_by_name(self):
        for arguments, name in [
            ({"orientation": "steep"}, "orientation"),
            ({"direction": (0, 0, 0)}, "direction"),
            ({"direction_tolerance": 4.0}, "direction_tolerance"),
            ({"min_points": -1}, "min_points"),
            ({"min_area": float("nan")}, "min_area"),
            ({"min_width": -1.0}, "min_width"),
            ({"max_planes": -1}, "max_planes"),
        ]:
            with self.subTest(name), self.assertRaisesRegex(ValueError, name):
                pcl_ops.filter_planes(self.planes, **arguments)
        with self.assertRaisesRegex(TypeError, "planes"):
            pcl_ops.filter_planes([1])


class MatchPlanes(unittest.TestCase):
    def setUp(self):
        self.points = room()
        self.previous = pcl_ops.segment(self.points)[1]

    def test_finds_planes_in_a_frame_that_has_moved(self):
        pose = turn(50)
        pose[:3, 3] = (1, 2, 0.5)
        current = pcl_ops.segment(seen_from(pose, self.points))[1]
        matches, _ = pcl_ops.match_planes(self.previous, current, pose)
        self.assertEqual(matches.dtype, np.int32)
        self.assertEqual(matches.tolist(), [0, 1, 2])
        matches, _ = pcl_ops.match_planes(self.previous, list(reversed(current)), pose)
        self.assertEqual(matches.tolist(), [2, 1, 0])
        self.assertEqual(pcl_ops.match_planes(self.previous, current)[0].tolist(), [-1, -1, -1])

    def test_mends_the_pose(self):
        current = pcl_ops.segment(seen_from(turn(4), self.points))[1]
        matches, pose = pcl_ops.match_planes(self.previous, current)
        self.assertEqual(matches.tolist(), [0, 1, 2])
        np.testing.assert_allclose(pose, turn(4), atol=0.01)
        exact = {"rotation_error": 0.0, "translation_error": 0.0}
        matches, pose = pcl_ops.match_planes(self.previous, current, **exact)
        self.assertLess(matches[1], 0)
        np.testing.assert_allclose(pose, np.eye(4), atol=1e-9)

    def test_refuses_by_name(self):
        for arguments, name in [
            ({"pose": np.eye(3)}, "pose"),
            ({"pose": 2 * np.eye(4)}, "pose"),
            ({"pose": np.full((4, 4), np.nan)}, "pose"),
            ({"rotation_error": -1.0}, "rotation_error"),
            ({"translation_error": -1.0}, "translation_error"),
            ({"min_overlap": 2.0}, "min_overlap"),
            ({"max_angle": 2.0}, "max_angle"),
        ]:
            with self.subTest(name), self.assertRaisesRegex(ValueError, name):
                pcl_ops.match_planes(self.previous, self.previous, **arguments)
        with self.assertRaisesRegex(TypeError, "current"):
            pcl_ops.match_planes(self.previous, [1])


if __name__ == "__main__":
    unittest.main()
