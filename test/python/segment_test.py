# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls of segment and others: layouts of arrays in memory, warnings, errors that name the argument
that is wrong, and threads."""

import concurrent.futures
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np
import pcl_ops
from pcl_ops._arguments import points_array, single_precision
from scene import room, surface

points = room()
labels, planes = pcl_ops.segment(points)


def unaligned(points, number_type):
    """The points in an array whose numbers follow a byte each and so are at odd addresses."""
    record = np.zeros(len(points), [("intensity", "u1"), ("xyz", number_type, 3)])
    record["xyz"] = points
    return record["xyz"]


# Functions that return equal points in another layout in memory.
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
        for number, plane in enumerate(planes):
            np.testing.assert_array_equal(np.flatnonzero(labels == number), plane.inliers)
        self.assertEqual((labels.dtype, labels.shape), (np.int32, (len(points),)))
        self.assertEqual(set(labels[np.isnan(points[:, 0])]), {-1})
        for name, in_layout in layouts.items():
            with self.subTest(name):
                found_labels, found_planes = pcl_ops.segment(in_layout(points))
                np.testing.assert_array_equal(found_labels, labels)
                for plane, expected in zip(found_planes, planes):
                    np.testing.assert_allclose(plane.hull, expected.hull, atol=1e-6)

    def test_planes_with_fewer_points_than_the_minimum_are_left_out(self):
        smallest = len(planes) - 1
        found_labels, large_planes = pcl_ops.segment(
            points, min_points=len(planes[smallest].inliers) + 1)
        self.assertEqual(len(large_planes), smallest)
        np.testing.assert_array_equal(found_labels, np.where(labels == smallest, -1, labels))

    def test_a_fourth_number_of_each_point_has_no_effect(self):
        with_intensity = np.column_stack([points, np.full(len(points), 0.5, np.float32)])
        np.testing.assert_array_equal(pcl_ops.segment(with_intensity)[0], labels)

    def test_images_have_labels_of_their_shape(self):
        for width in (3, 4):
            image = np.zeros((100, len(points) // 100, width), np.float32)
            image[..., :3] = points.reshape(100, -1, 3)
            labels_of_image, planes_of_image = pcl_ops.segment(image)
            self.assertEqual(labels_of_image.shape, image.shape[:2])
            np.testing.assert_array_equal(labels_of_image.ravel(), labels)
            np.testing.assert_array_equal(planes_of_image[0].inliers, planes[0].inliers)
            metrics = pcl_ops.evaluate(labels_of_image, labels_of_image, image)
            self.assertEqual(metrics["f_score"], 1.0)

    def test_planes_of_two_calls_with_one_image_can_be_merged(self):
        image = points.reshape(100, -1, 3)
        of_both_calls = pcl_ops.segment(image)[1][:1] + pcl_ops.segment(image)[1][1:]
        self.assertEqual(len(pcl_ops.merge_planes(of_both_calls)[0]), 3)
        of_half_the_image = pcl_ops.segment(image[50:])[1]
        with self.assertRaisesRegex(ValueError, "different arrays"):
            pcl_ops.merge_planes(of_both_calls + of_half_the_image)


class Warnings(unittest.TestCase):
    def doubts(self, call):
        """The codes of the ResultWarnings of a call, and the result of the call."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = call()
        codes = [warning.message.code for warning in caught
                 if warning.category is pcl_ops.ResultWarning]
        return codes, result

    def test_there_are_none_for_an_ordinary_room(self):
        codes, (_, found) = self.doubts(lambda: pcl_ops.segment(points))
        self.assertEqual((codes, list(found.warnings)), ([], []))

    def test_say_that_an_array_looks_like_millimeters(self):
        codes, (_, found) = self.doubts(lambda: pcl_ops.segment(1000 * points))
        self.assertEqual(codes, ["millimeters"])
        self.assertEqual([doubt.code for doubt in found.warnings], ["millimeters"])
        self.assertRegex(str(found.warnings[0]), "give meter=1000 to plane_kinds and floor_plan")
        unpickled = pickle.loads(pickle.dumps(found.warnings[0]))
        self.assertEqual((unpickled.code, str(unpickled)),
                         ("millimeters", str(found.warnings[0])))

    def test_say_that_points_were_not_seen_from_a_viewpoint(self):
        # Four boards, one behind the other: the viewpoint in front of them sees the first alone.
        boards = np.vstack([surface((-1, depth, 0), (2, 0, 0), (0, 0, 2), 4000)
                            for depth in (1, 2, 3, 4)])
        shift = 5e5
        viewpoint = shift, shift - 1, shift + 1
        codes, (_, found) = self.doubts(
            lambda: pcl_ops.segment(boards + shift, viewpoint=viewpoint))
        self.assertEqual(codes, ["viewpoint"])
        self.assertRegex(str(found.warnings[0]), r"not seen from viewpoint=\(500000,499999,500001\)")
        self.assertEqual(self.doubts(lambda: pcl_ops.segment(boards))[0], [])

    def test_say_that_kinds_need_a_known_up_when_kinds_are_needed_first(self):
        # In the frame of a camera, z ahead and y down: a wall, and another one at 53 degrees to it.
        cloud = np.vstack([surface((-2, -1, 4), (4, 0, 0), (0, 2.5, 0), 10000),
                           surface((-2, -1, 2), (1.5, 0, 2), (0, 2.5, 0), 5000)])
        for call_with_kinds in (lambda found: found.kind, pcl_ops.floor_plan,
                                pcl_ops.buildings.rooms,
                                lambda found: pcl_ops.filter_planes(found, kind="wall")):
            _, (_, found) = self.doubts(lambda: pcl_ops.segment(cloud))
            codes, _ = self.doubts(lambda: call_with_kinds(found))
            self.assertEqual(codes[:1], ["unknown-up"])
            self.assertEqual(self.doubts(lambda: found.kind)[0], [], "not a second time")
        of_known_up = pcl_ops.segment(cloud, up=(0, -1, 0))[1]
        self.assertEqual(self.doubts(lambda: of_known_up.kind)[0], [])

    def test_say_that_x_and_y_of_an_array_look_like_degrees(self):
        degrees_per_meter = 1e-5  # roughly
        scale = (degrees_per_meter, degrees_per_meter, 1)
        wall = surface((0, 0, 0), (4, 0.1, 0), (0, 0, 2.5), 6000) * scale + (11, 48, 500)
        self.assertEqual(self.doubts(lambda: pcl_ops.segment(wall))[0], ["degrees"])

    def test_say_why_a_plan_has_no_wall(self):
        floor = surface((0, 0, 0), (4, 0, 0), (0, 3, 0), 12000)
        codes, _ = self.doubts(lambda: pcl_ops.floor_plan(pcl_ops.segment(floor)[1]))
        self.assertEqual(codes, ["empty-plan"])
        self.assertEqual(self.doubts(lambda: pcl_ops.floor_plan(planes))[0], [])


