# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes that are wanted, and planes found again in another frame."""

import copy
import pickle
import unittest

import numpy as np
import pcl_ops
from scene import room, seen_from, turn


class FilterPlanes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # A floor of 12 m^2, a wall of 10 and one of 7.5.
        cls.planes = pcl_ops.segment(room(), viewpoint=(2, 1.5, 1))[1]

    def test_keeps_what_each_argument_asks_for_and_counts_a_plane_once(self):
        floor, wall, side = self.planes
        kept, dropped = pcl_ops.filter_planes(self.planes)
        self.assertEqual((kept, set(dropped.values())), (self.planes, {0}))
        for argument, value, expected in [
            ("orientation", "horizontal", [floor]),
            ("direction", (0, 2, 0), [wall]),
            ("min_points", 9000, [floor, wall]),
            ("min_area", 9.0, [floor, wall]),
            ("min_width", 2.8, [floor]),
            ("max_area", 9.0, [side]),
            ("max_width", 2.8, [wall, side]),
            ("slope", (1.4, np.pi / 2), [wall, side]),
            ("size", (2.5, 4.0, 0.1), [wall]),
            ("max_planes", 2, [floor, wall]),
        ]:
            with self.subTest(argument):
                kept, dropped = pcl_ops.filter_planes(self.planes, **{argument: value})
                self.assertEqual(kept, expected)
                self.assertEqual(dropped[argument], 3 - len(expected))
                self.assertEqual(sum(dropped.values()), 3 - len(expected))
        kept, dropped = pcl_ops.filter_planes(
            self.planes, orientation="vertical", min_area=20.0, max_planes=1)
        self.assertEqual(kept, [])
        self.assertEqual((dropped["orientation"], dropped["min_area"]), (1, 2))


class MatchPlanes(unittest.TestCase):
    def test_finds_planes_in_a_frame_that_has_moved_and_corrects_the_pose(self):
        points = room()
        previous = pcl_ops.segment(points)[1]
        pose = turn(50)
        pose[:3, 3] = (1, 2, 0.5)
        current = pcl_ops.segment(seen_from(pose, points))[1]
        matches, _ = pcl_ops.match_planes(previous, current[::-1], pose)
        self.assertEqual((matches.dtype, matches.tolist()), (np.int32, [2, 1, 0]))
        self.assertEqual(pcl_ops.match_planes(previous, current)[0].tolist(), [-1, -1, -1])
        current = pcl_ops.segment(seen_from(turn(4), points))[1]
        matches, pose = pcl_ops.match_planes(previous, current)
        self.assertEqual(matches.tolist(), [0, 1, 2])
        np.testing.assert_allclose(pose, turn(4), atol=0.01)
        matches, pose = pcl_ops.match_planes(
            previous, current, rotation_error=0.0, translation_error=0.0)
        self.assertLess(matches[1], 0)
        np.testing.assert_allclose(pose, np.eye(4), atol=1e-9)


class Tracker(unittest.TestCase):
    def setUp(self):
        self.poses = [turn(degrees) for degrees in (0, 20, 40)]
        self.frames = [pcl_ops.segment(seen_from(pose, room()))[1] for pose in self.poses]

    def test_keeps_numbers_also_of_planes_out_of_sight(self):
        tracker = pcl_ops.PlaneTracker()
        shown = (self.frames[0], self.frames[1][:2], self.frames[2][::-1])
        numbers = [tracker.track(*frame).tolist() for frame in zip(shown, self.poses)]
        self.assertEqual(numbers, [[1, 2, 3], [1, 2], [3, 2, 1]])
        self.assertEqual([(one.number, one.last_seen, one.first_seen, one.times_seen)
                          for one in tracker.planes], [(1, 2, 0, 3), (2, 2, 0, 3), (3, 2, 0, 2)])
        np.testing.assert_allclose(tracker.pose, self.poses[2], atol=0.01)
        for tracked, plane in zip(tracker.planes, self.frames[0]):
            self.assertAlmostEqual(abs(tracked.plane.normal @ plane.normal), 1.0, delta=1e-3)
            self.assertEqual(tracked.plane.area, 0.0)
            np.testing.assert_allclose(np.ptp(tracked.hull, 0), np.ptp(plane.hull, 0), atol=0.5)

    def test_forgets_and_copies_are_apart_and_pickling_is_refused(self):
        tracker = pcl_ops.PlaneTracker(memory=0)
        for planes in (self.frames[0], []):
            tracker.track(planes)
        self.assertEqual(tracker.track(self.frames[0]).tolist(), [4, 5, 6])
        tracker = pcl_ops.PlaneTracker(max_distance=50.0)
        far = np.eye(4)
        far[0, 3] = 100.0
        for planes, pose in ((self.frames[0], None), ([], far)):
            tracker.track(planes, pose)
        self.assertEqual(tracker.planes, [])
        tracker = pcl_ops.PlaneTracker()
        tracker.track(self.frames[0])
        for copied in (copy.copy(tracker), copy.deepcopy(tracker)):
            copied.track(self.frames[0], self.poses[2])
            self.assertGreater(len(copied.planes), 3)
        self.assertEqual(len(tracker.planes), 3)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with self.assertRaisesRegex(TypeError, "pcl_ops.PlaneTracker"):
                pickle.dumps(tracker, protocol)
