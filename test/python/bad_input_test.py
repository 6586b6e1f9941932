# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong is said by name, and nothing crashes."""

import pickle
import unittest

import numpy as np
import pcl_ops
from scene import room

points = room()
labels = np.zeros(len(points), np.int32)


def segment(array=points, **arguments):
    return lambda: pcl_ops.segment(array, **arguments)


def evaluate(truth=labels, result=labels, **arguments):
    return lambda: pcl_ops.evaluate(truth, result, points, **arguments)


# What is called, what it raises, and what that begins with.
table = [
    (segment(np.zeros((5, 4), np.float32)), ValueError, "points: shape (5, 4) is not (N, 3)"),
    (segment(np.zeros((3, 5), np.float32)), ValueError, "points: shape (3, 5)"),
    (segment(np.zeros(9, np.float32)), ValueError, "points: shape (9,)"),
    (segment(np.zeros((2, 2, 3), np.float32)), ValueError, "points: shape (2, 2, 3)"),
    (segment(np.float32(1)), ValueError, "points: shape ()"),
    (segment(np.zeros((0, 3), np.float32)), ValueError, "points: shape (0, 3)"),
    (segment([]), ValueError, "points: shape (0,)"),
    (segment(np.zeros((5, 3), int)), TypeError, "points: dtype int64"),
    (segment(np.zeros((5, 3), np.float16)), TypeError, "points: dtype float16"),
    (segment(np.zeros((5, 3), np.longdouble)), TypeError, "points: dtype float128"),
    (segment(np.zeros((5, 3), complex)), TypeError, "points: dtype complex128"),
    (segment(np.zeros((5, 3), object)), TypeError, "points: dtype object"),
    (segment(np.zeros(5, [("x", "f4")])), TypeError, "points: dtype [('x'"),
    (segment("room.pcd"), TypeError, "points: dtype <U8"),
    (segment(None), TypeError, "points: dtype object"),
    (segment(np.ma.masked_invalid(points)), TypeError, "points: a masked array"),
    (segment(method="ransac"), ValueError, "method: 'ransac'"),
    (segment(method="\ud800"), ValueError, "method: '\\ud800' is not 'ops'"),
    (segment(**{"\ud800": 1}), ValueError, "\\ud800: unknown parameter"),
    (segment(method=3), TypeError, "method: not 'ops' or 'fspf' or 'kht': 3"),
    (segment(preset="fast"), ValueError, "preset: 'fast'"),
    (segment(preset=None), TypeError, "preset: "),
    (segment(viewpoint=(0, 0)), TypeError, "viewpoint: not three numbers (x, y, z)"),
    (segment(viewpoint="xyz"), TypeError, "viewpoint: "),
    (segment(viewpoint=(0, 0, np.nan)), ValueError, "viewpoint: "),
    (segment(smapling_rate=0.1), ValueError, "smapling_rate: unknown parameter"),
    (segment(phi_num=30), ValueError, "phi_num: unknown parameter"),
    (segment(method="kht", k=30), ValueError, "k: unknown parameter"),
    (segment(k=1), ValueError, "k: k must be 2 or more"),
    (segment(k=2.5), TypeError, "k: not a whole number: 2.5"),
    (segment(k="30"), TypeError, "k: not a whole number: '30'"),
    (segment(k=True), TypeError, "k: not a whole number"),
    (segment(k=np.True_), TypeError, "k: not a whole number"),
    (segment(k=np.array([30])), TypeError, "k: not a whole number: array([30])"),
    (segment(k=10**30), ValueError, "k: 1000000000000000000000000000000 is not between"),
    (segment(seed=-1), ValueError, "seed: -1 is not between 0 and 4294967295"),
    (segment(threads=-1), ValueError, "threads: -1"),
    (segment(sampling_rate=0), ValueError, "sampling_rate: the sampling rate must be"),
    (segment(sampling_rate=np.nan), ValueError, "sampling_rate: the sampling rate must be"),
    (segment(sampling_rate=None), TypeError, "sampling_rate: not a number: None"),
    (segment(sampling_rate=1j), TypeError, "sampling_rate: not a number: 1j"),
    (segment(sampling_rate=np.ones(2)), TypeError, "sampling_rate: not a number"),
    (segment(sampling_rate=np.complex64(1)), TypeError, "sampling_rate: not a number"),
    (segment(sampling_rate=np.True_), TypeError, "sampling_rate: not a number"),
    (segment(sampling_rate="ä" * 100), TypeError, "sampling_rate: not a number: '" + "ä" * 79 + "..."),
    (segment(sampling="point"), ValueError, "sampling: 'point' is not 'points' or 'surfels'"),
    (segment(sampling="points"), ValueError, "sampling: the distance threshold must be"),
    (segment(distance_threshold=-1), ValueError, "distance_threshold: the distance"),
    (segment(k=30, probability=1), ValueError, "probability: "),
    (segment(up=(0, 0, 0)), ValueError, "up: the up axis must be"),
    (segment(up=1), TypeError, "up: not three numbers"),
    (segment(up=np.array(5.0)), TypeError, "up: not three numbers (x, y, z): array(5.)"),
    (segment(up=(1, 2, "z")), TypeError, "up: not a number: 'z'"),
    (segment(local_optimisation=1), TypeError, "local_optimisation: not True or False: 1"),
    (segment(merging_angle_threshold=9), ValueError, "merging_angle_threshold: the merging"),
    (segment(method="fspf", outer_radius=0.01), ValueError, "outer_radius: "),
    (segment(method="fspf", local_samples=2), ValueError, "local_samples: "),
    (segment(method="kht", clusters_min_samples=-1), ValueError, "clusters_min_samples: -1"),
    (lambda: pcl_ops.parameters("ransac"), ValueError, "method: 'ransac'"),
    (lambda: pcl_ops.merge_planes([1]), TypeError, "planes: not a list of pcl_ops.Plane: 1"),
    (lambda: pcl_ops.merge_planes(None), TypeError, "planes: not a list of pcl_ops.Plane: None"),
    (lambda: pcl_ops.merge_planes([], angle_threshold=9), ValueError, "angle_threshold: "),
    (lambda: pcl_ops.merge_planes([], up=(0, 0, 0)), ValueError, "up: the up axis must be"),
    (lambda: pcl_ops.merge_planes([], angle=1), ValueError, "angle: unknown parameter"),
    (lambda: pcl_ops.estimate_up_axis([None]), TypeError, "planes: not a list"),
    (lambda: pcl_ops.estimate_up_axis([], least_share="x"), TypeError, "least_share: "),
    (lambda: pcl_ops.estimate_up_axis([], least_share=2), ValueError, "least_share: the least"),
    (lambda: pcl_ops.estimate_up_axis([], angle_tolerance=7), ValueError, "angle_tolerance: the"),
    (lambda: pcl_ops.estimate_up_axis([], least_confidence=np.nan), ValueError, "least_confidence: "),
    (lambda: pcl_ops.match_planes([1], []), TypeError, "previous: not a list of pcl_ops.Plane: 1"),
    (lambda: pcl_ops.match_planes([], None), TypeError, "current: not a list of pcl_ops.Plane: None"),
    (lambda: pcl_ops.match_planes([], [], "a"), TypeError, "pose: dtype <U1"),
    (lambda: pcl_ops.match_planes([], [], 1j * np.eye(4)), TypeError, "pose: dtype complex128"),
    (lambda: pcl_ops.filter_planes([], min_area=None), TypeError, "min_area: not a number: None"),
    (evaluate(labels[:-1]), ValueError, "truth: shape (29599,) is not (29600,)"),
    (evaluate(result=labels[None]), ValueError, "result: shape (1, 29600)"),
    (evaluate(result=labels.astype(float)), TypeError, "result: dtype float64"),
    (evaluate(labels.astype(np.int64) + 2**32), ValueError, "truth: the label 4294967296 is too large"),
    (evaluate(labels.astype(np.uint64) + np.uint64(2**63)), ValueError, "truth: the label "),
    (evaluate(np.ma.masked_equal(labels, 1)), TypeError, "truth: a masked array"),
    (evaluate(up=(0, 0, np.inf)), ValueError, "up: the up axis must be"),
]