def level_grid(number, spacing, start, height):
    """number x number points on a horizontal plane, whose x and y begin at start [m]."""
    steps = start + spacing * np.arange(number)
    x_and_y = np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2)
    return np.column_stack([x_and_y, np.full(len(x_and_y), height)])


class Pieces(unittest.TestCase):
    def setUp(self):
        # Two table tops at the same height, 1.6 m apart, of 3600 and of 2400 points.
        top = level_grid(60, spacing=0.04, start=0.0, height=0.7)
        self.tables = np.concatenate([top, (top + [4.0, 0.0, 0.0])[:2400]])

    def test_of_one_plane_have_labels_of_their_own(self):
        self.assertEqual(len(pcl_ops.segment(self.tables)[1]), 1)
        labels, pieces = pcl_ops.segment(self.tables, pieces=True)
        self.assertEqual([len(piece.inliers) for piece in pieces], [3600, 2400])
        self.assertEqual([piece.lies_on for piece in pieces], [0, 0])
        np.testing.assert_array_equal(labels, np.repeat([0, 1], [3600, 2400]))
        self.assertEqual(pickle.loads(pickle.dumps(pieces[1])).lies_on, 0)

    def test_are_joined_over_gaps_up_to_a_number_of_spacings(self):
        self.assertEqual(len(pcl_ops.segment(self.tables, pieces=True, piece_gap=60)[1]), 1)
        with self.assertRaisesRegex(ValueError, "piece_gap"):
            pcl_ops.segment(self.tables, pieces=True, piece_gap=0.5)

    def test_far_from_zero_are_in_the_frame_of_the_array(self):
        far = self.tables + [5e5, 5e6, 0.0]
        pieces = pcl_ops.segment(far, pieces=True)[1]
        self.assertEqual(len(pieces), 2)
        np.testing.assert_allclose(pieces[1].centroid, far[3600:].mean(axis=0), atol=1e-4)


class NormalsWithoutASensor(unittest.TestCase):
    def test_point_up_on_a_floor_just_above_zero_just_below_and_far_away(self):
        floor = level_grid(100, spacing=0.04, start=-2.0, height=0.0)
        for shift in ([0, 0, 0.01], [0, 0, -0.01], [5e5, 5e6, 100.0]):
            with self.subTest(shift):
                found = pcl_ops.segment(floor + shift)[1]
                self.assertGreater(found[0].normal[2], 0.99)


