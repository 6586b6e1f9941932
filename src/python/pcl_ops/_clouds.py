# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds of files and of messages, as arrays."""

import os
import re
import warnings as python_warnings
from typing import Any, Dict, Literal, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops
from ._arguments import Points, array_of, checked_flag, checked_number, file_name, finite_vector, plane_numbers, points_array
from ._planes import ResultWarning

# Names of NumPy's types by the datatypes of sensor_msgs/PointField; the last two, 64-bit
# integers, are PCL's alone.
_TYPE_NAMES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8", 9: "i8",
               10: "u8"}
# Control characters, and surrogates, which UTF-8 does not have.
_NOT_IN_NAMES = re.compile(r"[\x00-\x1f\x7f-\x9f\ud800-\udfff]")
_DATATYPES = {name: datatype for datatype, name in _TYPE_NAMES.items()}


class Cloud(NamedTuple):
    """A point cloud as a file or a message has it."""

    points: NDArray[Any]
    """(N, 3): x, y and z of all points, also of those with NaN; float32, or float64 if the file
    has coordinates of another type than float32."""
    viewpoint: NDArray[np.float64]
    """(3,): the position of the sensor from a PCD file; else zero."""
    fields: Dict[str, NDArray[Any]]
    """All fields by name, each of shape (N,), or (N, count) if it has several numbers."""
    height: int = 1
    """Number of rows if the points are the pixels of an image, row after row; else 1."""
    orientation: Tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    """The rotation of the sensor from a PCD file: a quaternion w, x, y, z."""
    source: Optional[str] = None
    """The .las or .laz it was read from; write keeps every byte of it."""
    unit: Optional[Literal["meter", "foot", "degree"]] = None
    """The unit of x and y by the reference system of a .las or .laz; None if it has none."""

    @property
    def labels(self) -> Optional[Union[NDArray[np.int32], NDArray[np.int64]]]:
        """(N,): the labels of the field label, in which files have 0 for no plane, as segment has
        them: -1 for no plane, also where it is NaN, as it may be in a text; int64 if one is above
        2^31 - 1. None if there is no such field."""
        field = self.fields.get("label")
        if field is None:
            return None
        if field.dtype.kind == "f":
            largest = 2.0**53  # of the whole numbers that all have a double of their own
            field = np.where(np.abs(field) <= largest, field, 0.0)  # other casts are undefined
        labels = np.maximum(field.astype(np.int64), 0) - 1
        needs_int64 = labels.max(initial=-1) > np.iinfo(np.int32).max
        return labels if needs_int64 else labels.astype(np.int32)


def read(path: Union[str, "os.PathLike[str]"]) -> Cloud:
    """Read a point cloud: .pcd, .ply, .las, .laz (where LASzip is), .ptx, .bin (KITTI), .npy,
    .off, .obj, or text (.xyz, .xyzrgb, .txt, .pts, .asc, .csv).

    Raises OSError if the file cannot be opened, ValueError if it is damaged or of another kind;
    both name the file. Warns by ResultWarning of a reference system in feet or degrees, as
    lengths here are meters by default.
    """
    from . import _files  # here, as it takes longer to load than all other parts

    if not isinstance(path, (str, bytes, os.PathLike)):  # open takes the caller's descriptors
        raise ValueError(f"path: has to be the name of a file, not {path!r:.80}")
    with open(path, "rb"):  # raises OSError if the file cannot be opened
        pass
    file = _files.load(file_name(path))
    _warn_of_unit(file.unit)
    return from_message(file)._replace(
        viewpoint=np.array(file.viewpoint, float), orientation=file.orientation,
        source=os.path.abspath(os.fsdecode(path)) if _is_las(path) else None, unit=file.unit)


def _warn_of_unit(unit: Optional[str]) -> None:
    """Warns of coordinates in feet or degrees; the warning names the line that called read."""
    if unit is None:
        return
    context = _pcl_ops.ResultContext()
    context.set_unit(unit)
    no_points, origin = np.empty((0, 3), np.float32), np.zeros(3)
    for code, text in _pcl_ops.warnings(no_points, origin, [], context):
        python_warnings.warn(ResultWarning(code, text), stacklevel=3)


