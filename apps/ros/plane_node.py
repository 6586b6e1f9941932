#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node of ROS 2 that finds the planes of each cloud it hears.

NOT YET TESTED WITH ROS 2, only with stand-ins for its classes.

    python3 plane_node.py --ros-args -r points:=/camera/depth/points -p up:="[0.0, -1.0, 0.0]"

Subscribes to points (sensor_msgs/PointCloud2). Publishes labelled (sensor_msgs/PointCloud2 with
x, y, z and label: 0 for no plane, 1 for the largest) and planes (visualization_msgs/MarkerArray:
the outline of each plane, whose id is its label).

Parameters: up, the direction against gravity in the frame of the cloud (by default z), and
method ("ops", "fspf" or "kht").
"""

import array
import colorsys

import numpy as np
import pcl_ops
import rclpy
from geometry_msgs.msg import Point
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

FLOAT32, UINT32 = 7, 6  # values of PointField.datatype


def labelled_cloud(msg, points, labels):
    """Returns a message of the points of msg, in its width and height, with their labels.

    labels: from Python, where 0 is the first plane and -1 no plane.
    """
    rows = np.zeros(len(points), [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("label", "<u4")])
    for axis, coordinates in zip("xyz", points.T):
        rows[axis] = coordinates
    rows["label"] = labels + 1  # in the message 1 is the first plane and 0 no plane
    offsets = {name: rows.dtype.fields[name][1] for name in rows.dtype.names}
    fields = [PointField(name=name, offset=offset, count=1,
                         datatype=UINT32 if name == "label" else FLOAT32)
              for name, offset in offsets.items()]
    return PointCloud2(
        header=msg.header, height=msg.height, width=msg.width, fields=fields, is_bigendian=False,
        point_step=rows.itemsize, row_step=rows.itemsize * msg.width, is_dense=msg.is_dense,
        data=array.array("B", rows.tobytes()))


def outline(msg, number, plane):
    """Returns the hull of a plane as a closed line, in a color by its number."""
    marker = Marker(header=msg.header, ns="planes", id=number, type=Marker.LINE_STRIP,
                    action=Marker.ADD)
    marker.pose.orientation.w = 1.0
    marker.scale.x = 0.02  # width of the line [m]
    # Successive multiples of 1 / golden ratio, modulo 1, are far from each other.
    hue = number * 0.618 % 1.0
    red, green, blue = colorsys.hsv_to_rgb(hue, 1.0, 1.0)
    marker.color = ColorRGBA(r=red, g=green, b=blue, a=1.0)
    marker.points = [Point(x=x, y=y, z=z)
                     for x, y, z in np.vstack([plane.hull, plane.hull[:1]]).tolist()]
    return marker


class PlaneNode(Node):
    """Publishes the planes of each cloud that it receives."""

    def __init__(self):
        super().__init__("plane_node")
        self.declare_parameter("up", [0.0, 0.0, 1.0])
        self.declare_parameter("method", "ops")
        self.labelled = self.create_publisher(PointCloud2, "labelled", 1)
        self.planes = self.create_publisher(MarkerArray, "planes", 1)
        self.create_subscription(PointCloud2, "points", self.publish_planes, qos_profile_sensor_data)

    def publish_planes(self, msg):
        points = pcl_ops.from_message(msg).points
        labels, planes = np.zeros(0, np.int32), []
        if len(points):
            labels, planes = pcl_ops.segment(
                points, self.get_parameter("method").value, up=self.get_parameter("up").value)
        self.labelled.publish(labelled_cloud(msg, points, labels))
        # The first marker removes the outlines of the cloud before.
        markers = [Marker(header=msg.header, action=Marker.DELETEALL)]
        markers += [outline(msg, number, plane) for number, plane in enumerate(planes, 1)]
        self.planes.publish(MarkerArray(markers=markers))


def main():
    rclpy.init()
    try:
        rclpy.spin(PlaneNode())
    except KeyboardInterrupt:
        pass  # Ctrl-C is how a node ends


if __name__ == "__main__":
    main()