class FarFromZero(unittest.TestCase):
    """The coordinates of surveys have up to seven digits before the point: planes are found, and
    described, to the millimeter nevertheless."""

    shift = np.array([498765.4321, 5412345.6789, 312.3456])

    @classmethod
    def setUpClass(cls):
        # In double precision, with digits that single precision does not have.
        cls.near = points + np.random.default_rng(5).uniform(-1e-9, 1e-9, points.shape)
        cls.near_labels, cls.near_planes = pcl_ops.segment(cls.near)
        cls.labels, cls.planes = pcl_ops.segment(cls.near + cls.shift, viewpoint=cls.shift)

    def test_planes_are_in_the_frame_of_the_array(self):
        self.assertGreater((self.labels == self.near_labels).mean(), 0.99)
        self.assertEqual(len(self.planes), 3)
        for plane, near in zip(self.planes, self.near_planes):
            np.testing.assert_allclose(plane.centroid - self.shift, near.centroid, atol=2e-3)
            np.testing.assert_allclose(plane.normal, near.normal, atol=1e-3)
            # At the shifted centroid the terms of the equation are up to 5,000 km.
            self.assertAlmostEqual(
                plane.coefficients @ np.append(self.shift + near.centroid, 1.0), 0.0, delta=1e-3)
            self.assertAlmostEqual(plane.rms, near.rms, delta=1e-4)
            self.assertAlmostEqual(plane.area, near.area, delta=0.01 * near.area)
            offsets = (plane.hull - plane.centroid) @ plane.normal
            self.assertLess(np.abs(offsets).max(), 1e-6)

    def test_an_outlier_makes_planes_no_less_exact(self):
        cloud = self.near + self.shift
        cloud[0] = 1e9, -1e9, 1e9
        found_labels, found_planes = pcl_ops.segment(cloud, viewpoint=self.shift)
        self.assertEqual((found_labels[0], len(found_planes)), (-1, 3))
        self.assertLess(found_planes[0].rms, 0.003)  # the noise is 0.002

    def test_merged_planes_are_in_the_frame_of_the_array(self):
        found = pcl_ops.segment(
            self.near + self.shift, viewpoint=self.shift, merging_enabled=False)[1]
        for plane, near in zip(pcl_ops.merge_planes(found)[0], self.near_planes):
            np.testing.assert_allclose(plane.centroid - self.shift, near.centroid, atol=0.01)
            self.assertAlmostEqual(plane.area, near.area, delta=0.01 * near.area)


class Memory(unittest.TestCase):
    def test_is_not_copied_if_x_y_z_are_neighbors_and_rows_ascend(self):
        wide = np.zeros((100, 9), np.float32)
        for array in (wide[:, :3], wide[:, 2:5], wide[::2, :3], wide[:, 6:].copy()):
            self.assertIs(single_precision(points_array(array))[0], array)
        for array in (wide[::-1, :3], wide[:, 2::-1], wide[:, ::3], wide[:, :3].astype(">f4"),
                      wide[:, :3].astype(np.float64)):
            self.assertFalse(np.shares_memory(single_precision(points_array(array))[0], array))


def segment(array=points, **parameters):
    """A function without arguments that calls pcl_ops.segment."""
    return lambda: pcl_ops.segment(array, **parameters)


def evaluate(truth=labels, result=labels, **options):
    """A function without arguments that calls pcl_ops.evaluate."""
    return lambda: pcl_ops.evaluate(truth, result, points, **options)


def call(function, *arguments, **options):
    """A function without arguments that calls the function of pcl_ops with this name."""
    return lambda: getattr(pcl_ops, function)(*arguments, **options)


