# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever way an array lies in memory, its points get the same labels, in place or as a copy."""

import unittest

import numpy as np
import pcl_ops
from pcl_ops._arguments import points_array, single_precision
from scene import room


def unaligned(points, kind):
    record = np.zeros(len(points), [("intensity", "u1"), ("xyz", kind, 3)])
    record["xyz"] = points
    return record["xyz"]


layouts = {
    "Fortran order": np.asfortranarray,
    "columns of a wider array": lambda points: np.tile(points, 3)[:, 3:6],
    "every other row": lambda points: np.repeat(points, 2, axis=0)[::2],
    "rows backwards": lambda points: points[::-1].copy()[::-1],
    "columns backwards": lambda points: points[:, ::-1].copy()[:, ::-1],
    "read-only": lambda points: np.broadcast_to(points, points.shape),
    "other order of bytes, double": lambda points: points.astype(">f8"),
    "unaligned": lambda points: unaligned(points, ">f4"),
    "unaligned double": lambda points: unaligned(points, "<f8"),
    "double, Fortran order": lambda points: np.asfortranarray(points, np.float64),
    "a list": np.ndarray.tolist,
}


class Arrays(unittest.TestCase):
    def test_any_layout_has_the_same_labels_and_hulls(self):
        points = room()
        labels, planes = pcl_ops.segment(points)
        for number, plane in enumerate(planes):
            np.testing.assert_array_equal(np.flatnonzero(labels == number), plane.inliers)
        self.assertEqual((labels.dtype, labels.shape), (np.int32, (len(points),)))
        self.assertEqual(set(labels[np.isnan(points[:, 0])]), {-1})
        for name, laid_out in layouts.items():
            with self.subTest(name):
                found, same = pcl_ops.segment(laid_out(points))
                np.testing.assert_array_equal(found, labels)
                for plane, expected in zip(same, planes):
                    np.testing.assert_allclose(plane.hull, expected.hull, atol=1e-6)


class FarAway(unittest.TestCase):
    """Coordinates as surveys have them: the planes keep their millimeters."""

    place = np.array([498765.4321, 5412345.6789, 312.3456])

    @classmethod
    def setUpClass(cls):
        near = room().astype(np.float64)
        # Digits that single precision does not have, so that they are not to be lost.
        cls.near = near + np.random.default_rng(5).uniform(-1e-9, 1e-9, near.shape)
        cls.near_labels, cls.near_planes = pcl_ops.segment(cls.near)
        cls.labels, cls.planes = pcl_ops.segment(cls.near + cls.place, viewpoint=cls.place)

    def test_planes_are_in_the_frame_of_the_array(self):
        self.assertGreater((self.labels == self.near_labels).mean(), 0.99)
        self.assertEqual(len(self.planes), 3)
        for plane, near in zip(self.planes, self.near_planes):
            np.testing.assert_allclose(plane.centroid - self.place, near.centroid, atol=1e-3)
            np.testing.assert_allclose(plane.normal, near.normal, atol=1e-3)
            # Evaluated at the place the terms are 5,000 km long.
            self.assertAlmostEqual(
                plane.coefficients @ np.append(self.place + near.centroid, 1.0), 0.0, delta=1e-3)
            self.assertAlmostEqual(plane.rms, near.rms, delta=1e-4)
            self.assertAlmostEqual(plane.area, near.area, delta=0.01 * near.area)
            offsets = (plane.hull - plane.centroid) @ plane.normal
            self.assertLess(np.abs(offsets).max(), 1e-6)

    def test_one_outlier_takes_no_digits(self):
        points = self.near + self.place
        points[0] = 1e9, -1e9, 1e9
        labels, planes = pcl_ops.segment(points, viewpoint=self.place)
        self.assertEqual((labels[0], len(planes)), (-1, 3))
        self.assertLess(planes[0].rms, 0.003)

    def test_merged_planes_keep_the_frame(self):
        found = pcl_ops.segment(
            self.near + self.place, viewpoint=self.place, merging_enabled=False)[1]
        for plane, near in zip(pcl_ops.merge_planes(found)[0], self.near_planes):
            np.testing.assert_allclose(plane.centroid - self.place, near.centroid, atol=0.01)
            self.assertAlmostEqual(plane.area, near.area, delta=0.01 * near.area)


class Memory(unittest.TestCase):
    def test_rows_in_order_alone_are_not_copied(self):
        wide = np.zeros((100, 9), np.float32)
        for points in (wide[:, :3], wide[:, 2:5], wide[::2, :3], wide[:, 6:].copy()):
            self.assertIs(single_precision(points_array(points))[0], points)
        for points in (wide[::-1, :3], wide[:, 2::-1], wide[:, ::3], wide[:, :3].astype(">f4"),
                       wide[:, :3].astype(np.float64)):
            self.assertFalse(np.shares_memory(single_precision(points_array(points))[0], points))
