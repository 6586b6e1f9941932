# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds of files and of messages, as arrays."""

import os
from typing import Any, Dict, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

# Of sensor_msgs/PointField, and of PCL, whose last two are 64-bit integers.
_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8", 9: "i8",
          10: "u8"}


class Cloud(NamedTuple):
    """A point cloud as a file or a message has it."""

    points: NDArray[Any]
    """(N, 3): x, y and z of all points, NaN ones, too; float32, or float64 where the file has
    other numbers than float32."""
    viewpoint: NDArray[np.float64]
    """(3,): where the sensor was, as a PCD file says; else zero."""
    fields: Dict[str, NDArray[Any]]
    """All fields by name, each of shape (N,), or (N, count) where it has several numbers."""

    @property
    def labels(self) -> Optional[NDArray[np.int32]]:
        """(N,): the field label as segment has labels, -1 for no plane, where files have 0 for
        none; or None where there is none."""
        label = self.fields.get("label")
        return None if label is None else (label.astype(np.int64) - 1).astype(np.int32)


def read(path: Union[str, "os.PathLike[str]"]) -> Cloud:
    """Read a point cloud: .pcd, .ply, .las, .laz (where LASzip is), .ptx, .bin (KITTI), .npy,
    .off, .obj, or text (.xyz, .xyzrgb, .txt, .pts, .asc, .csv).

    Raises OSError where the file cannot be opened, ValueError where it is damaged or of
    another kind; both name it.
    """
    from . import _reader  # what it needs takes longer to load than all else

    with open(path, "rb"):
        pass
    file = _reader.load(os.fsencode(path))
    return from_message(file)._replace(viewpoint=np.array(file.viewpoint, float))


def from_message(msg: Any) -> Cloud:
    """The point cloud of a sensor_msgs/PointCloud2, of ROS 1 or 2.

    msg: any object with fields (of name, offset, datatype and count), data, width, height,
        point_step, row_step and is_bigendian. Fields may be in any order, padded, of
        either order of bytes, and coordinates of any type.

    Raises TypeError or ValueError where msg is no such object, or its parts contradict
    each other.
    """
    try:
        rows = _rows(msg)
    except AttributeError as error:
        raise TypeError(f"msg: is no PointCloud2: {error}") from None
    missing = [axis for axis in "xyz" if axis not in rows.dtype.names]
    if missing:
        raise TypeError(f"msg: has no number {missing[0]} for each point")
    fields = {name: _column(rows[name]) for name in rows.dtype.names}
    points = np.stack([fields[axis] for axis in "xyz"], axis=-1)
    if points.ndim != 2:
        raise TypeError("msg: has several numbers x, y or z for each point")
    kind = np.float32 if points.dtype == np.float32 else np.float64
    return Cloud(points.astype(kind, copy=False), np.zeros(3), fields)


def _rows(msg: Any) -> NDArray[Any]:
    """The points as a structured array of shape (height, width)."""
    order = ">" if msg.is_bigendian else "<"
    # PCL's files call their padding "_".
    fields = [one for one in msg.fields if one.name != "_" and one.datatype in _TYPES]
    kinds = [np.dtype((order + _TYPES[one.datatype], (one.count,) if one.count > 1 else ()))
             for one in fields]
    row_step = msg.row_step if msg.height > 1 else msg.width * msg.point_step
    data = msg.data if isinstance(msg.data, bytes) else np.asarray(msg.data, np.uint8)
    try:
        layout = np.dtype({"names": [one.name for one in fields], "formats": kinds,
                           "offsets": [one.offset for one in fields], "itemsize": msg.point_step})
        return np.ndarray((msg.height, msg.width), layout, data,
                          strides=(row_step, msg.point_step))
    except (TypeError, ValueError) as error:
        raise ValueError(f"msg: its fields, steps and data do not fit: {error}") from None


def _column(numbers: NDArray[Any]) -> NDArray[Any]:
    """A copy of its own, one entry for each point, in the machine's order of bytes."""
    flat = numbers.reshape((-1, *numbers.shape[2:]))
    return flat.astype(flat.dtype.newbyteorder("="))
