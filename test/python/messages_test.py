# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages of ROS, or what looks like them, as arrays."""

import array
import types
import unittest

import numpy as np
import pcl_ops
from scene import room

try:
    from sensor_msgs.msg import PointCloud2, PointField
except ImportError:  # objects of the same parts
    PointCloud2 = PointField = types.SimpleNamespace

types_of_fields = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}


def message(rows, data=bytes, height=1, row_padding=0):
    """A structured array as a message."""
    fields = []
    for name in rows.dtype.names:
        kind, offset = rows.dtype.fields[name][:2]
        fields.append(PointField(name=name, offset=offset, datatype=types_of_fields[kind.base.str[1:]],
                                 count=int(np.prod(kind.shape))))
    width, step = len(rows) // height, rows.dtype.itemsize
    padding = bytes(row_padding)
    lines = [rows[i * width:(i + 1) * width].tobytes() + padding for i in range(height)]
    is_bigendian = any(rows.dtype.fields[name][0].base.str[0] == ">" for name in rows.dtype.names)
    return PointCloud2(fields=fields, data=data(b"".join(lines)), width=width, height=height,
                       point_step=step, row_step=width * step + row_padding,
                       is_bigendian=is_bigendian)


def rows_of(points, layout):
    rows = np.zeros(len(points), np.dtype(layout))
    for axis, numbers in zip("xyz", points.T):
        rows[axis] = numbers
    return rows


def padded(kind, names="xyz"):
    """Fields 16 bytes apart, after 12 that are nobody's."""
    return {"names": list(names), "formats": [kind] * 3, "offsets": [12, 28, 44], "itemsize": 64}


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = room()

    def assertSamePoints(self, msg):
        cloud = pcl_ops.from_message(msg)
        np.testing.assert_array_equal(cloud.points, self.points)
        self.assertTrue(cloud.points.dtype.isnative)
        np.testing.assert_array_equal(
            pcl_ops.segment(cloud.points)[0], pcl_ops.segment(self.points)[0])
        return cloud

    def test_any_layout_has_the_same_points(self):
        for name, layout in {
            "plain": [("x", "<f4"), ("y", "<f4"), ("z", "<f4")],
            "padded": padded("<f4"),
            "any order": padded("<f4", "zxy"),
            "big-endian": padded(">f4"),
            "double": padded("<f8"),
            "double, big-endian": padded(">f8"),
            "unaligned": [("ring", "u1"), ("z", "<f4"), ("x", "<f4"), ("y", "<f8")],
        }.items():
            with self.subTest(name):
                self.assertSamePoints(message(rows_of(self.points, layout)))

    def test_any_buffer_is_read(self):
        rows = rows_of(self.points, padded("<f4"))
        for data in (bytes, bytearray, memoryview, lambda text: array.array("B", text),
                     lambda text: np.frombuffer(text, np.uint8)):
            self.assertSamePoints(message(rows, data))

    def test_rows_of_an_image_may_be_padded(self):
        rows = rows_of(self.points, padded("<f4"))
        self.assertSamePoints(message(rows, height=100, row_padding=24))

    def test_other_fields_come_along(self):
        layout = [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("label", "<u4"), ("normal", "<f4", 3)]
        rows = rows_of(self.points, layout)
        rows["label"] = np.arange(len(rows))
        rows["normal"] = 0, 0, 1
        cloud = self.assertSamePoints(message(rows))
        np.testing.assert_array_equal(cloud.labels, np.arange(len(rows)) - 1)
        self.assertEqual(cloud.fields["normal"].shape, (len(rows), 3))

    def test_whole_numbers_are_coordinates_too(self):
        rows = np.array([(1, -2, 3)], [("x", "<i2"), ("y", "<i2"), ("z", "<i2")])
        self.assertEqual(pcl_ops.from_message(message(rows)).points.tolist(), [[1, -2, 3]])

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


if __name__ == "__main__":
    unittest.main()
