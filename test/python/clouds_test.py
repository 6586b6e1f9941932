# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds from files and from messages of ROS, and clouds written to files."""

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

# Namespaces with the classes of messages: objects that have the same members as those of ROS, and
# ROS itself where it is installed.
message_modules = [types.SimpleNamespace(PointCloud2=types.SimpleNamespace,
                                         PointField=types.SimpleNamespace)]
try:
    import sensor_msgs.msg
    message_modules.append(sensor_msgs.msg)
except ImportError:
    pass

# The numbers that sensor_msgs/PointField has for NumPy's types.
datatype_of = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}


def message(points, data=bytes, height=1, row_padding=0, module=message_modules[-1]):
    """A structured array with an element for each point, as a PointCloud2.

    data: the class of the message's buffer
    height: number of image rows
    row_padding: number of unused bytes after each image row
    module: one of message_modules
    """
    fields, is_bigendian = [], False
    for name in points.dtype.names:
        number_type, offset = points.dtype.fields[name][:2]
        fields.append(module.PointField(
            name=name, offset=offset, count=int(np.prod(number_type.shape)),
            datatype=datatype_of[number_type.base.str[1:]]))
        is_bigendian = is_bigendian or number_type.base.str[0] == ">"
    width, point_step = len(points) // height, points.dtype.itemsize
    image_rows = [points[row * width:(row + 1) * width].tobytes() + bytes(row_padding)
                  for row in range(height)]
    return module.PointCloud2(
        fields=fields, data=data(b"".join(image_rows)), width=width, height=height,
        point_step=point_step, row_step=width * point_step + row_padding,
        is_bigendian=is_bigendian)


def structured(points, layout):
    """Points as a structured array; fields other than x, y and z are 0.

    layout: the dtype of the array
    """
    array_of_fields = np.zeros(len(points), np.dtype(layout))
    for axis, coordinates in zip("xyz", points.T):
        array_of_fields[axis] = coordinates
    return array_of_fields


def padded(number_type, names="xyz"):
    """A layout of fields 16 bytes apart, with 12 unused bytes before the first one."""
    return {"names": list(names), "formats": [number_type] * 3, "offsets": [12, 28, 44],
            "itemsize": 64}


