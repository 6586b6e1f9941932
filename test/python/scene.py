# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of the tests, poses of sensors, and bytes of LAS files."""

import struct

import numpy as np


def surface(corner, first, second, number, noise=0.002, seed=1):
    """Random points of a parallelogram, as rows of an array.

    corner: where both sides begin [m]
    first, second: vectors along the sides, as long as these [m]
    number: how many points
    noise: standard deviation along the normal [m]
    """
    draws = np.random.default_rng(seed)
    normal = np.cross(first, second)
    normal = normal / np.linalg.norm(normal)
    s, t = draws.uniform(size=(2, number, 1))
    heights = draws.normal(0.0, noise, (number, 1))
    return np.asarray(corner) + s * np.asarray(first) + t * np.asarray(second) + heights * normal


def room():
    """A floor of 4 m x 3 m, two walls of 2.5 m height and 4 m and 3 m length, and 100 points of NaN.

    The order of the points is random. The floor has 12,000 points, the walls 10,000 and 7,500.
    """
    cloud = np.vstack([
        surface((0, 0, 0), (4, 0, 0), (0, 3, 0), 12000, seed=1),
        surface((0, 3, 0), (4, 0, 0), (0, 0, 2.5), 10000, seed=2),
        surface((0, 0, 0), (0, 3, 0), (0, 0, 2.5), 7500, seed=3),
        np.full((100, 3), np.nan),
    ])
    return np.random.default_rng(4).permutation(cloud).astype(np.float32)


def turned_pose(degrees):
    """The pose of a sensor at zero that is turned about z, as a 4 x 4 matrix."""
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    pose = np.eye(4)
    pose[:2, :2] = [[cosine, -sine], [sine, cosine]]
    return pose


def seen_from(pose, points):
    """The points in the frame of a sensor whose pose is this 4 x 4 matrix."""
    return ((points - pose[:3, 3]) @ pose[:3, :3]).astype(np.float32)


def las(points, geo_keys=()):
    """The bytes of a LAS 1.2 file. Coordinates are stored as integers: millimeters above the smallest ones.

    geo_keys: pairs of the id and the value of a GeoTIFF key, which describe the reference system
    """
    assert np.isfinite(points).all()
    offset = points.min(axis=0).astype(np.float64)
    point_format, bytes_per_point = 0, 20
    # Of a point of this format only the coordinates are used.
    records = np.zeros(len(points), [("xyz", "<i4", 3), ("rest", "u1", 8)])
    records["xyz"] = np.round((points - offset) * 1000)
    # The only variable length record is the directory of the keys.
    keys = struct.pack("<4H", 1, 1, 0, len(geo_keys))
    for key, value in geo_keys:
        keys += struct.pack("<4H", key, 0, 1, value)
    id_of_directory = 34735
    directory = struct.pack("<2x16s2H32x", b"LASF_Projection", id_of_directory, len(keys)) + keys
    header_size = 227
    header = struct.pack(
        "<4s20xBB68xHIIBHI20x12d",
        b"LASF", 1, 2,  # version 1.2
        header_size, header_size + len(directory),  # where points begin
        1,  # number of variable length records
        point_format, bytes_per_point, len(points),
        *[0.001] * 3, *offset,  # scale [m] and offset of x, y, z
        *[1e7, 0.0] * 3)  # largest and smallest x, y, z, which pcl_ops does not read
    return header + directory + records.tobytes()
