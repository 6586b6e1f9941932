# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever way an array lies in memory, its points get the same labels."""

import unittest

import numpy as np
import pcl_ops
from scene import room


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = room()
        cls.labels, cls.planes = pcl_ops.segment(cls.points)

    def assertSameLabels(self, points):
        labels, planes = pcl_ops.segment(points)
        np.testing.assert_array_equal(labels, self.labels)
        for plane, expected in zip(planes, self.planes):
            np.testing.assert_allclose(plane.hull, expected.hull, atol=1e-6)

    def test_has_floor_and_walls(self):
        names = sorted(plane.orientation for plane in self.planes)
        self.assertEqual(names, ["horizontal", "vertical", "vertical"])
        self.assertEqual(self.labels.dtype, np.int32)
        self.assertEqual(self.labels.shape, (len(self.points),))

    def test_labels_are_the_planes_inliers(self):
        for number, plane in enumerate(self.planes):
            np.testing.assert_array_equal(np.flatnonzero(self.labels == number), plane.inliers)

    def test_nan_is_on_no_plane(self):
        blind = np.isnan(self.points[:, 0])
        self.assertEqual(blind.sum(), 100)
        self.assertTrue((self.labels[blind] == -1).all())

    def test_fortran_order(self):
        self.assertSameLabels(np.asfortranarray(self.points))

    def test_columns_of_a_wider_array(self):
        wide = np.zeros((len(self.points), 7), np.float32)
        wide[:, 2:5] = self.points
        self.assertSameLabels(wide[:, 2:5])

    def test_every_other_row(self):
        self.assertSameLabels(np.repeat(self.points, 2, axis=0)[::2])

    def test_negative_strides(self):
        self.assertSameLabels(self.points[::-1].copy()[::-1])
        self.assertSameLabels(self.points[:, ::-1].copy()[:, ::-1])

    def test_read_only(self):
        points = self.points.copy()
        points.flags.writeable = False
        self.assertSameLabels(points)

    def test_the_other_order_of_bytes(self):
        self.assertSameLabels(self.points.astype(">f4"))
        self.assertSameLabels(self.points.astype(">f8"))

    def test_unaligned(self):
        for kind in ("<f4", "<f8"):
            record = np.zeros(len(self.points), [("intensity", "u1"), ("xyz", kind, 3)])
            record["xyz"] = self.points
            self.assertSameLabels(record["xyz"])

    def test_float64(self):
        self.assertSameLabels(self.points.astype(np.float64))
        self.assertSameLabels(np.asfortranarray(self.points, np.float64)[::-1][::-1])

    def test_a_list(self):
        self.assertSameLabels(self.points.tolist())

    def test_an_array_that_is_gone(self):
        points = self.points.copy()
        _, planes = pcl_ops.segment(points)
        del points
        np.testing.assert_array_equal(planes[0].hull, self.planes[0].hull)


class FarAway(unittest.TestCase):
    """Coordinates as surveys have them: the planes keep their millimetres."""

    place = np.array([498765.4321, 5412345.6789, 312.3456])

    @classmethod
    def setUpClass(cls):
        near = room().astype(np.float64)
        # Digits that single precision does not have, so that they are not to be lost.
        cls.near = near + np.random.default_rng(5).uniform(-1e-9, 1e-9, near.shape)
        cls.near_labels, cls.near_planes = pcl_ops.segment(cls.near)
        cls.labels, cls.planes = pcl_ops.segment(cls.near + cls.place, viewpoint=cls.place)

    def test_planes_are_in_the_frame_of_the_array(self):
        self.assertEqual(len(self.planes), 3)
        for plane, near in zip(self.planes, self.near_planes):
            np.testing.assert_allclose(plane.centroid - self.place, near.centroid, atol=1e-3)
            np.testing.assert_allclose(plane.normal, near.normal, atol=1e-3)
            # Evaluated at the place the terms are 5,000 km long.
            self.assertAlmostEqual(
                plane.coefficients @ np.append(self.place + near.centroid, 1.0), 0.0, delta=1e-3)
            self.assertAlmostEqual(plane.rms, near.rms, delta=1e-4)

    def test_hulls_keep_their_millimetres(self):
        for plane, near in zip(self.planes, self.near_planes):
            self.assertAlmostEqual(plane.area, near.area, delta=0.01 * near.area)
            offsets = (plane.hull - plane.centroid) @ plane.normal
            self.assertLess(np.abs(offsets).max(), 1e-6)

    def test_nearly_all_labels_are_those_of_the_same_points_nearby(self):
        self.assertGreater((self.labels == self.near_labels).mean(), 0.99)

    def test_one_outlier_takes_no_digits(self):
        points = self.near + self.place
        points[0] = 1e9, -1e9, 1e9
        labels, planes = pcl_ops.segment(points, viewpoint=self.place)
        self.assertEqual(labels[0], -1)
        self.assertEqual(len(planes), 3)
        self.assertLess(planes[0].rms, 0.003)


if __name__ == "__main__":
    unittest.main()