plain = [("x", "<f4"), ("y", "<f4"), ("z", "<f4")]


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = room()
        cls.labels = pcl_ops.segment(cls.points)[0]

    def assertSamePoints(self, msg):
        """Returns the cloud of a message; fails unless it has the points and labels of the class."""
        cloud = pcl_ops.from_message(msg)
        np.testing.assert_array_equal(cloud.points, self.points)
        np.testing.assert_array_equal(pcl_ops.segment(cloud.points)[0], self.labels)
        return cloud

    def test_any_layout_has_the_same_points(self):
        for name, layout, *height_and_padding in (
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
            for module in message_modules:
                with self.subTest(name, module=module):
                    msg = message(structured(self.points, layout), bytes, *height_and_padding,
                                  module=module)
                    self.assertTrue(self.assertSamePoints(msg).points.dtype.isnative)

    def test_any_buffer_is_read(self):
        points = structured(self.points, padded("<f4"))
        for data in (bytes, bytearray, memoryview, lambda buffer: array.array("B", buffer),
                     lambda buffer: np.frombuffer(buffer, np.uint8)):
            self.assertSamePoints(message(points, data))

    def test_other_fields_are_fields_of_the_cloud(self):
        points = structured(self.points, [*plain, ("label", "<u4"), ("normal", "<f4", 3)])
        points["label"] = np.arange(len(points))
        cloud = self.assertSamePoints(message(points))
        # Label 0 of a message is none, -1 of the cloud.
        np.testing.assert_array_equal(cloud.labels, np.arange(len(points)) - 1)
        self.assertEqual(cloud.fields["normal"].shape, (len(points), 3))

    def test_coordinates_may_be_integers_and_there_may_be_no_points(self):
        integers = np.array([(1, -2, 3)], [("x", "<i2"), ("y", "<i2"), ("z", "<i2")])
        self.assertEqual(pcl_ops.from_message(message(integers)).points.tolist(), [[1, -2, 3]])
        for module in message_modules:
            empty = pcl_ops.from_message(message(np.zeros(0, plain), module=module)).points
            self.assertEqual((empty.shape, empty.dtype), ((0, 3), np.float32))

    def test_what_is_no_cloud_is_refused(self):
        points = structured(self.points, padded("<f4"))
        without_last_byte, field_beyond_point, without_x = (message(points) for _ in range(3))
        without_last_byte.data = without_last_byte.data[:-1]
        with_short_rows = message(points[:10], height=2)
        with_short_rows.row_step = 4 * with_short_rows.point_step  # of 5
        field_beyond_point.fields[2].offset = 62  # 4 bytes from there on, of a point of 64
        without_x.fields[0].name = "a"
        two_x = message(np.zeros(1, [("x", "f4", 2), ("y", "f4", 2), ("z", "f4", 2)]))
        for msg, error, beginning in (
            (without_last_byte, ValueError, "msg: its fields, steps and data do not fit"),
            (with_short_rows, ValueError, "msg: row_step is less than width times point_step"),
            (field_beyond_point, ValueError, "msg: its fields, steps and data do not fit"),
            (without_x, TypeError, "msg: has no number x for each point"),
            (two_x, TypeError, "msg: has several numbers x, y or z for each point"),
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

    def test_reads_points_viewpoint_and_fields_of_a_pcd(self):
        cloud = pcl_ops.read(self.file("é.pcd", (
            "VERSION .7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
            "WIDTH 2\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\nDATA ascii\n"
            "0.5 nan 2 0\n3 4 5 7\n")))
        np.testing.assert_array_equal(cloud.points, np.float32([[0.5, np.nan, 2], [3, 4, 5]]))
        self.assertEqual(cloud.points.dtype, np.float32)
        self.assertEqual(cloud.viewpoint.tolist(), [1, 2, 3])
        self.assertEqual(cloud.fields["label"].tolist(), [0, 7])
        self.assertEqual(cloud.labels.tolist(), [-1, 6])

    def test_labels_of_a_text_that_are_no_numbers_are_no_plane(self):
        cloud = pcl_ops.read(self.file("a.xyz", (
            "# x y z label\n0 0 0 nan\n1 0 0 2\n2 0 0 inf\n3 0 0 1e300\n4 0 0 0\n")))
        self.assertEqual(cloud.labels.tolist(), [-1, 1, -1, -1, -1])

    def test_reads_coordinates_of_a_las_in_double_precision(self):
        millimeters = np.random.default_rng(1).integers(0, 10**6, (500, 3))
        expected = np.array([5e5, 5.4e6, 300.0]) + millimeters * 0.001
        (self.folder / "a.las").write_bytes(las(expected))
        points = pcl_ops.read(self.folder / "a.las").points
        np.testing.assert_allclose(points, expected, rtol=0, atol=1e-6)

    def test_warns_of_a_reference_system_in_feet_or_degrees(self):
        # Ids of GeoTIFF keys, and their values.
        model, linear_unit = 1024, 3076
        projected, geographic, meter, us_survey_foot = 1, 2, 9001, 9003
        for keys, unit, codes in (
                ((), None, []),
                (((model, projected), (linear_unit, meter)), "meter", []),
                (((model, projected), (linear_unit, us_survey_foot)), "foot", ["feet"]),
                (((model, geographic),), "degree", ["degrees"])):
            with self.subTest(unit), warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                (self.folder / "a.las").write_bytes(las(room()[:9], keys))
                self.assertEqual(pcl_ops.read(self.folder / "a.las").unit, unit)
                self.assertEqual([warning.message.code for warning in caught], codes)
                self.assertTrue(all(warning.filename == __file__ for warning in caught))

    def test_reads_arrays_that_numpy_saved(self):
        file = self.folder / "a.npy"
        for number_type in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"):
            for shape in ((6, 4), (2, 3, 4)):  # a row of points and an image, x, y, z and a field
                for order in "CF":  # by rows, as in C, and by columns, as in Fortran
                    with self.subTest(number_type=number_type, shape=shape, order=order):
                        saved = np.asarray(np.arange(24).reshape(shape), number_type, order)
                        np.save(file, saved)
                        cloud = pcl_ops.read(file)
                        rows = saved.reshape(6, 4)
                        np.testing.assert_array_equal(cloud.points, rows[:, :3])
                        np.testing.assert_array_equal(cloud.fields["field_4"], rows[:, 3])
                        self.assertEqual(cloud.fields["field_4"].dtype, saved.dtype)

    def test_raises_errors_that_name_the_file(self):
        with self.assertRaises(FileNotFoundError):
            pcl_ops.read(self.folder / "none.pcd")
        with self.assertRaises(IsADirectoryError):
            pcl_ops.read(self.folder)
        for name in ("a.pcd", "a.ply", "a.xyz", "a.las", "a.png"):
            with self.assertRaisesRegex(ValueError, name):
                pcl_ops.read(self.file(name, "broken\n"))

    def test_refuses_a_file_descriptor_and_leaves_it_open(self):
        with open(self.file("a.xyz", "1 2 3\n"), encoding="ascii") as file:
            for path in (file.fileno(), True):
                with self.assertRaisesRegex(ValueError, "path: has to be the name of a file"):
                    pcl_ops.read(path)
            self.assertEqual(file.read(), "1 2 3\n")


def wrong_writes(points, labels, survey):
    """Calls of write that fail: file, cloud, further arguments, the error, and a part of its text.

    points, labels: a room, and a label for each of its points
    survey: a cloud of 29500 points that was read from a LAS file
    """
    return (
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
        ("b.pcd", survey._replace(fields={"a\0b": np.ones(29500)}), {}, ValueError,
         "cloud: the field 'a\\x00b' has a name that files cannot have"),
        ("b.pcd", survey._replace(fields={"a\ud800": np.ones(29500)}), {}, ValueError,
         "cloud: the field 'a\\ud800' has a name that files cannot have"),
        ("b.pcd", survey._replace(fields={"a": np.ones((29500, 0))}), {}, ValueError,
         "cloud: the field a has no number for a point; leave it out"),
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
    )


class Writer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written(self, name, *arguments, **options):
        """The cloud that is read from a file written with these arguments and options."""
        pcl_ops.write(self.folder / name, *arguments, **options)
        return pcl_ops.read(self.folder / name)

    def test_points_labels_fields_and_pose_come_back(self):
        points = np.array([[5e5, 1, 2], [np.nan, 3, 4], [5, 6, 7], [8, 9, 1]])
        cloud = pcl_ops.Cloud(points, np.array([1.0, 2, 3]), {
            "intensity": np.uint16([1, 2, 3, 4]), "normal": np.ones((4, 3), np.float32)},
            height=2, orientation=(0.0, 1.0, 0.0, 0.0))
        back = self.written("a.pcd", cloud, np.array([1, -1, 0, 0]))
        np.testing.assert_array_equal(back.points, points)
        self.assertEqual(back.labels.tolist(), [1, -1, 0, 0])
        self.assertEqual(back.fields["intensity"].dtype, np.uint16)
        np.testing.assert_array_equal(back.fields["normal"], cloud.fields["normal"])
        self.assertEqual(back.viewpoint.tolist(), [1, 2, 3])
        self.assertEqual((back.height, back.orientation), (2, cloud.orientation))

    def test_an_array_of_rows_or_of_an_image_is_a_cloud(self):
        points = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
        for image_or_rows, labels in ((points, np.zeros((2, 4), int)),
                                      (points.reshape(8, 3), None)):
            for name in ("a.pcd", "a.ply"):
                cloud = self.written(name, image_or_rows, labels)
                np.testing.assert_array_equal(cloud.points, points.reshape(8, 3))
                self.assertEqual(cloud.labels is None, labels is None)
        self.assertEqual(self.written("a.pcd", points).height, 2)

    def test_labels_of_an_image_have_its_shape_or_are_in_a_row(self):
        points = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
        labels = np.arange(8).reshape(2, 4)
        cloud = pcl_ops.Cloud(points.reshape(8, 3), np.zeros(3), {}, height=2)
        for given in (points, cloud):
            for fitting in (labels, labels.ravel()):
                back = self.written("a.pcd", given, fitting, distances=0.5 * fitting)
                self.assertEqual(back.labels.tolist(), list(range(8)))
            for wrong in (labels.T, labels.reshape(8, 1), labels.reshape(2, 2, 2)):
                problem = re.escape(f"shape {wrong.shape} is not (2, 4), that of the points")
                with self.assertRaisesRegex(ValueError, f"^labels: {problem}"):
                    self.written("a.pcd", given, wrong)
                with self.assertRaisesRegex(ValueError, f"^distances: {problem}"):
                    self.written("a.pcd", given, labels, distances=0.5 * wrong)
        with self.assertRaisesRegex(ValueError, r"labels: shape \(2, 4\) is not \(8,\), that of the points"):
            self.written("a.pcd", points.reshape(8, 3), labels)

    def test_large_labels_come_back(self):
        points = np.zeros((3, 3), np.float32)
        for largest, dtype in ((2**31 - 1, np.int32), (2**31, np.int64), (2**32 - 3, np.int64)):
            back = self.written("a.pcd", points, np.array([-1, 0, largest])).labels
            self.assertEqual((back.tolist(), back.dtype), ([-1, 0, largest], dtype))

    def test_points_that_were_moved_are_written_with_the_other_fields(self):
        cloud = pcl_ops.from_message(message(structured(room(), [*plain, ("ring", "u1")])))
        moved = self.written("a.ply", cloud._replace(points=cloud.points + np.float32(1)))
        np.testing.assert_array_equal(moved.points, room() + np.float32(1))
        self.assertIn("ring", moved.fields)

    def test_a_las_is_replaced_by_itself_with_labels_and_distances(self):
        points = room()[np.isfinite(room()[:, 0])]
        (self.folder / "a.las").write_bytes(las(points))
        cloud = pcl_ops.read(self.folder / "a.las")
        labels, planes = pcl_ops.segment(cloud.points)
        distances = planes[0].distances(cloud.points)
        back = self.written("a.las", cloud, labels, distances=distances)
        np.testing.assert_array_equal(back.points, cloud.points)
        np.testing.assert_array_equal(back.labels, labels)
        # The 20 bytes of a point are followed by its label and its distance, of 4 bytes each.
        records = (self.folder / "a.las").read_bytes()[-28 * len(points):]
        distances_in_file = np.frombuffer(records, "<f4").reshape(-1, 7)[:, 6]
        np.testing.assert_array_equal(distances_in_file, distances.astype(np.float32))

    def test_raises_errors_that_name_what_is_wrong(self):
        points = room()
        (self.folder / "a.las").write_bytes(las(points[np.isfinite(points[:, 0])]))
        survey = pcl_ops.read(self.folder / "a.las")
        labels = np.zeros(len(points), int)
        for name, cloud, arguments, error, part_of_message in wrong_writes(points, labels, survey):
            with self.subTest(part_of_message), \
                    self.assertRaisesRegex(error, re.escape(part_of_message)):
                pcl_ops.write(self.folder / name, cloud, **arguments)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["a.las"])


class FakeNode:
    """A class with the members of ROS 2's Node that plane_node.py uses."""

    def __init__(self, name):
        self.create_subscription = mock.Mock()
        self.create_publisher = lambda *_: mock.Mock()
        self.declared = {}

    def declare_parameter(self, name, value):
        self.declared[name] = types.SimpleNamespace(value=value)

    def get_parameter(self, name):
        return self.declared[name]


class RosNode(unittest.TestCase):
    """plane_node.py, without ROS 2."""

    def test_publishes_labels_and_outlines(self):
        any_members = types.SimpleNamespace
        messages = mock.Mock(PointCloud2=any_members, PointField=any_members, Point=any_members,
                             MarkerArray=any_members, Marker=mock.Mock(side_effect=mock.Mock))
        modules = {f"{name}_msgs.msg": messages
                   for name in ("geometry", "sensor", "std", "visualization")}
        modules.update({"rclpy": mock.Mock(), "rclpy.node": mock.Mock(Node=FakeNode),
                        "rclpy.qos": mock.Mock()})
        file = pathlib.Path(__file__).parents[2] / "apps/ros/plane_node.py"
        with mock.patch.dict(sys.modules, modules):
            node = runpy.run_path(str(file))["PlaneNode"]()
        for points in (room(), np.zeros((0, 3), np.float32)):
            msg = message(structured(points, plain), module=message_modules[0])
            msg.header, msg.is_dense = "here", False
            node.publish_planes(msg)
            cloud = pcl_ops.from_message(node.labelled.publish.call_args[0][0])
            np.testing.assert_array_equal(cloud.points, points)
            labels, planes = pcl_ops.segment(points) if len(points) else ([], [])
            np.testing.assert_array_equal(cloud.labels, labels)
            # The first marker deletes those of the frame before.
            outlines = node.planes.publish.call_args[0][0].markers[1:]
            self.assertEqual([outline.id for outline in outlines], list(range(1, len(planes) + 1)))
            for outline, plane in zip(outlines, planes):
                self.assertEqual(len(outline.points), len(plane.hull) + 1)
