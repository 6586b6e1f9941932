# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What planes say of themselves, which way is up by them, and where they meet."""

import pickle
import unittest

import numpy as np
import pcl_ops
from scene import room, surface

viewpoint = np.array([2, 1.5, 1])


class Planes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = room()
        cls.planes = pcl_ops.segment(cls.points, viewpoint=viewpoint)[1]
        cls.floor = cls.planes[0]

    def test_come_by_falling_size_with_normals_towards_the_viewpoint(self):
        sizes = [len(plane.inliers) for plane in self.planes]
        self.assertEqual(sizes, sorted(sizes, reverse=True))
        np.testing.assert_allclose(self.floor.normal, (0, 0, 1), atol=0.01)
        below = pcl_ops.segment(self.points, viewpoint=(2, 1.5, -9))[1]
        np.testing.assert_allclose(below[0].normal, (0, 0, -1), atol=0.01)

    def test_fit_their_inliers(self):
        for plane in self.planes:
            inliers = self.points[plane.inliers].astype(np.float64)
            np.testing.assert_allclose(plane.centroid, inliers.mean(axis=0), atol=1e-5)
            distances = inliers @ plane.coefficients[:3] + plane.coefficients[3]
            self.assertAlmostEqual(plane.rms, np.sqrt((distances**2).mean()), places=5)
            np.testing.assert_array_equal(plane.coefficients[:3], plane.normal)

    def test_end_where_their_points_end(self):
        for name, expected in (("area", 12.0), ("length", 4.0), ("width", 3.0)):
            self.assertAlmostEqual(getattr(self.floor, name), expected, delta=0.2)
        np.testing.assert_allclose(self.floor.hull.max(axis=0), (4, 3, 0), atol=0.05)
        np.testing.assert_allclose(self.floor.hull.min(axis=0), (0, 0, 0), atol=0.05)

    def test_covariance_is_that_of_heights_over_the_axes(self):
        for plane in self.planes:
            local = self.points[plane.inliers] - plane.centroid
            rows = np.column_stack([local @ plane.axes.T, np.ones(len(local))])
            variance = plane.rms**2 * len(local) / (len(local) - 3)
            expected = variance * np.linalg.inv(rows.T @ rows)
            np.testing.assert_allclose(plane.covariance, expected, rtol=1e-3, atol=1e-15)
            np.testing.assert_allclose(np.cross(*plane.axes), plane.normal, atol=1e-12)

    def test_correlated_covariance_knows_noise_that_neighbors_share(self):
        rng = np.random.default_rng(1)
        places = np.mgrid[0:100, 0:100].reshape(2, -1) * 0.02 + 1e6
        for side, least, most in ((1, 0.5, 10.0), (10, 50.0, 1000.0)):
            noise = rng.normal(0.0, 0.01, (100 // side, 100 // side)).repeat(side, 0)
            points = np.column_stack([*places, noise.repeat(side, 1).ravel()])
            plane = pcl_ops.segment(points)[1][0]
            ratio = np.diag(plane.correlated_covariance) / np.diag(plane.covariance)
            self.assertTrue((ratio > least).all() and (ratio < most).all(), ratio)

    def test_inliers_are_read_only_and_outlive_their_plane(self):
        inliers = pcl_ops.segment(self.points)[1][0].inliers
        np.testing.assert_array_equal(inliers, self.floor.inliers)
        with self.assertRaises(ValueError):
            inliers[0] = 10**6

    def test_print_in_a_line_and_pickle_with_one_array_for_all(self):
        self.assertRegex(repr(self.floor), r"<pcl_ops.Plane: horizontal, \d+ points, rms 0.00\d+>")
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            planes = pickle.loads(pickle.dumps(self.planes, protocol))
            for plane, original in zip(planes, self.planes):
                for name in ("coefficients", "inliers", "hull", "covariance"):
                    np.testing.assert_array_equal(getattr(plane, name), getattr(original, name))
                self.assertEqual(repr(plane), repr(original))
        self.assertEqual(len(pcl_ops.merge_planes(planes)[0]), 3)
        self.assertLess(len(pickle.dumps(self.planes)), 2 * self.points.nbytes)


class UpAxis(unittest.TestCase):
    sensor = np.array([3.5, 0.3, 1.5])

    def test_of_a_room_is_found_in_any_frame(self):
        tilt = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], np.float32)
        planes = pcl_ops.segment(room() @ tilt.T, viewpoint=tilt @ self.sensor)[1]
        direction, confidence = pcl_ops.estimate_up_axis(planes, tilt @ self.sensor)
        np.testing.assert_allclose(direction, tilt @ (0, 0, 1), atol=0.01)
        self.assertTrue(0.7 <= confidence <= 1.0)

    def test_is_none_where_planes_cannot_tell_or_were_not_seen_from_the_viewpoint(self):
        self.assertIsNone(pcl_ops.estimate_up_axis([]))
        planes = pcl_ops.segment(room())[1]
        self.assertIsNone(pcl_ops.estimate_up_axis(planes, min_confidence=1.0))
        hidden = surface((0, 6, 0), (4, 0, 0), (0, 0, 2.5), 10000)
        points = np.vstack([room(), hidden]).astype(np.float32)
        self.assertTrue(pcl_ops.is_seen_from(room(), self.sensor))
        self.assertFalse(pcl_ops.is_seen_from(points, self.sensor))
        self.assertFalse(pcl_ops.is_seen_from(points + 5e6, self.sensor + 5e6))
        planes = pcl_ops.segment(points, viewpoint=self.sensor)[1]
        self.assertIsNone(pcl_ops.estimate_up_axis(planes, self.sensor))


