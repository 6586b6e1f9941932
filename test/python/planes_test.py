# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of planes, the up axis by planes, edges, merging, filters, matching and tracking,
and files of planes."""

import copy
import json
import os
import pathlib
import pickle
import shutil
import sqlite3
import struct
import subprocess
import tempfile
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor
from unittest import mock

import numpy as np
import pcl_ops
from scene import room, seen_from, surface, turned_pose

viewpoint = np.array([3.5, 0.3, 1.5])
points = room()
planes = pcl_ops.segment(points, viewpoint=viewpoint)[1]
floor, wall, side = planes  # of 12, 10 and 7.5 m^2


class Planes(unittest.TestCase):
    def test_have_normals_towards_the_viewpoint(self):
        below = pcl_ops.segment(points, viewpoint=(2, 1.5, -9), up=(0, 0, 1))[1]
        np.testing.assert_allclose(floor.normal, (0, 0, 1), atol=0.01)
        np.testing.assert_allclose(below[0].normal, (0, 0, -1), atol=0.01)

    def test_independent_covariance_is_that_of_a_least_squares_fit_of_heights_over_the_axes(self):
        for plane in planes:
            local = points[plane.inliers] - plane.centroid
            rows = np.column_stack([local @ plane.axes.T, np.ones(len(local))])
            variance = plane.rms**2 * len(local) / (len(local) - 3)
            expected = variance * np.linalg.inv(rows.T @ rows)
            np.testing.assert_allclose(plane.independent_covariance, expected, rtol=1e-3, atol=1e-15)
            np.testing.assert_allclose(np.cross(*plane.axes), plane.normal, atol=1e-12)

    def test_covariance_knows_noise_that_neighbors_share(self):
        rng = np.random.default_rng(1)
        x_and_y = np.mgrid[0:100, 0:100].reshape(2, -1) * 0.02 + 1e6
        # Blocks of width x width points have the same error. The variances of the plane grow by
        # the number of points in a block, 1 or 100, over those for independent errors.
        for width, min_ratio, max_ratio in ((1, 0.5, 10.0), (10, 50.0, 1000.0)):
            noise = rng.normal(0.0, 0.01, (100 // width, 100 // width)).repeat(width, 0)
            noisy = np.column_stack([*x_and_y, noise.repeat(width, 1).ravel()])
            # Without the threshold each block would be a plane.
            plane = pcl_ops.segment(noisy, distance_threshold=0.05)[1][0]
            ratio = np.diag(plane.covariance) / np.diag(plane.independent_covariance)
            self.assertTrue((ratio > min_ratio).all() and (ratio < max_ratio).all(), ratio)

    def test_come_with_the_lengths_that_were_used(self):
        self.assertIsNone(planes.voxel_size)  # neighborhoods have none
        self.assertGreater(planes.distance_threshold, max(plane.rms for plane in planes))
        given = pcl_ops.segment(
            points, surfels_voxel_size=0.1, distance_threshold=0.001)[1]
        self.assertEqual(given.voxel_size, 0.1)
        self.assertAlmostEqual(given.distance_threshold, 0.001)
        kht = pcl_ops.segment(points, "kht", distance_threshold=0.04)[1]
        self.assertEqual((kht.voxel_size, kht.distance_threshold), (None, 0.04))

    def test_know_the_noise_around_them(self):
        for plane in planes:
            self.assertTrue(plane.rms / 2 < plane.noise < 2 * plane.rms, plane.noise)
        self.assertIsNone(pcl_ops.segment(points, "kht")[1][0].noise)
        unmerged = pcl_ops.merge_planes(planes, enabled=False)[0]
        self.assertEqual([plane.noise for plane in unmerged], [plane.noise for plane in planes])

    def test_distances_are_signed_and_those_of_any_points(self):
        above = np.float32([[1, 1, 0.5], [1, 1, -0.25], [np.nan, 1, 1]])
        np.testing.assert_allclose(floor.distances(above), [0.5, -0.25, np.nan], atol=0.003)
        self.assertEqual(floor.distances(np.zeros((2, 5, 3))).shape, (2, 5))
        on_floor = floor.distances(points[floor.inliers])
        self.assertAlmostEqual(np.sqrt(np.mean(on_floor**2)), floor.rms, places=6)

    def test_distances_far_from_zero_keep_their_digits(self):
        far = np.array([5e5, 5.4e6, 300.0])
        plane = pcl_ops.segment(points + far, viewpoint=viewpoint + far)[1][0]
        self.assertAlmostEqual(plane.distances(far + [[1, 1, 0.5]])[0], 0.5, delta=0.003)

    def test_concave_outlines_have_the_windows_of_walls_as_holes(self):
        facade = surface((0, 0, 0), (3, 0, 0), (0, 0, 2.5), 40000)
        in_window = (abs(facade[:, 0] - 1.5) < 0.5) & (abs(facade[:, 2] - 1.2) < 0.4)
        for shift in (np.zeros(3), np.array([5e5, 5.4e6, 300.0])):
            plane = pcl_ops.segment(facade[~in_window] + shift, viewpoint=shift - (0, 9, 0))[1][0]
            rings, area = plane.concave_outline()
            self.assertEqual(len(rings), 2)
            self.assertAlmostEqual(area, 7.5 - 0.8, delta=0.15)
            self.assertAlmostEqual(plane.area, 7.5, delta=0.1)
            np.testing.assert_allclose(rings[1].mean(axis=0) - shift, (1.5, 0, 1.2), atol=0.1)
        self.assertEqual(plane.concave_outline(alpha=50.0)[0][1:], [])
        with self.assertRaisesRegex(ValueError, "^alpha: has to be a length or 0, not -1"):
            plane.concave_outline(-1)

    def test_are_rows_of_a_table(self):
        row = floor.as_dict()
        self.assertEqual((row["orientation"], row["points"]), ("horizontal", len(floor.inliers)))
        self.assertEqual([row[name] for name in "abcd"], floor.coefficients.tolist())
        self.assertAlmostEqual(wall.as_dict()["slope"], 90.0, delta=0.5)
        self.assertAlmostEqual(wall.as_dict()["aspect"], 180.0, delta=0.5)
        self.assertAlmostEqual(wall.as_dict(up=(0, 2, 0))["slope"], 0.0, delta=0.5)
        self.assertIsNone(wall.as_dict(up=(0, 2, 0))["aspect"])
        columns = planes.as_dict()
        self.assertEqual(columns["area"], [plane.area for plane in planes])
        self.assertEqual(list(columns), list(row))
        self.assertEqual(pcl_ops.FoundPlanes().as_dict(), {name: [] for name in row})

    def test_are_no_ceilings_below_the_sensor(self):
        street = surface((0, 0, -2), (9, 0, 0), (0, 9, 0), 20000)
        pit = surface((0, -5, -4.5), (4, 0, 0), (0, 4, 0), 4000)
        # Both clouds are found with the default viewpoint (0, 0, 0), 2 m above the street: from
        # there the pit is seen, but the river is not. plane_kinds believes a given viewpoint;
        # without one the sensor is unknown, and a plane above another may be a ceiling.
        found = pcl_ops.segment(np.vstack([street, pit]))[1]
        self.assertEqual(found[0].kind, "floor")
        self.assertEqual(pcl_ops.plane_kinds(found, viewpoint=(0, 0, 0))[0], "floor")
        self.assertEqual(pcl_ops.plane_kinds(found)[0], "floor", "nothing is below it")
        river = surface((0, 0, -4.5), (9, 0, 0), (0, 9, 0), 20000)
        bridge = pcl_ops.segment(np.vstack([street, river]))[1]
        upper = max(range(len(bridge)), key=lambda i: bridge[i].centroid[2])
        self.assertEqual(pcl_ops.plane_kinds(bridge)[upper], "ceiling", "from where is not known")
        self.assertNotEqual(pcl_ops.plane_kinds(bridge, viewpoint=(0, 0, 0))[upper], "ceiling")

    def test_have_kinds_by_all_planes_of_the_cloud(self):
        self.assertEqual([plane.kind for plane in planes], ["floor", "wall", "wall"])
        self.assertEqual(floor.as_dict()["kind"], "floor")
        self.assertEqual(pickle.loads(pickle.dumps(wall)).kind, "wall")
        self.assertEqual(pcl_ops.plane_kinds(planes, up=(0, 0, 2)), ["floor", "wall", "wall"])
        self.assertEqual(pcl_ops.plane_kinds(planes, meter=100.0), ["floor", "other", "other"],
                         "of a room of centimeters")
        self.assertEqual(pcl_ops.plane_kinds([]), [])
        for wrong, name in (({"meter": 0}, "meter"), ({"up": (0, 0, 0)}, "up")):
            with self.assertRaisesRegex(ValueError, "^" + name):
                pcl_ops.plane_kinds(planes, **wrong)

    def test_keep_their_kinds_where_the_list_changes(self):
        expected = [plane.kind for plane in pcl_ops.segment(points)[1]]
        changed = pcl_ops.segment(points)[1]
        removed = changed.pop(2)
        changed.clear()
        # Kinds are found when the first one is asked for, here after the changes.
        self.assertEqual(removed.kind, expected[2])

    def test_of_a_room_make_a_floor_plan(self):
        door = (1.0, 1.9)
        length, height = 4.0, 2.5
        cloud = [surface((0, 0, 0), (length, 0, 0), (0, 3, 0), 12000, seed=1),
                 surface((0, 0, height), (length, 0, 0), (0, 3, 0), 12000, seed=2),
                 surface((0, 3, 0), (length, 0, 0), (0, 0, height), 10000, seed=3),
                 surface((0, 0, 0), (0, 3, 0), (0, 0, height), 7500, seed=4),
                 surface((length, 0, 0), (0, 3, 0), (0, 0, height), 7500, seed=5)]
        front = surface((0, 0, 0), (length, 0, 0), (0, 0, height), 10000, seed=6)
        is_door = (front[:, 0] > door[0]) & (front[:, 0] < door[1]) & (front[:, 2] < 2.0)
        points = np.vstack([*cloud, front[~is_door]]) + [500000.0, 5400000.0, 100.0]
        room = pcl_ops.segment(points, viewpoint=(500002.0, 5400001.5, 101.5))[1]
        plan = pcl_ops.floor_plan(room)
        (only,) = plan.rooms
        self.assertAlmostEqual(only.area, 12.0, delta=0.05)
        self.assertAlmostEqual(only.ceiling - only.floor, height, delta=0.01)
        default_cut_height = 1.2
        self.assertAlmostEqual(plan.height - plan.floor, default_cut_height, delta=0.01)
        self.assertEqual(only.rings[0].shape, (4, 2))
        np.testing.assert_allclose(only.rings[0].min(axis=0), [500000.0, 5400000.0], atol=0.02)
        np.testing.assert_allclose(only.middle, [500002.0, 5400001.5], atol=0.02)
        self.assertEqual(len(plan.walls), 4)
        for wall in plan.walls:
            self.assertEqual({room[i].kind for i in wall.planes}, {"wall"})
            self.assertIsNone(wall.thickness)
        (gap,) = [one for wall in plan.walls for one in wall.openings]
        self.assertAlmostEqual(np.linalg.norm(gap.end - gap.start), 0.9, delta=0.05)
        self.assertAlmostEqual(gap.head, 2.0, delta=0.1)
        self.assertIsNone(gap.sill)
        self.assertEqual((gap.is_door, gap.rooms), (True, (0, None)), "it leads out")
        self.assertEqual((only.doors_to, only.unseen), ((), []))
        millimeters = pcl_ops.segment(
            1000.0 * points, viewpoint=(500002000.0, 5400001500.0, 101500.0))[1]
        plan = pcl_ops.floor_plan(millimeters, meter=1000.0)
        self.assertAlmostEqual(plan.rooms[0].area, 12.0, delta=0.05)
        np.testing.assert_allclose(plan.rooms[0].middle, [500002.0, 5400001.5], atol=0.02)

    def test_of_a_room_without_one_of_its_walls_say_where_it_would_be(self):
        walls = [((0, 0, 0), (4, 0, 0)), ((0, 3, 0), (4, 0, 0)), ((0, 0, 0), (0, 3, 0))]
        points = np.vstack([surface((0, 0, 0), (4, 0, 0), (0, 3, 0), 12000, seed=1)] + [
            surface(start, along, (0, 0, 2.5), int(2500 * np.linalg.norm(along)), seed=seed)
            for seed, (start, along) in enumerate(walls, 2)])
        (room,) = pcl_ops.floor_plan(pcl_ops.segment(points, viewpoint=(2, 1.5, 1.2))[1]).rooms
        (ends,) = room.unseen
        np.testing.assert_allclose(ends, [[4, 0], [4, 3]], atol=0.05)
        self.assertAlmostEqual(room.area, 12.0, delta=0.1)

    def test_a_floor_plan_takes_parameters_and_refuses_wrong_ones(self):
        self.assertEqual(pcl_ops.floor_plan(planes, min_room=100.0).rooms, [])
        self.assertEqual(pcl_ops.floor_plan([])[:2], ([], []))
        for wrong in ({"up": (0, 0, 0)}, {"min_room": 0.0}, {"max_snap": -1.0}, {"meter": 0.0}):
            with self.assertRaises(ValueError):
                pcl_ops.floor_plan(planes, **wrong)

    def test_calls_for_buildings_are_also_in_a_module_of_their_own(self):
        buildings = pcl_ops.buildings
        self.assertEqual(buildings.kinds(planes, up=(0, 0, 2)), ["floor", "wall", "wall"])
        self.assertIs(buildings.floor_plan, pcl_ops.floor_plan)
        self.assertIs(buildings.regularize_planes, pcl_ops.regularize_planes)
        for name in buildings.__all__:
            self.assertTrue(getattr(buildings, name).__doc__, name)

    def test_of_two_rooms_make_both_by_falling_area(self):
        def room_at(x, width):
            """Points of the floor, the ceiling and the four walls."""
            return [*(surface((x, 0, z), (width, 0, 0), (0, 3, 0), 9000) for z in (0, 2.5)),
                    *(surface((x, y, 0), (width, 0, 0), (0, 0, 2.5), 8000) for y in (0, 3)),
                    *(surface((end, 0, 0), (0, 3, 0), (0, 0, 2.5), 7000) for end in (x, x + width))]
        found = pcl_ops.segment(np.vstack([*room_at(0, 3), *room_at(3.2, 4)]))[1]
        large, small = pcl_ops.buildings.rooms(found)
        self.assertAlmostEqual(large.area, 12.0, delta=0.1)
        self.assertAlmostEqual(small.area, 9.0, delta=0.1)
        self.assertEqual(len(pcl_ops.buildings.rooms(found, min_room=10.0)), 1)
        with self.assertRaises(ValueError):
            pcl_ops.buildings.rooms(found, meter=0.0)

    def test_are_regularized_to_exact_angles(self):
        exact, moves = pcl_ops.regularize_planes(planes)
        for one, other in ((0, 1), (0, 2), (1, 2)):
            self.assertAlmostEqual(float(exact[one].normal @ exact[other].normal), 0.0, delta=1e-12)
        self.assertEqual([plane.kind for plane in exact], ["floor", "wall", "wall"])
        self.assertEqual(len({move.direction for move in moves}), 3)
        for move in moves:
            self.assertLess(move.angle, np.radians(0.5))
        with self.assertRaisesRegex(ValueError, "^max_angle: "):
            pcl_ops.regularize_planes(planes, max_angle=2.0)

    def test_inliers_are_read_only_and_outlive_their_plane(self):
        inliers = pcl_ops.segment(points)[1][0].inliers
        np.testing.assert_array_equal(inliers, floor.inliers)
        with self.assertRaises(ValueError):
            inliers[0] = 10**6

    def test_print_in_a_line_and_pickle_with_one_array_for_all(self):
        self.assertRegex(repr(floor), r"<pcl_ops.Plane: horizontal(, floor)?, \d+ points, rms 0.00\d+>")
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            copies = pickle.loads(pickle.dumps(planes, protocol))
            for plane, original in zip(copies, planes):
                for name in ("coefficients", "inliers", "hull", "covariance", "noise"):
                    np.testing.assert_array_equal(getattr(plane, name), getattr(original, name))
                self.assertEqual(repr(plane), repr(original))
        self.assertEqual(len(pcl_ops.merge_planes(copies)[0]), 3)
        self.assertLess(len(pickle.dumps(planes)), 2 * points.nbytes)


class Maps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def features(self, some, **given):
        pcl_ops.write_planes(self.folder / "map.geojson", some, **given)
        return json.loads((self.folder / "map.geojson").read_text())["features"]

    def test_rings_are_closed_and_counter_clockwise_from_above(self):
        below = pcl_ops.segment(points, viewpoint=(2, 1.5, -9), up=(0, 0, 1))[1][:1]
        for some in ([floor], below):
            ring = np.array(self.features(some)[0]["geometry"]["coordinates"][0])
            self.assertEqual(ring[0].tolist(), ring[-1].tolist())
            x, y = ring[:, :2].T
            self.assertAlmostEqual(0.5 * (x[:-1] @ y[1:] - y[:-1] @ x[1:]), floor.area, delta=0.05)

    def test_concave_outlines_come_with_their_holes_clockwise_and_areas(self):
        ground = surface((0, 0, 0), (3, 0, 0), (0, 2.5, 0), 40000)
        around = ground[np.abs(ground[:, :2] - (1.5, 1.2)).max(axis=1) > 0.4]
        some = pcl_ops.segment(around, viewpoint=(0, 0, 9))[1]
        feature = self.features(some, hull="concave")[0]
        areas = []
        for ring in map(np.array, feature["geometry"]["coordinates"]):
            x, y = ring[:, :2].T
            areas.append(0.5 * (x[:-1] @ y[1:] - y[:-1] @ x[1:]))
        np.testing.assert_allclose(areas, [7.5, -0.64], atol=0.15)
        self.assertAlmostEqual(feature["properties"]["area"], sum(areas), delta=0.01)

    def test_ids_are_the_labels(self):
        self.assertEqual([one["id"] for one in self.features(planes)], [1, 2, 3])
        self.assertEqual([one["properties"]["id"] for one in self.features(planes, labels=[7, 9, 8])],
                         [7, 9, 8])

    def test_up_is_that_of_the_list_unless_given(self):
        found = pcl_ops.segment(points, up="camera")[1]
        self.assertAlmostEqual(self.features(found)[0]["properties"]["slope"], 90.0, delta=0.5)
        slope = self.features(found, up=(0, 0, 1))[0]["properties"]["slope"]
        self.assertAlmostEqual(slope, 0.0, delta=0.5)

    def test_no_planes_are_a_map_and_a_table(self):
        self.assertEqual(self.features([]), [])
        pcl_ops.write_planes(self.folder / "map.csv", [])
        self.assertRegex((self.folder / "map.csv").read_text(), "^id,orientation,.*,height,wkt\n$")

    def test_pieces_have_the_number_of_their_plane(self):
        # Two table tops at the same height, 1.6 m apart, and a wall.
        grid = np.stack(np.meshgrid(np.arange(60), np.arange(60)), -1).reshape(-1, 2) * 0.04
        top = np.column_stack([grid, np.full(len(grid), 0.7)])
        wall = np.column_stack([grid[:, 0], np.full(len(grid), -3.0), grid[:, 1]])
        scene = np.vstack([top, top + [4.0, 0.0, 0.0], wall])
        pieces = pcl_ops.segment(scene, pieces=True)[1]
        numbers = [piece.lies_on + 1 for piece in pieces]
        self.assertEqual(sorted(numbers), [1, 1, 2])
        self.assertEqual([one["properties"]["plane"] for one in self.features(pieces)], numbers)
        pcl_ops.write_planes(self.folder / "map.json", pieces)
        listed = json.loads((self.folder / "map.json").read_text())["planes"]
        self.assertEqual([one["plane"] for one in listed], numbers)
        pcl_ops.write_planes(self.folder / "map.csv", pieces)
        header, *rows = (self.folder / "map.csv").read_text().splitlines()
        self.assertTrue(header.startswith("id,plane,orientation,"))
        self.assertEqual([int(row.split(",")[1]) for row in rows], numbers)

    def test_what_does_not_fit_is_refused_and_leaves_files_as_they_are(self):
        (self.folder / "map.csv").write_text("mine")
        os.mkfifo(self.folder / "pipe.csv")
        for name, some, given, error, said in (
            ("pipe.csv", planes, {}, OSError, "pipe.csv: is no regular file"),
            ("map.png", planes, {}, ValueError, "map.png: has an unknown extension"),
            ("map.csv", planes, {"crs": "EPSG:25832"}, ValueError, "crs: is about a .geojson"),
            ("map.geojson", planes, {"crs": "25832"}, ValueError, "crs: has to be as 'EPSG:25832'"),
            ("map.csv", planes, {"labels": [1]}, ValueError,
             r"labels: shape \(1,\) is not \(3,\), that of the planes"),
            ("map.csv", planes, {"labels": [1.5, 2, 3]}, TypeError,
             "labels: dtype float64 is not one of"),
            ("map.csv", planes, {"labels": [7, 8, 7]}, ValueError, "labels: 7 is there twice"),
            ("map.csv", planes, {"labels": [0, 1, -2]}, ValueError,
             "labels: have to be 0 or more, not -2"),
            ("map.csv", planes, {"labels": np.uint64([0, 1, 2**63])}, ValueError,
             r"labels: have to be below 2\^63, not 9223372036854775808"),
            ("map.csv", planes, {"hull": "round"}, ValueError, "hull: has to be 'convex' or"),
            ("map.csv", [1], {}, TypeError, "planes: not a list"),
            ("none/map.csv", planes, {}, OSError,
             "none/map.csv: its folder does not exist; create it"),
            ("map.csv\0.json", planes, {}, ValueError, "path: .* has a NUL"),
            (os.fsdecode(b"W\xe4nde/map.csv"), planes, {}, OSError, "its folder does not exist"),
        ):
            with self.subTest(said), self.assertRaisesRegex(error, said):
                pcl_ops.write_planes(self.folder / name, some, **given)
        self.assertEqual(sorted(one.name for one in self.folder.iterdir()), ["map.csv", "pipe.csv"])
        self.assertEqual((self.folder / "map.csv").read_text(), "mine")
        self.assertTrue((self.folder / "pipe.csv").is_fifo())


class UpAxis(unittest.TestCase):
    def test_of_a_room_is_found_in_any_frame(self):
        tilt = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], np.float32)
        tilted = pcl_ops.segment(points @ tilt.T, viewpoint=tilt @ viewpoint, up=(0, 0, 1))[1]
        direction, confidence = pcl_ops.estimate_up_axis(tilted, tilt @ viewpoint)
        np.testing.assert_allclose(direction, tilt @ (0, 0, 1), atol=0.01)
        self.assertTrue(0.7 <= confidence <= 1.0)

    def test_auto_names_planes_by_it_and_says_how_sure_it_is(self):
        tilt = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], np.float32)
        found = pcl_ops.segment(points @ tilt.T, viewpoint=tilt @ viewpoint, up="auto")[1]
        self.assertEqual([plane.orientation for plane in found],
                         ["horizontal", "vertical", "vertical"])
        np.testing.assert_allclose(found.up, tilt @ (0, 0, 1), atol=0.01)
        self.assertTrue(0.7 <= found.up_confidence <= 1.0)
        np.testing.assert_allclose(found.as_dict()["slope"], [0, 90, 90], atol=1.0)

    def test_auto_warns_where_the_planes_cannot_tell(self):
        with self.assertWarnsRegex(UserWarning, r"^up: the planes cannot tell, \(0, 0, 1\) is used"):
            found = pcl_ops.segment(points[:6000] * (1, 1, 0), up="auto")[1]
        self.assertEqual((found.up, found.up_confidence), ((0.0, 0.0, 1.0), None))

    def test_camera_is_that_of_camera_up(self):
        self.assertEqual(pcl_ops.segment(points, up="camera")[1].up, pcl_ops.camera_up())
        merged = pcl_ops.merge_planes(planes, up="camera")[0]
        self.assertEqual(merged[0].orientation, "vertical")

    def test_another_one_than_z_is_hinted_at_where_none_was_given(self):
        tilt = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], np.float32)
        tilted = points @ tilt.T, tilt @ viewpoint
        with self.assertWarnsRegex(UserWarning, "suggest that up is 0.00, -1.00, 0.00: give up="):
            pcl_ops.segment(tilted[0], viewpoint=tilted[1])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            pcl_ops.segment(points, viewpoint=viewpoint)
            for up in ("camera", "auto", (0, 0, 1)):
                pcl_ops.segment(tilted[0], viewpoint=tilted[1], up=up)

    def test_is_none_where_planes_cannot_tell_or_were_not_seen_from_the_viewpoint(self):
        self.assertIsNone(pcl_ops.estimate_up_axis([]))
        self.assertIsNone(pcl_ops.estimate_up_axis(planes, min_confidence=1.0))
        hidden = surface((0, 6, 0), (4, 0, 0), (0, 0, 2.5), 10000)
        more = np.vstack([points, hidden]).astype(np.float32)
        self.assertTrue(pcl_ops.is_seen_from(points, viewpoint))
        self.assertFalse(pcl_ops.is_seen_from(more, viewpoint))
        self.assertFalse(pcl_ops.is_seen_from(more + 5e6, viewpoint + 5e6))
        found = pcl_ops.segment(more, viewpoint=viewpoint)[1]
        self.assertIsNone(pcl_ops.estimate_up_axis(found, viewpoint))


class UpOfTheFoundPlanes(unittest.TestCase):
    """Calls without up take that of the planes: here -y, as the room is in axes of a camera."""

    turned = points[:, [0, 2, 1]] * np.float32((1, -1, 1))
    sensor = viewpoint[[0, 2, 1]] * (1, -1, 1)
    found = pcl_ops.segment(turned, viewpoint=sensor, up="camera", angle_tolerance=0.3)[1]

    def test_tells_kinds(self):
        self.assertEqual(pcl_ops.plane_kinds(self.found), ["floor", "wall", "wall"])
        self.assertEqual(pcl_ops.plane_kinds(self.found[:2]), ["floor", "wall"], "of a part of the list")

    def test_tells_kinds_and_tables_of_pickled_planes(self):
        some = pickle.loads(pickle.dumps(self.found[:2]))
        self.assertEqual(pcl_ops.plane_kinds(some), ["floor", "wall"])
        self.assertAlmostEqual(some[0].as_dict()["slope"], 0.0, delta=0.5)

    def test_is_that_of_a_floor_plan(self):
        plan = pcl_ops.floor_plan(self.found)
        np.testing.assert_equal(plan._asdict(), pcl_ops.floor_plan(self.found, up=(0, -1, 0))._asdict())
        lengths = [np.linalg.norm(wall.end - wall.start) for wall in plan.walls]
        np.testing.assert_allclose(sorted(lengths), [3, 4], atol=0.05)

    def test_names_merged_planes(self):
        merged = pcl_ops.merge_planes(self.found)[0]
        self.assertEqual([plane.orientation for plane in merged], ["horizontal", "vertical", "vertical"])
        self.assertEqual([plane.kind for plane in merged], ["floor", "wall", "wall"])

    def test_names_merged_planes_within_its_tolerance(self):
        ramp = surface((0, 0, 0), (4, 0, 0.8), (0, 3, 0), 12000)
        found = pcl_ops.segment(ramp, angle_tolerance=0.3)[1]
        self.assertEqual(pcl_ops.merge_planes(found)[0][0].orientation, "horizontal")
        self.assertEqual(pcl_ops.merge_planes(found, angle_tolerance=0.1)[0][0].orientation, "other")

    def test_is_that_of_slopes_in_filters_and_tables(self):
        level = pcl_ops.filter_planes(self.found, slope=(0.0, 0.1))[0]
        self.assertEqual(level, self.found[:1])
        self.assertAlmostEqual(self.found[0].as_dict()["slope"], 0.0, delta=0.5)

    def test_stays_with_regularized_planes(self):
        exact = pcl_ops.regularize_planes(self.found)[0]
        self.assertEqual(pcl_ops.plane_kinds(exact), ["floor", "wall", "wall"])

    def test_may_be_the_word_camera_in_all_calls(self):
        camera = pcl_ops.camera_up()
        with tempfile.TemporaryDirectory() as folder:
            def written(up, name="planes.csv"):
                pcl_ops.write_planes(f"{folder}/{name}", planes, up=up)
                return pathlib.Path(folder, name).read_text()

            def page(up):
                labels = np.full(len(points), -1)
                pcl_ops.write_html(f"{folder}/page.html", points, labels, planes, up=up)
                return pathlib.Path(folder, "page.html").read_text()

            for call in (written, page, lambda up: planes[1].as_dict(up=up),
                         lambda up: pcl_ops.plane_kinds(planes, up=up),
                         lambda up: pcl_ops.floor_plan(planes, up=up).floor,
                         lambda up: len(pcl_ops.buildings.rooms(planes, up=up)),
                         lambda up: pcl_ops.merge_planes(planes, up=up)[0][0].kind,
                         lambda up: pcl_ops.filter_planes(planes, slope=(0.0, 0.1), up=up)[0]):
                self.assertEqual(call("camera"), call(camera))

    def test_is_replaced_by_a_given_one_as_if_the_planes_were_found_with_that(self):
        for array, sensor in ((self.turned, self.sensor), (self.turned, (0, 0, 0)),
                              (self.turned + np.float32((9, 9, 9)), (0, 0, 0))):
            by_z = pcl_ops.segment(array, viewpoint=sensor, up=(0, 0, 1))[1]
            by_camera = pcl_ops.segment(array, viewpoint=sensor, up=(0, -1, 0))[1]
            self.assertEqual(pcl_ops.plane_kinds(by_z, up=(0, -1, 0)), [plane.kind for plane in by_camera])
            np.testing.assert_equal(pcl_ops.floor_plan(by_z, up=(0, -1, 0))._asdict(),
                                    pcl_ops.floor_plan(by_camera)._asdict())
            self.assertEqual(by_z[0].orientation, "vertical", "the planes stay as they are")

    def test_is_replaced_by_a_given_one_that_turns_normals_up_where_the_sensor_is_unknown(self):
        # Zero is below the floor, which hides a table.
        scene = np.vstack([surface((-2, -1, -2), (4, 0, 0), (0, 0, 4), 16000),
                           surface((-0.75, -1.75, -0.75), (1.5, 0, 0), (0, 0, 1.5), 3000)])
        by_z = pcl_ops.segment(scene, up=(0, 0, 1))[1]
        by_camera = pcl_ops.segment(scene, up=(0, -1, 0))[1]
        self.assertEqual(by_camera.kind.tolist(), ["floor", "table"])
        self.assertEqual(pcl_ops.plane_kinds(by_z, up=(0, -1, 0)), ["floor", "table"])


class Edges(unittest.TestCase):
    def test_are_found_near_zero_and_with_coordinates_in_the_millions(self):
        for shift in (np.zeros(3, np.float32), np.array([5e5, 5.4e6, 300.0])):
            found = pcl_ops.segment(points + shift, viewpoint=viewpoint + shift)[1]
            edges, corners = pcl_ops.find_plane_edges(found)
            self.assertEqual([edge.planes for edge in edges], [(0, 1), (0, 2), (1, 2)])
            for edge, length in zip(edges, (4.0, 3.0, 2.5)):
                self.assertAlmostEqual(np.linalg.norm(edge.end - edge.start), length, delta=0.1)
                self.assertAlmostEqual(edge.angle, np.pi / 2, delta=0.01)
            self.assertEqual([corner.planes for corner in corners], [(0, 1, 2)])
            np.testing.assert_allclose(corners[0].position - shift, (0, 3, 0), atol=0.01)
            self.assertEqual(len(pcl_ops.find_plane_edges(found, min_length=2.8)[0]), 2)
        self.assertEqual(pcl_ops.find_plane_edges([]), ([], []))


class Merging(unittest.TestCase):
    def test_joins_two_parts_of_a_floor_but_no_step(self):
        # Two parts of a floor with a gap, and a step of 12 cm beside them.
        parts = pcl_ops.segment(np.vstack([
            surface((0, 0, 0), (2, 0, 0), (0, 2, 0), 9000, seed=1),
            surface((3, 0, 0.01), (2, 0, 0), (0, 2, 0), 6000, seed=2),
            surface((0, 3, 0.12), (5, 0, 0), (0, 0.5, 0), 5000, seed=3),
        ]).astype(np.float32), viewpoint=(0, 0, 2), merging_enabled=False)[1]
        merged, into = pcl_ops.merge_planes(parts)
        self.assertEqual((len(parts), into.tolist()), (3, [0, 0, 1]))
        np.testing.assert_array_equal(
            merged[0].inliers, np.union1d(parts[0].inliers, parts[1].inliers))
        self.assertAlmostEqual(merged[0].area, 10.0, delta=0.2)
        self.assertEqual(merged[0].orientation, "horizontal")
        self.assertGreater(merged[0].normal[2], 0.99)
        for number, given in ((3, {"distance_threshold": 0.001}), (1, {"distance_threshold": 0.2}),
                              (3, {"enabled": False})):
            self.assertEqual(len(pcl_ops.merge_planes(parts, **given)[0]), number)
        self.assertEqual(pcl_ops.merge_planes(parts, up=(1, 0, 0))[0][0].orientation, "vertical")
        merged, into = pcl_ops.merge_planes([])
        self.assertEqual((merged, into.tolist()), ([], []))


class FilterPlanes(unittest.TestCase):
    def test_keeps_what_each_argument_asks_for_and_counts_a_plane_once(self):
        for arguments, expected in (
            ({}, planes),
            ({"orientation": "horizontal"}, [floor]),
            ({"direction": (0, 2, 0)}, [wall]),
            ({"min_points": 9000}, [floor, wall]),
            ({"min_area": 9.0}, [floor, wall]),
            ({"min_width": 2.8}, [floor]),
            ({"max_area": 9.0}, [side]),
            ({"max_width": 2.8}, [wall, side]),
            ({"slope": (1.4, np.pi / 2)}, [wall, side]),
            ({"size": (2.5, 4.0, 0.1)}, [wall]),
            ({"max_planes": 2}, [floor, wall]),
        ):
            with self.subTest(arguments):
                kept, dropped = pcl_ops.filter_planes(planes, **arguments)
                self.assertEqual(kept, expected)
                self.assertEqual(sum(dropped.values()), 3 - len(expected))
                for name in arguments:
                    self.assertEqual(dropped[name], 3 - len(expected))
        kept, dropped = pcl_ops.filter_planes(
            planes, orientation="vertical", min_area=20.0, max_planes=1)
        self.assertEqual((kept, dropped["orientation"], dropped["min_area"]), ([], 1, 2))


class Frames(unittest.TestCase):
    poses = [turned_pose(degrees) for degrees in (0, 20, 40)]
    frames = [pcl_ops.segment(seen_from(pose, points))[1] for pose in poses]

    def test_matching_finds_planes_where_a_frame_has_moved_and_corrects_the_pose(self):
        pose = turned_pose(50)
        pose[:3, 3] = (1, 2, 0.5)
        current = pcl_ops.segment(seen_from(pose, points))[1]
        matches, _ = pcl_ops.match_planes(planes, current[::-1], pose)
        self.assertEqual((matches.dtype, matches.tolist()), (np.int32, [2, 1, 0]))
        self.assertEqual(pcl_ops.match_planes(planes, current)[0].tolist(), [-1, -1, -1])
        current = pcl_ops.segment(seen_from(turned_pose(4), points))[1]
        matches, pose = pcl_ops.match_planes(planes, current)
        self.assertEqual(matches.tolist(), [0, 1, 2])
        np.testing.assert_allclose(pose, turned_pose(4), atol=0.01)
        matches, pose = pcl_ops.match_planes(
            planes, current, rotation_error=0.0, translation_error=0.0)
        self.assertLess(matches[1], 0)
        np.testing.assert_allclose(pose, np.eye(4), atol=1e-9)

    def test_tracker_keeps_numbers_also_of_planes_out_of_sight(self):
        tracker = pcl_ops.PlaneTracker()
        shown = (self.frames[0], self.frames[1][:2], self.frames[2][::-1])
        numbers = [tracker.track(*frame).tolist() for frame in zip(shown, self.poses)]
        self.assertEqual(numbers, [[1, 2, 3], [1, 2], [3, 2, 1]])
        self.assertEqual([(one.number, one.last_seen, one.first_seen, one.times_seen)
                          for one in tracker.planes], [(1, 2, 0, 3), (2, 2, 0, 3), (3, 2, 0, 2)])
        np.testing.assert_allclose(tracker.pose, self.poses[2], atol=0.01)
        for tracked, plane in zip(tracker.planes, self.frames[0]):
            self.assertAlmostEqual(abs(tracked.plane.normal @ plane.normal), 1.0, delta=1e-3)
            self.assertEqual(tracked.plane.hull.tolist(), tracked.hull.tolist())
            self.assertGreater(tracked.plane.area, 0.9 * plane.area)
            self.assertGreaterEqual(tracked.plane.length, tracked.plane.width)
            self.assertEqual(tracked.plane.independent_covariance.shape, (3, 3))
            np.testing.assert_allclose(np.ptp(tracked.hull, 0), np.ptp(plane.hull, 0), atol=0.5)

    def test_tracker_tells_kinds_by_all_its_planes_and_their_up(self):
        tilt = np.eye(4)
        tilt[:3, :3] = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
        table = surface((1, 1, 0.7), (1, 0, 0), (0, 0.8, 0), 4000)
        scene = np.vstack([points, table])
        level = np.eye(4)
        # The true pose of the sensor, and the one that the tracker is given.
        for pose, given_pose in ((level, level), (tilt, tilt), (tilt, level)):
            turn_back = pose[:3, :3].T
            found = pcl_ops.segment(
                seen_from(pose, scene), up=turn_back @ (0, 0, 1), viewpoint=turn_back @ viewpoint)[1]
            tracker = pcl_ops.PlaneTracker()
            tracker.track(found, given_pose)
            for one in (tracker, copy.copy(tracker)):
                kinds = [tracked.plane.kind for tracked in one.planes]
                self.assertEqual(kinds, ["floor", "wall", "wall", "table"])

    def test_tracked_planes_keep_their_outlines_in_copies_and_pickles(self):
        tracker = pcl_ops.PlaneTracker()
        tracker.track(planes)
        for tracked in tracker.planes:
            for copied in (copy.copy(tracked.plane), copy.deepcopy(tracked).plane,
                           pickle.loads(pickle.dumps(tracked)).plane):
                np.testing.assert_array_equal(copied.hull, tracked.hull)
                for name in ("area", "length", "width", "kind"):
                    self.assertEqual(getattr(copied, name), getattr(tracked.plane, name))

    def test_tracked_planes_are_regularized_with_their_outlines(self):
        tracker = pcl_ops.PlaneTracker()
        tracker.track(planes)
        tracked = [one.plane for one in tracker.planes]
        exact, _ = pcl_ops.regularize_planes(tracked)
        self.assertAlmostEqual(float(exact[0].normal @ exact[1].normal), 0.0, delta=1e-12)
        for after, before in zip(exact, tracked):
            self.assertAlmostEqual(after.area, before.area, delta=1e-3 * before.area)
            self.assertLess(np.abs(after.distances(after.hull)).max(), 1e-6)
        self.assertEqual([plane.kind for plane in exact], ["floor", "wall", "wall"])

    def test_tracked_planes_tell_which_way_is_up(self):
        tracker = pcl_ops.PlaneTracker()
        tracker.track(planes)
        up, _ = pcl_ops.estimate_up_axis([one.plane for one in tracker.planes], viewpoint)
        np.testing.assert_allclose(up, (0, 0, 1), atol=0.01)

    def test_tracker_warns_once_of_poses_along_the_up_axis_of_planes(self):
        def codes(step, found):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                tracker = pcl_ops.PlaneTracker()
                for frame in range(6):
                    pose = np.eye(4)
                    pose[:3, 3] = np.multiply(step, frame)
                    tracker.track(found, pose)
            return [one.message.code for one in caught]

        found = pcl_ops.segment(points)[1]
        self.assertEqual(codes((0.1, 0, 1), found), ["camera-poses"])
        self.assertEqual(codes((1, 0, 0.1), found), [])
        # 0.5 m in all, less than MIN_LENGTH_ALONG_Z (_planes.py): a sensor may be lifted so far.
        self.assertEqual(codes((0, 0, 0.1), found), [], "lifted")
        of_a_camera = pcl_ops.segment(points, up=(0, -1, 0))[1]
        self.assertEqual(codes((0.1, 0, 1), of_a_camera), [])
        with_half_a_unit_of_up = pcl_ops.segment(points, up=(0, 0, 0.5))[1]
        self.assertEqual(codes((0.1, 0, 1), with_half_a_unit_of_up), ["camera-poses"])

    def test_tracker_forgets_planes_out_of_sight_by_memory_and_far_ones_by_max_distance(self):
        tracker = pcl_ops.PlaneTracker(memory=0)
        for shown, expected in ((planes, [1, 2, 3]), ([], []), (planes, [4, 5, 6])):
            self.assertEqual(tracker.track(shown).tolist(), expected)
        tracker = pcl_ops.PlaneTracker(max_distance=50.0)
        tracker.track(planes)
        tracker.track([], turned_pose(0) + [[0, 0, 0, 100.0], [0] * 4, [0] * 4, [0] * 4])
        self.assertEqual(tracker.planes, [])

    def test_copies_of_a_tracker_are_independent_and_pickling_is_refused(self):
        tracker = pcl_ops.PlaneTracker()
        tracker.track(self.frames[0])
        for copied in (copy.copy(tracker), copy.deepcopy(tracker)):
            copied.track(self.frames[0], self.poses[2])
            self.assertGreater(len(copied.planes), 3)
        self.assertEqual(len(tracker.planes), 3)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with self.assertRaisesRegex(TypeError, "pcl_ops.PlaneTracker"):
                pickle.dumps(tracker, protocol)


class Kinds(unittest.TestCase):
    def test_tell_which_planes_are_kept(self):
        self.assertEqual(planes.kind.tolist(), ["floor", "wall", "wall"])
        self.assertEqual((planes.kind == "wall").tolist(), [False, True, True])
        kept, dropped = pcl_ops.filter_planes(planes, kind="wall")
        self.assertEqual((kept, dropped["kind"]), ([wall, side], 1))
        self.assertEqual(pcl_ops.filter_planes(planes, kind=("floor", "roof"))[0], [floor])

    def test_that_are_unknown_are_refused_with_what_is_near(self):
        with self.assertRaisesRegex(ValueError, "'wal' is unknown; did you mean wall"):
            pcl_ops.filter_planes(planes, kind="wal")

    def test_are_in_what_a_plane_says_of_itself(self):
        self.assertEqual(floor.kind, "floor")
        self.assertIn("horizontal, floor,", repr(floor))


class WrongArguments(unittest.TestCase):
    def test_in_names_of_parameters_are_answered_with_the_nearest(self):
        with self.assertRaisesRegex(ValueError, "min_point: .*did you mean min_points"):
            pcl_ops.filter_planes(planes, min_point=100)

    def test_a_cloud_in_place_of_its_points_is_named(self):
        class PointCloud:
            points = [[0.0, 0.0, 0.0]]

        for cloud in (PointCloud(), pcl_ops.Cloud(points, viewpoint, {})):
            with self.assertRaisesRegex(TypeError, "give its .points"):
                pcl_ops.segment(cloud)

    def test_a_number_in_place_of_a_file_leaves_its_file_open(self):
        with tempfile.TemporaryFile() as file:
            with self.assertRaises(ValueError):
                pcl_ops.read(file.fileno())
            file.write(b"open")
        with self.assertRaises(ValueError):
            pcl_ops.read(True)

    def test_an_up_without_direction_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for up in ((0, 0, 0), (0, 0, 1e-320)):
                with self.assertRaisesRegex(ValueError, "up: has no direction"):
                    pcl_ops.write_planes(f"{folder}/p.csv", planes, up=up)

    def test_an_up_of_any_length_is_accepted(self):
        self.assertEqual(floor.as_dict((0, 0, 1e300))["slope"], floor.as_dict()["slope"])


class WrittenPlanes(unittest.TestCase):
    def test_are_complete_whatever_other_threads_write(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "planes.json"
            with ThreadPoolExecutor(8) as pool:
                list(pool.map(lambda _: pcl_ops.write_planes(file, planes), range(80)))
            self.assertEqual([path.name for path in pathlib.Path(folder).iterdir()], [file.name])
            written = json.loads(file.read_text())["planes"]
        self.assertEqual([one["kind"] for one in written], ["floor", "wall", "wall"])
        np.testing.assert_allclose(written[0]["coefficients"], floor.coefficients)
        self.assertEqual(len(written[0]["hull"]), len(floor.hull))

    def test_have_the_permissions_of_any_new_file_or_of_the_file_they_replace(self):
        with tempfile.TemporaryDirectory() as folder:
            file, other = pathlib.Path(folder, "planes.json"), pathlib.Path(folder, "other")
            other.touch()
            pcl_ops.write_planes(file, planes)
            self.assertEqual(file.stat().st_mode, other.stat().st_mode)
            file.chmod(0o640)
            pcl_ops.write_planes(file, planes)
            self.assertEqual(file.stat().st_mode & 0o7777, 0o640)

    def test_leave_the_umask_alone_which_other_threads_share(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch("os.umask") as umask:
            pcl_ops.write_planes(f"{folder}/planes.json", planes)
        umask.assert_not_called()

    def test_are_a_layer_of_a_geopackage(self):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/planes.gpkg"
            pcl_ops.write_planes(file, planes, crs="EPSG:25832")
            database = sqlite3.connect(file)
            self.assertEqual(database.execute("PRAGMA integrity_check").fetchall(), [("ok",)])
            self.assertEqual(database.execute("PRAGMA application_id").fetchone(),
                             (int.from_bytes(b"GPKG", "big"),))
            rows = database.execute("SELECT id, kind, points, geom FROM planes").fetchall()
            box = database.execute(
                "SELECT min_x, min_y, max_x, max_y, srs_id FROM gpkg_contents").fetchone()
            database.close()
        self.assertEqual([row[:3] for row in rows],
                         [(i + 1, plane.kind, len(plane.inliers)) for i, plane in enumerate(planes)])
        np.testing.assert_allclose(box, [0, 0, 4, 3, 25832], atol=0.02)
        self.assert_is_outline(rows[0][3], floor)

    def assert_is_outline(self, blob, plane):
        header_size = 40  # magic, version, flags, reference system and box [byte]
        polygon_z = 1003  # the type of a polygon with x, y, z in well-known binary
        self.assertEqual(blob[:4], b"GP\0\3")
        order, kind, rings, corners = struct.unpack_from("<B3I", blob, header_size)
        self.assertEqual((order, kind, rings, corners), (1, polygon_z, 1, len(plane.hull) + 1))
        ring = np.frombuffer(blob, "<f8", 3 * corners, header_size + 13).reshape(-1, 3)
        np.testing.assert_allclose(ring[0], ring[-1])
        for corner in ring:
            self.assertLess(np.linalg.norm(plane.hull - corner, axis=1).min(), 0.001)

    @unittest.skipUnless(shutil.which("pcl_ops_segment"), "the programs are not here")
    def test_are_in_the_tables_that_the_program_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            pcl_ops.write(f"{folder}/room.pcd", points)
            done = subprocess.run(
                ["pcl_ops_segment", f"{folder}/room.pcd", "--planes", f"{folder}/program.gpkg",
                 "--quiet"], stderr=subprocess.PIPE, text=True, check=False)
            if "SQLite" in done.stderr:
                self.skipTest("the program was built without SQLite")
            pcl_ops.write_planes(f"{folder}/python.gpkg", planes)
            tables = []
            for name in ("program", "python"):
                database = sqlite3.connect(f"{folder}/{name}.gpkg")
                tables.append([(table, database.execute(f'PRAGMA table_info("{table}")').fetchall())
                               for table, in database.execute(
                                   "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")])
                database.close()
        self.assertEqual(tables[0], tables[1])
