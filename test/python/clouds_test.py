# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files, and messages of ROS or what looks like them, as arrays."""

import array
import pathlib
import re
import runpy
import sys
import tempfile
import types
import unittest
import warnings
from unittest import mock

import numpy as np
import pcl_ops
from scene import las, room

# Classes of messages: objects with the same members, and those of ROS where it is installed.
kinds = [types.SimpleNamespace(PointCloud2=types.SimpleNamespace, PointField=types.SimpleNamespace)]
try:
    import sensor_msgs.msg
    kinds.append(sensor_msgs.msg)
except ImportError:
    pass

# sensor_msgs/PointField: the number of each type.
types_of_fields = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}


def message(rows, data=bytes, height=1, row_padding=0, kind=kinds[-1]):
    """A structured array as a message."""
    members = [(name, *rows.dtype.fields[name][:2]) for name in rows.dtype.names]
    fields = [kind.PointField(name=name, offset=offset, count=int(np.prod(member.shape)),
                              datatype=types_of_fields[member.base.str[1:]])
              for name, member, offset in members]
    width, step = len(rows) // height, rows.dtype.itemsize
    lines = [rows[i * width:(i + 1) * width].tobytes() + bytes(row_padding) for i in range(height)]
    return kind.PointCloud2(
        fields=fields, data=data(b"".join(lines)), width=width, height=height, point_step=step,
        row_step=width * step + row_padding,
        is_bigendian=any(member.base.str[0] == ">" for _, member, _ in members))


def rows_of(points, layout):
    """Points as a structured array; fields other than x, y and z are 0."""
    rows = np.zeros(len(points), np.dtype(layout))
    for axis, numbers in zip("xyz", points.T):
        rows[axis] = numbers
    return rows


def padded(kind, names="xyz"):
    """A layout of fields 16 bytes apart, with 12 unused bytes before the first one."""
    return {"names": list(names), "formats": [kind] * 3, "offsets": [12, 28, 44], "itemsize": 64}


plain = [("x", "<f4"), ("y", "<f4"), ("z", "<f4")]


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = room()
        cls.labels = pcl_ops.segment(cls.points)[0]

    def assertSamePoints(self, msg):
        cloud = pcl_ops.from_message(msg)
        np.testing.assert_array_equal(cloud.points, self.points)
        np.testing.assert_array_equal(pcl_ops.segment(cloud.points)[0], self.labels)
        return cloud

    def test_any_layout_has_the_same_points(self):
        for name, layout, *image in (
            ("plain", plain),
            ("padded", padded("<f4")),
            ("any order", padded("<f4", "zxy")),
            ("big-endian", padded(">f4")),
            ("double", padded("<f8")),
            ("double, big-endian", padded(">f8")),
            ("unaligned", [("ring", "u1"), ("z", "<f4"), ("x", "<f4"), ("y", "<f8")]),
            ("organized", plain, 100),
            ("organized, rows padded", padded(">f8", "yzx"), 100, 24),
        ):
            for kind in kinds:
                with self.subTest(name, kind=kind):
                    msg = message(rows_of(self.points, layout), bytes, *image, kind=kind)
                    self.assertTrue(self.assertSamePoints(msg).points.dtype.isnative)

    def test_any_buffer_is_read(self):
        rows = rows_of(self.points, padded("<f4"))
        for data in (bytes, bytearray, memoryview, lambda text: array.array("B", text),
                     lambda text: np.frombuffer(text, np.uint8)):
            self.assertSamePoints(message(rows, data))

    def test_other_fields_come_along(self):
        rows = rows_of(self.points, [*plain, ("label", "<u4"), ("normal", "<f4", 3)])
        rows["label"] = np.arange(len(rows))
        cloud = self.assertSamePoints(message(rows))
        np.testing.assert_array_equal(cloud.labels, np.arange(len(rows)) - 1)
        self.assertEqual(cloud.fields["normal"].shape, (len(rows), 3))

    def test_whole_numbers_are_coordinates_and_no_points_are_a_cloud(self):
        rows = np.array([(1, -2, 3)], [("x", "<i2"), ("y", "<i2"), ("z", "<i2")])
        self.assertEqual(pcl_ops.from_message(message(rows)).points.tolist(), [[1, -2, 3]])
        for kind in kinds:
            empty = pcl_ops.from_message(message(np.zeros(0, plain), kind=kind)).points
            self.assertEqual((empty.shape, empty.dtype), ((0, 3), np.float32))

    def test_what_is_no_cloud_is_refused(self):
        rows = rows_of(self.points, padded("<f4"))
        short, outside, nameless = message(rows), message(rows), message(rows)
        short.data = short.data[:-1]
        outside.fields[2].offset = 62
        nameless.fields[0].name = "a"
        several = message(np.zeros(1, [("x", "f4", 2), ("y", "f4", 2), ("z", "f4", 2)]))
        for msg, error, beginning in (
            (short, ValueError, "msg: its fields, steps and data do not fit"),
            (outside, ValueError, "msg: its fields, steps and data do not fit"),
            (nameless, TypeError, "msg: has no number x for each point"),
            (several, TypeError, "msg: has several numbers x, y or z for each point"),
            (self.points, TypeError, "msg: is no PointCloud2: "),
        ):
            with self.subTest(beginning), self.assertRaisesRegex(error, "^" + beginning):
                pcl_ops.from_message(msg)