class Edges(unittest.TestCase):
    def assertMeet(self, place):
        planes = pcl_ops.segment(room() + place, viewpoint=viewpoint + place)[1]
        edges, corners = pcl_ops.find_plane_edges(planes)
        self.assertEqual([edge.planes for edge in edges], [(0, 1), (0, 2), (1, 2)])
        for edge, length in zip(edges, (4.0, 3.0, 2.5)):
            self.assertAlmostEqual(np.linalg.norm(edge.end - edge.start), length, delta=0.1)
            self.assertAlmostEqual(edge.angle, np.pi / 2, delta=0.01)
        self.assertEqual([corner.planes for corner in corners], [(0, 1, 2)])
        np.testing.assert_allclose(corners[0].position - place, (0, 3, 0), atol=0.01)
        self.assertEqual(len(pcl_ops.find_plane_edges(planes, min_length=2.8)[0]), 2)

    def test_are_found_near_zero_and_with_coordinates_in_the_millions(self):
        self.assertMeet(np.zeros(3, np.float32))
        self.assertMeet(np.array([5e5, 5.4e6, 300.0]))

        self.assertEqual(pcl_ops.find_plane_edges([]), ([], []))


class Merging(unittest.TestCase):
    """Two pieces of a floor with a gap, and a step of 12 cm beside them."""

    def setUp(self):
        self.points = np.vstack([
            surface((0, 0, 0), (2, 0, 0), (0, 2, 0), 9000, seed=1),
            surface((3, 0, 0.01), (2, 0, 0), (0, 2, 0), 6000, seed=2),
            surface((0, 3, 0.12), (5, 0, 0), (0, 0.5, 0), 5000, seed=3),
        ]).astype(np.float32)
        self.planes = pcl_ops.segment(self.points, viewpoint=(0, 0, 2), merging_enabled=False)[1]

    def test_joins_what_is_one_plane(self):
        merged, into = pcl_ops.merge_planes(self.planes)
        self.assertEqual(len(self.planes), 3)
        self.assertEqual(into.tolist(), [0, 0, 1])
        np.testing.assert_array_equal(
            merged[0].inliers, np.union1d(self.planes[0].inliers, self.planes[1].inliers))
        self.assertAlmostEqual(merged[0].area, 10.0, delta=0.2)
        self.assertEqual(merged[0].orientation, "horizontal")
        self.assertGreater(merged[0].normal[2], 0.99)

    def test_takes_parameters(self):
        for number, given in ((3, {"distance_threshold": 0.001}), (1, {"distance_threshold": 0.2}),
                              (3, {"enabled": False})):
            self.assertEqual(len(pcl_ops.merge_planes(self.planes, **given)[0]), number)
        merged, _ = pcl_ops.merge_planes(self.planes, up=(1, 0, 0))
        self.assertEqual(merged[0].orientation, "vertical")
        merged, into = pcl_ops.merge_planes([])
        self.assertEqual((merged, into.tolist()), ([], []))