def write(
    path: Union[str, "os.PathLike[str]"], cloud: Union[Cloud, Points],
    labels: Optional[NDArray[Any]] = None, *, distances: Optional[NDArray[Any]] = None,
    keep_color: bool = False,
) -> None:
    """Write a point cloud as the programs do, with the plane of each point.

    path: .pcd or .ply; or .las or .laz for a cloud that was read from such a file, all of which
        is kept. An existing file is replaced when the new one is complete.
    cloud: what read or from_message returns, with all its fields; or an array of points as for
        segment, of which x, y and z are written.
    labels: integers in the shape of segment's labels, negative for no plane; those of an image
        may also be in a row. In the file they are the field label, with 0 for no plane and 1 for
        the first plane. In a .pcd or .ply points get the color of their plane.
    distances: a floating point number for each point, in such a shape, for the field distance;
        only together with labels.
    keep_color: keep the colors that the cloud has.

    Raises OSError if the file cannot be written, ValueError or TypeError if the arguments do
    not fit.
    """
    from . import _files

    cloud = _checked_cloud(cloud)
    keeps_color = checked_flag("keep_color", keep_color)
    file_labels = _labels_of_file(labels, cloud)
    file_distances = _distances_of_file(distances, cloud)
    if len(file_distances) and not len(file_labels):
        raise ValueError("distances: are those to planes; give labels, too")
    file = file_name(path)
    if _is_las(path):
        if cloud.source is None:
            raise ValueError(f"{os.fsdecode(path)}: is LAS, which the cloud was not read from; "
                             "give a .pcd or .ply")
        if not len(file_labels):
            raise ValueError("labels: are what is added to a .las; give them")
        _files.save_las(file, os.fsencode(cloud.source), cloud.points, file_labels, file_distances)
        return
    if os.path.splitext(os.fsdecode(path))[1].lower() not in (".pcd", ".ply"):
        raise ValueError(f"{os.fsdecode(path)}: has an unknown extension; give .pcd, .ply, or "
                         ".las of a cloud that was read from one")
    rows = _rows_of_file(cloud)
    fields = [_file_field(name, rows.dtype[name]) for name in rows.dtype.names]
    _files.save(file, fields, rows.view(np.uint8).ravel(), cloud.height, cloud.viewpoint,
                cloud.orientation, file_labels, file_distances, keeps_color)


def _file_field(name: str, field_type: Any) -> Tuple[str, int, int]:
    """Name, datatype and count of a field, as the extension writes it."""
    count = int(np.prod(field_type.shape, dtype=int))
    return name, _DATATYPES[field_type.base.str[1:]], count


def _checked_cloud(given: Any) -> Cloud:
    """A Cloud that can be written, from a Cloud or an array of points; raises if it cannot be."""
    if not isinstance(given, Cloud):
        height = np.shape(given)[0] if np.ndim(given) == 3 else 1
        return Cloud(points_array(given), np.zeros(3), {}, height)
    cloud = given._replace(
        points=points_array(given.points), viewpoint=finite_vector("cloud.viewpoint", given.viewpoint),
        orientation=finite_vector("cloud.orientation", given.orientation, "four numbers (w, x, y, z)", 4),
        height=checked_number("cloud.height", given.height, lambda rows: rows >= 1, "a number of rows from 1", int))
    count = len(cloud.points)
    if count % cloud.height:
        raise ValueError(f"cloud: {count} points are no image of {cloud.height} rows")
    for name, field in cloud.fields.items():
        if not isinstance(name, str) or name.split() != [name] or _NOT_IN_NAMES.search(name):
            raise ValueError(f"cloud: the field {name!r} has a name that files cannot have")
        if not isinstance(field, np.ndarray):
            raise TypeError(f"cloud: the field {name} is a {type(field).__name__}; give an array of NumPy")
        if field.dtype.base.str[1:] not in _DATATYPES or field.shape[:1] != (count,):
            rows = len(field) if field.ndim else 1
            raise ValueError(f"cloud: the field {name} has {rows} of {field.dtype} for "
                             f"{count} points")
        if 0 in field.shape[1:]:
            raise ValueError(f"cloud: the field {name} has no number for a point; leave it out")
    return cloud


def _is_las(path: Any) -> bool:
    """Whether a path is that of a .las or .laz."""
    return os.fsdecode(path).lower().endswith((".las", ".laz"))


def _shape_for(numbers: Any, cloud: Cloud) -> Tuple[int, ...]:
    """The shape that one number for each point has to have: that of the image, or (N,).

    numbers: those that the user gives, whose shape decides between both.
    """
    count = len(cloud.points)
    image_shape = cloud.height, count // cloud.height
    is_image = (np.shape(numbers) == image_shape
                or (cloud.height > 1 and np.ndim(numbers) > 1))
    return image_shape if is_image else (count,)