class Reader(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def test_reads_what_a_pcd_says(self):
        cloud = pcl_ops.read(self.file("é.pcd", (
            "VERSION .7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
            "WIDTH 2\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\nDATA ascii\n"
            "0.5 nan 2 0\n3 4 5 7\n")))
        np.testing.assert_array_equal(cloud.points, np.float32([[0.5, np.nan, 2], [3, 4, 5]]))
        self.assertEqual(cloud.points.dtype, np.float32)
        self.assertEqual(cloud.viewpoint.tolist(), [1, 2, 3])
        self.assertEqual(cloud.fields["label"].tolist(), [0, 7])
        self.assertEqual(cloud.labels.tolist(), [-1, 6])

    def test_keeps_the_digits_of_a_las(self):
        millimeters = np.random.default_rng(1).integers(0, 10**6, (500, 3))
        expected = np.array([5e5, 5.4e6, 300.0]) + millimeters * 0.001
        (self.folder / "a.las").write_bytes(las(expected))
        points = pcl_ops.read(self.folder / "a.las").points
        np.testing.assert_allclose(points, expected, rtol=0, atol=1e-6)

    def test_warns_of_a_reference_system_in_feet_or_degrees(self):
        model, projected, geographic, linear_unit = 1024, 1, 2, 3076
        for keys, unit, codes in (
                ((), None, []),
                (((model, projected), (linear_unit, 9001)), "meter", []),
                (((model, projected), (linear_unit, 9003)), "foot", ["feet"]),
                (((model, geographic),), "degree", ["degrees"])):
            with self.subTest(unit), warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                (self.folder / "a.las").write_bytes(las(room()[:9], keys))
                self.assertEqual(pcl_ops.read(self.folder / "a.las").unit, unit)
                self.assertEqual([one.message.code for one in caught], codes)
                self.assertTrue(all(one.filename == __file__ for one in caught))

    def test_reads_what_numpy_saved(self):
        file = self.folder / "a.npy"
        for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"):
            for shape in ((6, 4), (2, 3, 4)):
                for order in "CF":
                    with self.subTest(kind=kind, shape=shape, order=order):
                        saved = np.asarray(np.arange(24).reshape(shape), kind, order)
                        np.save(file, saved)
                        cloud = pcl_ops.read(file)
                        rows = saved.reshape(6, 4)
                        np.testing.assert_array_equal(cloud.points, rows[:, :3])
                        np.testing.assert_array_equal(cloud.fields["field_4"], rows[:, 3])
                        self.assertEqual(cloud.fields["field_4"].dtype, saved.dtype)

    def test_says_what_is_wrong(self):
        with self.assertRaises(FileNotFoundError):
            pcl_ops.read(self.folder / "none.pcd")
        with self.assertRaises(IsADirectoryError):
            pcl_ops.read(self.folder)
        for name in ("a.pcd", "a.ply", "a.xyz", "a.las", "a.png"):
            with self.assertRaisesRegex(ValueError, name):
                pcl_ops.read(self.file(name, "broken\n"))

    def test_leaves_the_descriptors_of_its_caller_open(self):
        with open(self.file("a.xyz", "1 2 3\n"), encoding="ascii") as file:
            for path in (file.fileno(), True):
                with self.assertRaisesRegex(ValueError, "path: has to be the name of a file"):
                    pcl_ops.read(path)
            self.assertEqual(file.read(), "1 2 3\n")


class Writer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written(self, name, *given, **named):
        pcl_ops.write(self.folder / name, *given, **named)
        return pcl_ops.read(self.folder / name)

    def test_what_is_read_comes_back(self):
        points = np.array([[5e5, 1, 2], [np.nan, 3, 4], [5, 6, 7], [8, 9, 1]])
        cloud = pcl_ops.Cloud(points, np.array([1.0, 2, 3]), {
            "intensity": np.uint16([1, 2, 3, 4]), "normal": np.ones((4, 3), np.float32)},
            2, (0.0, 1.0, 0.0, 0.0))
        back = self.written("a.pcd", cloud, np.array([1, -1, 0, 0]))
        np.testing.assert_array_equal(back.points, points)
        self.assertEqual(back.labels.tolist(), [1, -1, 0, 0])
        self.assertEqual(back.fields["intensity"].dtype, np.uint16)
        np.testing.assert_array_equal(back.fields["normal"], cloud.fields["normal"])
        self.assertEqual(back.viewpoint.tolist(), [1, 2, 3])
        self.assertEqual((back.height, back.orientation), (2, cloud.orientation))

    def test_an_array_or_an_image_is_a_cloud(self):
        points = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
        for array, labels in ((points, np.zeros((2, 4), int)), (points.reshape(8, 3), None)):
            for name in ("a.pcd", "a.ply"):
                cloud = self.written(name, array, labels)
                np.testing.assert_array_equal(cloud.points, points.reshape(8, 3))
                self.assertEqual(cloud.labels is None, labels is None)
        self.assertEqual(self.written("a.pcd", points).height, 2)

    def test_labels_of_an_image_have_its_shape_or_are_in_a_row(self):
        points = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
        labels = np.arange(8).reshape(2, 4)
        cloud = pcl_ops.Cloud(points.reshape(8, 3), np.zeros(3), {}, 2)
        for given in (points, cloud):
            for fitting in (labels, labels.ravel()):
                back = self.written("a.pcd", given, fitting, distances=0.5 * fitting)
                self.assertEqual(back.labels.tolist(), list(range(8)))
            for wrong in (labels.T, labels.reshape(4, 2), labels.reshape(2, 2, 2)):
                with self.assertRaisesRegex(ValueError, r"labels: shape \(.*\) is not \(.*8,|2, 4\), that"):
                    self.written("a.pcd", given, wrong)
                with self.assertRaisesRegex(ValueError, r"distances: shape \(.*\) is not \("):
                    self.written("a.pcd", given, labels, distances=0.5 * wrong)
        with self.assertRaisesRegex(ValueError, r"labels: shape \(2, 4\) is not \(8,\), that of the points"):
            self.written("a.pcd", points.reshape(8, 3), labels)

    def test_large_labels_come_back(self):
        points = np.zeros((3, 3), np.float32)
        for largest, kind in ((2**31 - 1, np.int32), (2**31, np.int64), (2**32 - 3, np.int64)):
            back = self.written("a.pcd", points, np.array([-1, 0, largest])).labels
            self.assertEqual((back.tolist(), back.dtype), ([-1, 0, largest], kind))

    def test_points_that_were_moved_are_written_with_the_other_fields(self):
        cloud = pcl_ops.from_message(message(rows_of(room(), [*plain, ("ring", "u1")])))
        moved = self.written("a.ply", cloud._replace(points=cloud.points + np.float32(1)))
        np.testing.assert_array_equal(moved.points, room() + np.float32(1))
        self.assertIn("ring", moved.fields)

    def test_a_las_keeps_its_bytes_and_gets_distances(self):
        points = room()[np.isfinite(room()[:, 0])]
        (self.folder / "a.las").write_bytes(las(points))
        cloud = pcl_ops.read(self.folder / "a.las")
        labels, planes = pcl_ops.segment(cloud.points)
        distances = planes[0].distances(cloud.points)
        back = self.written("a.las", cloud, labels, distances=distances)  # over itself
        np.testing.assert_array_equal(back.points, cloud.points)
        np.testing.assert_array_equal(back.labels, labels)
        records = (self.folder / "a.las").read_bytes()[-28 * len(points):]
        np.testing.assert_array_equal(np.frombuffer(records, "<f4").reshape(-1, 7)[:, 6],
                                      distances.astype(np.float32))

    def test_says_what_is_wrong(self):
        points = room()
        (self.folder / "a.las").write_bytes(las(points[np.isfinite(points[:, 0])]))
        survey = pcl_ops.read(self.folder / "a.las")
        labels = np.zeros(len(points), int)
        for name, cloud, given, error, said in (
            ("a.png", points, {}, ValueError, "a.png: has an unknown extension; give .pcd, .ply"),
            ("b.las", points, {"labels": labels}, ValueError, "b.las: is LAS, which the cloud was"),
            ("b.las", survey, {}, ValueError, "labels: are what is added to a .las"),
            ("b.las", survey._replace(points=survey.points + 1),
             {"labels": labels[:len(survey.points)]}, ValueError, "has other points than the cloud"),
            ("b.pcd", points, {"labels": labels[1:]}, ValueError, "labels: shape"),
            ("b.pcd", points, {"labels": labels * 0.5}, TypeError, "labels: dtype float64"),
            ("b.pcd", points, {"distances": labels * 0.5}, ValueError, "distances: are those to"),
            ("b.pcd", points, {"labels": labels, "distances": [0.5]}, ValueError,
             "distances: shape (1,) is not (29600,), that of the points"),
            ("b.pcd", points, {"labels": labels, "distances": labels}, TypeError,
             "distances: dtype int64 is not one of floating point numbers"),
            ("none/b.pcd", points, {}, OSError, "none"),
            ("b.pcd", survey._replace(height=7), {}, ValueError, "cloud: 29500 points are no image"),
            ("b.pcd", survey._replace(fields={"a": np.ones(3)}), {}, ValueError,
             "cloud: the field a has 3 of float64 for 29500 points"),
            ("b.pcd", survey._replace(fields={"a": np.ones(29500, bool)}), {}, ValueError,
             "cloud: the field a has 29500 of bool for 29500 points"),
            ("b.pcd", survey._replace(fields={"a b": np.ones(29500)}), {}, ValueError,
             "cloud: the field 'a b' has a name that files cannot have"),
            ("b.pcd", survey._replace(fields={"a": [1.0] * 29500}), {}, TypeError,
             "cloud: the field a is a list; give an array of NumPy"),
            ("b.pcd", survey._replace(fields={5: np.ones(29500)}), {}, ValueError,
             "cloud: the field 5 has a name that files cannot have"),
            ("b.pcd", survey._replace(viewpoint=(1, 2)), {}, TypeError,
             "cloud.viewpoint: has to be three numbers (x, y, z), not (1, 2)"),
            ("b.pcd", survey._replace(orientation=(1, 2)), {}, TypeError,
             "cloud.orientation: has to be four numbers (w, x, y, z), not (1, 2)"),
            ("b.pcd", survey._replace(height=2.0), {}, TypeError,
             "cloud.height: has to be a number of rows from 1, not 2.0"),
            ("b.pcd", points, {"labels": labels, "keep_color": "no"}, TypeError,
             "keep_color: has to be True or False, not 'no'"),
            ("b.pcd", points, {"labels": np.ma.masked_equal(labels, 0)}, TypeError,
             "labels: a masked array"),
            ("b.pcd", np.zeros((5, 3), int), {}, TypeError, "points: dtype"),
        ):
            with self.subTest(said), self.assertRaisesRegex(error, re.escape(said)):
                pcl_ops.write(self.folder / name, cloud, **given)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["a.las"])