# Calls with a wrong argument, the error that each raises, and the beginning of its text.
bad_calls = [
    (segment(np.zeros((5, 2), np.float32)), ValueError, "points: shape (5, 2) is none of (N, 3), "),
    (segment(np.zeros((5, 6), np.float32)), ValueError,
     "points: shape (5, 6) is none of (N, 3), (N, 4), (H, W, 3) and (H, W, 4); give points[..., :3]"),
    (segment(np.zeros((3, 5), np.float32)), ValueError,
     "points: shape (3, 5) is none of (N, 3), (N, 4), (H, W, 3) and (H, W, 4); give points.T"),
    (segment(np.zeros((0, 3), np.float32)), ValueError, "points: shape (0, 3)"),
    (segment(np.zeros((5, 3), int)), TypeError, "points: dtype int64"),
    (segment("room.pcd"), TypeError, "points: dtype <U8"),
    (segment(np.ma.masked_invalid(points)), TypeError, "points: a masked array"),
    (segment(method="ransac"), ValueError, "method: has to be one of ('ops', 'fspf', 'kht')"),
    (segment(method=3), TypeError, "method: has to be one of"),
    (segment(preset="fast"), ValueError, "preset: has to be one of ('default', 'paper'), not 'fast'"),
    (segment(viewpoint=(0, 0)), TypeError, "viewpoint: has to be three numbers (x, y, z)"),
    (segment(viewpoint=(0, 0, np.nan)), ValueError, "viewpoint: has to be finite"),
    (segment(smapling_rate=0.1), ValueError,
     "smapling_rate: unknown parameter; did you mean sampling_rate?"),
    (segment(k=1), ValueError, "k: k must be 2 or more"),
    (segment(k=2.5), TypeError, "k: has to be int, not 2.5"),
    (segment(k=10**30), ValueError, "k: has to be int within its range, not 1000"),
    (segment(seed=-1), ValueError, "seed: has to be int within its range, not -1"),
    (segment(sampling_rate=np.nan), ValueError, "sampling_rate: the sampling rate must be"),
    (segment(sampling_rate=None), TypeError, "sampling_rate: has to be float, not None"),
    (segment(sampling_rate="ä" * 100), TypeError, "sampling_rate: has to be float, not 'äää"),
    (segment(sampling="point"), ValueError,
     "sampling: has to be Literal['points', 'surfels', 'neighborhoods', 'automatic'], not 'point'"),
    (segment(sampling="points"), ValueError, "sampling: the distance threshold must be"),
    (segment(distance_threshold="x"), TypeError, "distance_threshold: has to be Optional[float]"),
    (segment(k=30, probability=1), ValueError, "probability: "),
    (segment(up=(0, 0, 0)), ValueError, "up: the up axis must be"),
    (segment(up=1.0), TypeError,
     "up: has to be three numbers (x, y, z), 'camera' or, for segment, 'auto', not 1.0"),
    (segment(up="y"), TypeError,
     "up: has to be three numbers (x, y, z), 'camera' or, for segment, 'auto', not 'y'"),
    (call("filter_planes", [], up="auto"), TypeError, "up: has to be three numbers (x, y, z), "),
    (lambda: planes[0].distances(np.zeros((5, 2))), ValueError, "points: shape (5, 2) is none of"),
    (lambda: planes[0].as_dict(up="auto"), TypeError, "up: has to be three numbers (x, y, z)"),
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
    (call("PlaneTracker", max_distance=-1), ValueError, "max_distance: has to be a length above 0"),
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
    (evaluate(none="x"), TypeError, "none: has to be a label or None, not 'x'"),
    (evaluate(none=5.5), TypeError, "none: has to be a label or None, not 5.5"),
    (segment(piece_gap="a"), TypeError, "piece_gap: has to be a number of spacings from 1, not 'a'"),
    (segment(pieces="no"), TypeError, "pieces: has to be True or False, not 'no'"),
    (segment(k=True), TypeError, "k: has to be int, not True"),
    (call("filter_planes", [], kind=3), TypeError, "kind: has to be one or several of floor, "),
    (call("plane_kinds", planes, meter=True), TypeError, "meter: has to be a length above 0, not True"),
    (call("plane_kinds", planes, meter=np.nan), ValueError, "meter: has to be a length above 0, not nan"),
    (call("plane_kinds", planes, up="z"), TypeError,
     "up: has to be three numbers (x, y, z) or 'camera', not 'z'"),
    (call("PlaneTracker", memory=2**70), ValueError, "memory: has to be a number of frames or None"),
    (call("PlaneTracker", memory=3.0), TypeError, "memory: has to be a number of frames or None"),
    (call("PlaneTracker", max_distance="a"), TypeError, "max_distance: has to be a length above 0 or None"),
    (evaluate(up=(0, 0, np.inf)), ValueError, "up: the up axis must be"),
]


