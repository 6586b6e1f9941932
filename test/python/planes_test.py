# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What planes say of themselves, and what is made of lists of them."""

import unittest

import numpy as np
import pcl_ops
from scene import room, surface


class Planes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = room()
        cls.labels, cls.planes = pcl_ops.segment(cls.points, viewpoint=(2, 1.5, 1))
        cls.floor = next(plane for plane in cls.planes if plane.orientation == "horizontal")

    def test_come_by_falling_size(self):
        sizes = [len(plane.inliers) for plane in self.planes]
        self.assertEqual(sizes, sorted(sizes, reverse=True))

    def test_have_normals_towards_the_viewpoint(self):
        np.testing.assert_allclose(self.floor.normal, (0, 0, 1), atol=0.01)
        below = pcl_ops.segment(self.points, viewpoint=(2, 1.5, -9))[1]
        floor = next(plane for plane in below if plane.orientation == "horizontal")
        np.testing.assert_allclose(floor.normal, (0, 0, -1), atol=0.01)

    def test_fit_their_inliers(self):
        for plane in self.planes:
            inliers = self.points[plane.inliers].astype(np.float64)
            np.testing.assert_allclose(plane.centroid, inliers.mean(axis=0), atol=1e-5)
            distances = inliers @ plane.coefficients[:3] + plane.coefficients[3]
            self.assertAlmostEqual(plane.rms, np.sqrt((distances**2).mean()), places=5)
            np.testing.assert_array_equal(plane.coefficients[:3], plane.normal)

    def test_end_where_their_points_end(self):
        self.assertAlmostEqual(self.floor.area, 12.0, delta=0.2)
        self.assertAlmostEqual(self.floor.length, 4.0, delta=0.05)
        self.assertAlmostEqual(self.floor.width, 3.0, delta=0.05)
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

    def test_inliers_cannot_be_written(self):
        with self.assertRaises(ValueError):
            self.floor.inliers[0] = 10**6

    def test_inliers_outlive_their_plane(self):
        inliers = pcl_ops.segment(self.points)[1][0].inliers
        np.testing.assert_array_equal(inliers, self.planes[0].inliers)

    def test_are_printed_in_a_line(self):
        self.assertRegex(repr(self.floor), r"<pcl_ops.Plane: horizontal, \d+ points, rms 0.00\d+>")


class UpAxis(unittest.TestCase):
    def test_of_a_room_is_found_in_any_frame(self):
        tilt = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], np.float32)
        viewpoint = tilt @ (3.5, 0.3, 1.5)
        planes = pcl_ops.segment(room() @ tilt.T, viewpoint=viewpoint)[1]
        direction, confidence = pcl_ops.estimate_up_axis(planes, viewpoint)
        np.testing.assert_allclose(direction, tilt @ (0, 0, 1), atol=0.01)
        self.assertTrue(0.7 <= confidence <= 1.0)

    def test_is_none_where_planes_cannot_tell(self):
        self.assertIsNone(pcl_ops.estimate_up_axis([]))
        planes = pcl_ops.segment(room())[1]
        self.assertIsNone(pcl_ops.estimate_up_axis(planes, least_confidence=1.0))


class Merging(unittest.TestCase):
    """Two pieces of a floor with a gap, and a step of 12 cm beside them."""

    def setUp(self):
        self.points = np.vstack([
            surface((0, 0, 0), (2, 0, 0), (0, 2, 0), 9000, seed=1),
            surface((3, 0, 0.01), (2, 0, 0), (0, 2, 0), 6000, seed=2),
            surface((0, 3, 0.12), (5, 0, 0), (0, 0.5, 0), 5000, seed=3),
        ]).astype(np.float32)
        self.planes = pcl_ops.segment(self.points, viewpoint=(0, 0, 2), merging_enabled=False)[1]
        self.sizes = [len(plane.inliers) for plane in self.planes]

    def test_joins_what_is_one_plane(self):
        merged, into = pcl_ops.merge_planes(self.planes)
        self.assertEqual(len(self.planes), 3)
        self.assertEqual(into.tolist(), [0, 0, 1])
        self.assertEqual(len(merged[0].inliers), self.sizes[0] + self.sizes[1])
        np.testing.assert_array_equal(
            merged[0].inliers, np.union1d(self.planes[0].inliers, self.planes[1].inliers))
        self.assertAlmostEqual(merged[0].area, 10.0, delta=0.2)
        self.assertEqual(merged[0].orientation, "horizontal")
        self.assertGreater(merged[0].normal[2], 0.99)

    def test_takes_thresholds(self):
        self.assertEqual(len(pcl_ops.merge_planes(self.planes, distance_threshold=0.001)[0]), 3)
        self.assertEqual(len(pcl_ops.merge_planes(self.planes, distance_threshold=0.2)[0]), 1)
        self.assertEqual(len(pcl_ops.merge_planes(self.planes, enabled=False)[0]), 3)

    def test_names_orientations_by_the_given_axis(self):
        merged, _ = pcl_ops.merge_planes(self.planes, up=(1, 0, 0))
        self.assertEqual(merged[0].orientation, "vertical")

    def test_of_nothing_is_nothing(self):
        merged, into = pcl_ops.merge_planes([])
        self.assertEqual((merged, into.tolist()), ([], []))

    def test_keeps_the_frame_of_coordinates_in_the_millions(self):
        place = np.array([5e5, 5.4e6, 300.0])
        far = pcl_ops.segment(
            self.points + place, viewpoint=place + (0, 0, 2), merging_enabled=False)[1]
        merged, _ = pcl_ops.merge_planes(far)
        np.testing.assert_allclose(
            merged[0].centroid - place, pcl_ops.merge_planes(self.planes)[0][0].centroid, atol=0.01)
        self.assertAlmostEqual(merged[0].area, 10.0, delta=0.2)


if __name__ == "__main__":
    unittest.main()