def _labels_of_file(labels: Any, cloud: Cloud) -> NDArray[np.uint32]:
    """Labels as files have them: planes from 1, 0 for no plane; an empty array for None."""
    if labels is None:
        return np.empty(0, np.uint32)
    return plane_numbers("labels", labels, _shape_for(labels, cloud), -1)


def _distances_of_file(distances: Any, cloud: Cloud) -> NDArray[np.float32]:
    """Distances as files have them, in one row; an empty array for None."""
    if distances is None:
        return np.empty(0, np.float32)
    shape = _shape_for(distances, cloud)
    return array_of("distances", distances, "f", "numpy.nan", shape, "points").ravel().astype(np.float32)


def _rows_of_file(cloud: Cloud) -> NDArray[Any]:
    """All fields as a structured array, a row for each point; x, y and z are those of points."""
    columns = {axis: cloud.points[:, i] for i, axis in enumerate("xyz")}
    for name, field in cloud.fields.items():
        # Fields x, y and z that equal the coordinates of points keep the type of the field.
        if name not in columns or np.array_equal(field, columns[name], equal_nan=True):
            columns[name] = field
    names = [*cloud.fields, *(axis for axis in "xyz" if axis not in cloud.fields)]
    column_types = [(name, columns[name].dtype.newbyteorder("<"), columns[name].shape[1:])
                    for name in names]
    rows = np.empty(len(cloud.points), column_types)
    for name in names:
        rows[name] = columns[name]
    return rows


def from_message(msg: Any) -> Cloud:
    """The point cloud of a sensor_msgs/PointCloud2, of ROS 1 or 2.

    msg: any object with fields (of name, offset, datatype and count), data, width, height,
        point_step, row_step and is_bigendian. Fields may be in any order, padded, of
        either order of bytes, and coordinates of any type.

    Raises TypeError or ValueError if msg is no such object, or if its parts contradict each
    other.
    """
    try:
        rows = _rows_of_message(msg)
    except AttributeError as error:
        raise TypeError(f"msg: is no PointCloud2: {error}") from None
    missing = [axis for axis in "xyz" if axis not in rows.dtype.names]
    if missing:
        raise TypeError(f"msg: has no number {missing[0]} for each point")
    fields = {name: _column(rows[name]) for name in rows.dtype.names}
    points = np.stack([fields[axis] for axis in "xyz"], axis=-1)
    if points.ndim != 2:
        raise TypeError("msg: has several numbers x, y or z for each point")
    number_type = np.float32 if points.dtype == np.float32 else np.float64
    return Cloud(points.astype(number_type, copy=False), np.zeros(3), fields, msg.height)


def _rows_of_message(msg: Any) -> NDArray[Any]:
    """The points as a structured array of shape (height, width)."""
    # PCL's files call their padding "_".
    fields = [field for field in msg.fields
              if field.name != "_" and field.datatype in _TYPE_NAMES]
    byte_order = ">" if msg.is_bigendian else "<"
    field_types = [_type_of_field(field, byte_order) for field in fields]
    width_of_row = msg.width * msg.point_step  # [bytes]
    row_step = msg.row_step if msg.height > 1 else width_of_row
    if row_step < width_of_row:
        raise ValueError("msg: row_step is less than width times point_step")
    data = msg.data if isinstance(msg.data, bytes) else np.asarray(msg.data, np.uint8)
    try:
        layout = np.dtype({"names": [field.name for field in fields], "formats": field_types,
                           "offsets": [field.offset for field in fields],
                           "itemsize": msg.point_step})
        return np.ndarray((msg.height, msg.width), layout, data,
                          strides=(row_step, msg.point_step))
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(f"msg: its fields, steps and data do not fit: {error}") from None


def _type_of_field(field: Any, byte_order: str) -> Any:
    """NumPy's type of a field of a message; byte_order: "<" or ">"."""
    shape = (field.count,) if field.count > 1 else ()
    return np.dtype((byte_order + _TYPE_NAMES[field.datatype], shape))


def _column(numbers: NDArray[Any]) -> NDArray[Any]:
    """A copy with one entry for each point in place of (height, width), in the machine's byte order.
    """
    flat = numbers.reshape((-1, *numbers.shape[2:]))
    return flat.astype(flat.dtype.newbyteorder("="))