class FakeNode:
    """What the example asks of ROS 2's Node."""

    def __init__(self, name):
        self.create_subscription = mock.Mock()
        self.create_publisher = lambda *_: mock.Mock()
        self.declared = {}

    def declare_parameter(self, name, value):
        self.declared[name] = types.SimpleNamespace(value=value)

    def get_parameter(self, name):
        return self.declared[name]


class RosNode(unittest.TestCase):
    """The example, without ROS 2."""

    def test_publishes_labels_and_outlines(self):
        parts = types.SimpleNamespace
        messages = mock.Mock(PointCloud2=parts, PointField=parts, Point=parts, MarkerArray=parts,
                             Marker=mock.Mock(side_effect=mock.Mock))
        modules = {f"{name}_msgs.msg": messages
                   for name in ("geometry", "sensor", "std", "visualization")}
        modules.update({"rclpy": mock.Mock(), "rclpy.node": mock.Mock(Node=FakeNode),
                        "rclpy.qos": mock.Mock()})
        file = pathlib.Path(__file__).parents[2] / "apps/ros/plane_node.py"
        with mock.patch.dict(sys.modules, modules):
            node = runpy.run_path(str(file))["PlaneNode"]()
        for points in (room(), np.zeros((0, 3), np.float32)):
            msg = message(rows_of(points, plain), kind=kinds[0])
            msg.header, msg.is_dense = "here", False
            node.hear(msg)
            cloud = pcl_ops.from_message(node.labelled.publish.call_args[0][0])
            np.testing.assert_array_equal(cloud.points, points)
            expected, planes = pcl_ops.segment(points) if len(points) else ([], [])
            np.testing.assert_array_equal(cloud.labels, expected)
            outlines = node.planes.publish.call_args[0][0].markers[1:]
            self.assertEqual([one.id for one in outlines], list(range(1, len(planes) + 1)))
            for one, plane in zip(outlines, planes):
                self.assertEqual(len(one.points), len(plane.hull) + 1)