class WrongArguments(unittest.TestCase):
    def test_are_named_by_the_error(self):
        for bad_call, error, beginning in bad_calls:
            with self.subTest(beginning):
                with self.assertRaises(error) as raised:
                    bad_call()
                self.assertTrue(str(raised.exception).startswith(beginning), raised.exception)

    def test_are_not_the_number_types_of_numpy(self):
        for number_type in (np.float32, np.float64, np.int8, np.int64):
            self.assertEqual(pcl_ops.plane_kinds(planes, meter=number_type(1)),
                             pcl_ops.plane_kinds(planes))
            planes[0].concave_outline(number_type(0))
            pcl_ops.segment(points, pieces=np.bool_(True), piece_gap=number_type(8))
            pcl_ops.PlaneTracker(max_distance=number_type(9))
        for integer_type in (np.uint8, np.int64):
            pcl_ops.PlaneTracker(memory=integer_type(3))
            pcl_ops.evaluate(labels, labels, points, none=integer_type(0))
            with tempfile.TemporaryDirectory() as folder:
                pcl_ops.write_html(f"{folder}/a.html", points, labels, planes,
                                   max_points=integer_type(100))

    def test_are_planes_of_different_arrays_and_planes_that_share_points(self):
        of_another_array = pcl_ops.segment(points.copy())[1]
        for function in (pcl_ops.merge_planes, pcl_ops.find_plane_edges):
            with self.assertRaisesRegex(ValueError, "planes: .*different arrays"):
                function(planes + of_another_array)
        with self.assertRaisesRegex(ValueError, "planes: some share points"):
            pcl_ops.merge_planes(planes + planes[:1])

    def test_are_not_points_without_a_plane(self):
        not_finite = [np.full((1000, 3), value, dtype)
                      for value in (np.nan, np.inf, -np.inf) for dtype in (np.float32, np.float64)]
        for cloud in (
            *not_finite,
            np.zeros((1, 3), np.float32),
            np.ones((5000, 3)),
            np.random.default_rng(1).normal(0, 1e300, (500, 3)),
        ):
            for method in ("ops", "fspf", "kht"):
                no_labels, no_planes = pcl_ops.segment(cloud, method)
                self.assertEqual((no_planes, set(no_labels.tolist())), ([], {-1}))


def large_cloud(dtype):
    """So many points that a call takes some tenths of a second."""
    many = np.tile(points, (20, 1)).astype(dtype)
    return many + np.random.default_rng(1).normal(0, 0.002, many.shape).astype(dtype)


def ticks_during(call):
    """How often another thread of Python ran during a call."""
    times_of_ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(timeout=0.001):  # [s]
            times_of_ticks.append(time.perf_counter())

    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        pool.submit(tick)
        begin = time.perf_counter()
        try:
            call()
            end = time.perf_counter()
        finally:
            done.set()  # else the pool would wait for ever
    return sum(begin < time_of_tick < end for time_of_tick in times_of_ticks)


class Threads(unittest.TestCase):
    def test_other_threads_work_during_segment_and_evaluate(self):
        truth = pcl_ops.segment(large_cloud(np.float32))[0]
        for dtype in (np.float32, np.float64):
            cloud = large_cloud(dtype)
            for call in (*(lambda method=method: pcl_ops.segment(cloud, method)
                           for method in ("ops", "fspf", "kht")),
                         lambda: pcl_ops.evaluate(truth, truth, cloud)):
                # If a call held the interpreter, the other thread could run only when the call
                # begins and ends. On a busy machine that thread may run seldom in any case:
                # hence 20 tries.
                self.assertTrue(any(ticks_during(call) > 5 for _ in range(20)))

    def test_that_call_at_once_get_the_same_labels(self):
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for found_labels, _ in pool.map(lambda _: pcl_ops.segment(points), range(20)):
                np.testing.assert_array_equal(found_labels, labels)

    def test_that_are_in_a_call_when_python_ends_cause_no_error(self):
        script = """
import threading, time
import pcl_ops
from scene import room, surface
points = room()
def work():
    while True:
        pcl_ops.segment(points.astype("f8") + 0.1, "fspf")
        pcl_ops.evaluate(labels, labels, points)
labels = pcl_ops.segment(points)[0]
for _ in range(2):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.2)
"""
        here = os.path.dirname(os.path.abspath(__file__))
        for _ in range(5):  # runs, as an error would not come in each
            run = subprocess.run([sys.executable, "-B", "-c", script], cwd=here, capture_output=True)
            self.assertEqual((run.returncode, run.stderr), (0, b""))

    def test_are_interrupted_after_a_call_if_not_in_it(self):
        cloud = large_cloud(np.float32)
        seconds_until_interruption = 0.02
        with self.assertRaises(KeyboardInterrupt):
            threading.Timer(seconds_until_interruption, os.kill,
                            (os.getpid(), signal.SIGINT)).start()
            pcl_ops.segment(cloud)
            time.sleep(10)  # [s]; on a fast machine the signal comes only here
