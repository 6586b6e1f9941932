# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong is said by name, and nothing crashes."""

import unittest

import numpy as np
import pcl_ops
from scene import room

points = room()
labels = np.arange(len(points), dtype=np.int32) - 1


def segment(array=points, **arguments):
    return lambda: pcl_ops.segment(array, **arguments)


def evaluate(truth=labels, result=labels, **arguments):
    return lambda: pcl_ops.evaluate(truth, result, points, **arguments)


def call(function, *given, **arguments):
    return lambda: getattr(pcl_ops, function)(*given, **arguments)


# What is called, what it raises, and what that begins with.
table = [
    (segment(np.zeros((5, 4), np.float32)), ValueError, "points: shape (5, 4) is not (N, 3)"),
    (segment(np.zeros((0, 3), np.float32)), ValueError, "points: shape (0, 3)"),
    (segment(np.zeros((5, 3), int)), TypeError, "points: dtype int64"),
    (segment("room.pcd"), TypeError, "points: dtype <U8"),
    (segment(np.ma.masked_invalid(points)), TypeError, "points: a masked array"),
    (segment(method="ransac"), ValueError, "method: has to be one of ('ops', 'fspf', 'kht')"),
    (segment(method=3), TypeError, "method: has to be one of"),
    (segment(preset="fast"), ValueError, "preset: has to be one of ('default', 'paper'), not 'fast'"),
    (segment(viewpoint=(0, 0)), TypeError, "viewpoint: has to be three numbers (x, y, z)"),
    (segment(viewpoint=(0, 0, np.nan)), ValueError, "viewpoint: has to be finite"),
    (segment(smapling_rate=0.1), ValueError, "smapling_rate: unknown parameter; there are sampling, "),
    (segment(k=1), ValueError, "k: k must be 2 or more"),
    (segment(k=2.5), TypeError, "k: has to be int, not 2.5"),
    (segment(k=10**30), ValueError, "k: has to be int within its range, not 1000"),
    (segment(seed=-1), ValueError, "seed: has to be int within its range, not -1"),
    (segment(sampling_rate=np.nan), ValueError, "sampling_rate: the sampling rate must be"),
    (segment(sampling_rate=None), TypeError, "sampling_rate: has to be float, not None"),
    (segment(sampling_rate="ä" * 100), TypeError, "sampling_rate: has to be float, not 'äää"),
    (segment(sampling="point"), ValueError, "sampling: has to be Literal['points', 'surfels'], not 'point'"),
    (segment(sampling="points"), ValueError, "sampling: the distance threshold must be"),
    (segment(distance_threshold="x"), TypeError, "distance_threshold: has to be Optional[float]"),
    (segment(k=30, probability=1), ValueError, "probability: "),
    (segment(up=(0, 0, 0)), ValueError, "up: the up axis must be"),
    (segment(up=1.0), TypeError, "up: has to be three numbers (x, y, z), not 1.0"),
    (segment(up=(1, 2, "z")), TypeError, "up: has to be three numbers"),
    (segment(local_optimization=1.0), TypeError, "local_optimization: has to be bool, not 1.0"),
    (segment(merging_angle_threshold=9), ValueError, "merging_angle_threshold: the merging"),
    (segment(method="kht", clusters_min_samples=-1), ValueError, "clusters_min_samples: "),
    (call("merge_planes", [1]), TypeError, "planes: not a list of pcl_ops.Plane: [1]"),
    (call("merge_planes", None), TypeError, "planes: not a list of pcl_ops.Plane: None"),
    (call("merge_planes", [], up=(0, 0, 0)), ValueError, "up: the up axis must be"),
    (call("estimate_up_axis", [None]), TypeError, "planes: not a list"),
    (call("estimate_up_axis", [], min_share="x"), TypeError, "min_share: "),
    (call("estimate_up_axis", [], min_share=2), ValueError, "min_share: the least"),
    (call("match_planes", [1], []), TypeError, "previous: not a list of pcl_ops.Plane: [1]"),
    (call("match_planes", [], [], np.eye(3)), ValueError, "pose: is no"),
    (call("match_planes", [], [], np.full((4, 4), np.nan)), ValueError, "pose: is no"),
    (call("match_planes", [], [], np.diag([1, 1, -1, 1])), ValueError, "pose: is no"),
    (call("match_planes", [], [], min_overlap=2.0), ValueError, "min_overlap: "),
    (call("PlaneTracker", memory=-1), ValueError, "memory: "),
    (call("PlaneTracker", max_distance=-1), ValueError, "the largest distance must"),
    (lambda: pcl_ops.PlaneTracker().track([1]), TypeError, "planes: not a list"),
    (call("find_plane_edges", [], min_angle=9), ValueError, "min_angle: "),
    (call("find_plane_edges", [], reach="x"), TypeError, "reach: has to be Optional[float]"),
    (call("filter_planes", [], orientation="steep"), ValueError, "orientation: "),
    (call("filter_planes", [], direction=(0, 0, 0)), ValueError, "direction: "),
    (call("filter_planes", [], size=(1, 2)), TypeError, "size: has to be Optional[Tuple[float, "),
    (call("filter_planes", [], size=(1, -2, 0)), ValueError, "size: "),
    (call("filter_planes", [], min_points=-1), ValueError, "min_points: "),
    (evaluate(labels[:-1]), ValueError, "truth: shape (29599,) is not (29600,)"),
    (evaluate(result=labels.astype(float)), TypeError, "result: dtype float64"),
    (evaluate(labels.astype(np.uint64) + np.uint64(2**63)), ValueError, "truth: the label "),
    (evaluate(np.ma.masked_equal(labels, 1)), TypeError, "truth: a masked array"),
    (evaluate(labels + 1), ValueError, "truth: has the label 0 and no negative one; give none=0"),
    (evaluate(up=(0, 0, np.inf)), ValueError, "up: the up axis must be"),
]


class BadInput(unittest.TestCase):
    def test_is_said_by_name(self):
        for bad_call, error, beginning in table:
            with self.subTest(beginning):
                with self.assertRaises(error) as raised:
                    bad_call()
                self.assertTrue(str(raised.exception).startswith(beginning), raised.exception)

    def test_planes_of_different_arrays_and_those_that_share_points(self):
        planes = pcl_ops.segment(points)[1]
        others = pcl_ops.segment(points.copy())[1]
        for function in (pcl_ops.merge_planes, pcl_ops.find_plane_edges):
            with self.assertRaisesRegex(ValueError, "planes: .*different arrays"):
                function(planes + others)
        with self.assertRaisesRegex(ValueError, "planes: some share points"):
            pcl_ops.merge_planes(planes + planes[:1])

    def test_no_plane_is_an_answer_as_in_cpp(self):
        for nothing in (
            *(np.full((1000, 3), bad, kind) for bad in (np.nan, np.inf, -np.inf) for kind in "fd"),
            np.zeros((1, 3), np.float32),
            np.ones((5000, 3)),
            np.random.default_rng(1).normal(0, 1e300, (500, 3)),
        ):
            for method in ("ops", "fspf", "kht"):
                labels, planes = pcl_ops.segment(nothing, method)
                self.assertEqual((planes, set(labels.tolist())), ([], {-1}))
