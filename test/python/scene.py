# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of the tests, and poses of sensors."""

import struct

import numpy as np


def surface(corner, first, second, number, noise=0.002, seed=1):
    """Random points of a parallelogram.

    corner: where the sides first and second begin
    number: of points
    noise: standard deviation along the normal [m]
    """
    draws = np.random.default_rng(seed)
    normal = np.cross(first, second)
    normal = normal / np.linalg.norm(normal)
    s, t = draws.uniform(size=(2, number, 1))
    heights = draws.normal(0.0, noise, (number, 1))
    return np.asarray(corner) + s * np.asarray(first) + t * np.asarray(second) + heights * normal


def room():
    """A floor of 4 m x 3 m, two walls of 2.5 m height, and 100 points of NaN, in random order."""
    cloud = np.vstack([
        surface((0, 0, 0), (4, 0, 0), (0, 3, 0), 12000, seed=1),
        surface((0, 3, 0), (4, 0, 0), (0, 0, 2.5), 10000, seed=2),
        surface((0, 0, 0), (0, 3, 0), (0, 0, 2.5), 7500, seed=3),
        np.full((100, 3), np.nan),
    ])
    return np.random.default_rng(4).permutation(cloud).astype(np.float32)


def turn(degrees):
    """A pose that is turned about z, as a 4 x 4 matrix."""
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    pose = np.eye(4)
    pose[:2, :2] = [[cosine, -sine], [sine, cosine]]
    return pose


def seen_from(pose, points):
    """The points in the frame of a sensor with this pose."""
    return ((points - pose[:3, 3]) @ pose[:3, :3]).astype(np.float32)


def las(points, geo_keys=()):
    """The bytes of a LAS 1.2 file. Its integers are millimeters from the least coordinates on.

    geo_keys: (id, value) of each key of GeoTIFF of the reference system
    """
    offset = np.nanmin(points, axis=0).astype(np.float64)
    # Point format 0: of its 20 bytes only the coordinates are used.
    records = np.zeros(len(points), [("xyz", "<i4", 3), ("rest", "u1", 8)])
    records["xyz"] = np.round((points - offset) * 1000)
    # A variable length record, the directory of keys (34735).
    keys = struct.pack("<4H", 1, 1, 0, len(geo_keys)) + b"".join(
        struct.pack("<4H", key, 0, 1, value) for key, value in geo_keys)
    directory = struct.pack("<2x16s2H32x", b"LASF_Projection", 34735, len(keys)) + keys
    header_size = 227
    header = struct.pack(
        "<4s20xBB68xHIIBHI20x12d",
        b"LASF", 1, 2,  # version 1.2
        header_size, header_size + len(directory),  # where points begin
        1, 0, 20, len(points),  # variable length records, point format, its bytes, points
        *[0.001] * 3, *offset,  # scale [m] and offset of x, y, z
        *[1e7, 0.0] * 3)  # largest and least x, y, z, which pcl_ops does not read
    return header + directory + records.tobytes()