class BadInput(unittest.TestCase):
    def test_is_said_by_name(self):
        for call, error, beginning in table:
            with self.subTest(beginning):
                with self.assertRaises(error) as raised:
                    call()
                self.assertTrue(str(raised.exception).startswith(beginning), raised.exception)

    def test_planes_of_different_arrays_do_not_merge(self):
        first = pcl_ops.segment(points)[1]
        second = pcl_ops.segment(points.copy())[1]
        with self.assertRaisesRegex(ValueError, "planes: .*different arrays"):
            pcl_ops.merge_planes(first + second)

    def test_planes_that_share_points_do_not_merge(self):
        planes = pcl_ops.segment(points)[1]
        with self.assertRaisesRegex(ValueError, "planes: some share points"):
            pcl_ops.merge_planes(planes + planes[:1])

    def test_what_another_value_raises_is_not_lost(self):
        class Interrupted:
            def __float__(self):
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            pcl_ops.segment(points, sampling_rate=Interrupted())

    def test_planes_are_not_pickled(self):
        plane = pcl_ops.segment(points)[1][0]
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with self.assertRaisesRegex(TypeError, "pcl_ops.Plane"):
                pickle.dumps(plane, protocol)


class NothingToFind(unittest.TestCase):
    """As in C++ no plane is an answer, not an error."""

    def test_without_a_finite_point(self):
        for nothing in (np.nan, np.inf, -np.inf):
            for kind in (np.float32, np.float64):
                labels, planes = pcl_ops.segment(np.full((1000, 3), nothing, kind))
                self.assertEqual(planes, [])
                self.assertTrue((labels == -1).all())

    def test_with_a_single_point(self):
        for method in ("ops", "fspf", "kht"):
            labels, planes = pcl_ops.segment(np.zeros((1, 3), np.float32), method)
            self.assertEqual((labels.tolist(), planes), ([-1], []))

    def test_numbers_beyond_single_precision(self):
        labels, planes = pcl_ops.segment(np.random.default_rng(1).normal(0, 1e300, (500, 3)))
        self.assertTrue((labels == -1).all())

    def test_equal_points(self):
        labels, planes = pcl_ops.segment(np.ones((5000, 3)))
        self.assertEqual(planes, [])


if __name__ == "__main__":
    unittest.main()
