# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages that show planes in a browser."""

import colorsys
import json
import os
from typing import Any, Dict, Optional, Union

import numpy as np
from numpy.typing import NDArray

from ._arguments import (Points, Up, Vector, checked_number, file_name, finite_vector, plane_numbers, points_array,
                         single_precision)
from ._planes import Plane, Planes, find_plane_edges, plane_list, up_of
from ._segmentation import is_seen_from


def _color(number: int) -> str:
    """The color "#rrggbb" of the plane with this number.

    From one number to the next the hue turns by the golden angle, and saturation and value change,
    so that planes next to each other in the list differ clearly.
    """
    golden_angle = 0.381966  # share of a full turn
    saturations, values = (0.85, 0.6, 0.95), (0.9, 0.8, 0.65)
    hue = number * golden_angle % 1.0
    channels = colorsys.hsv_to_rgb(hue, saturations[number % 3], values[number % 3])
    return "#" + "".join(f"{round(255 * channel):02x}" for channel in channels)


def _described(number: int, plane: Plane, up: NDArray[np.float64]) -> Dict[str, Any]:
    """What the page shows of a plane, by the keys that the script of the page reads."""
    slope = np.degrees(np.arccos(min(abs(float(plane.normal @ up)), 1.0)))
    return {"id": number, "orientation": plane.orientation, "kind": plane.kind, "rms": plane.rms, "area": plane.area,
            "slope": slope, "normal": plane.normal.tolist(), "centroid": plane.centroid.tolist(),
            "hull": plane.hull.tolist(), "holes": [], "color": _color(number)}


def _direction_to_eye(
    points: NDArray[Any], viewpoint: NDArray[np.float64], up: NDArray[np.float64], is_seen: bool
) -> NDArray[np.float64]:
    """Unit vector from the points towards the eye in the first view of the page.

    The eye is on the side of the viewpoint if all points were seen from there (is_seen); else it
    looks at them from above, at a slant.
    """
    finite = points[np.isfinite(points).all(axis=1)]
    towards = viewpoint - np.median(finite, axis=0) if is_seen and len(finite) else np.zeros(3)
    if towards.any():
        return towards / np.linalg.norm(towards)
    axis_near_up = np.eye(3)[np.argmax(np.abs(up))]
    next_axis = np.roll(axis_near_up, 1)
    level = np.cross(up, next_axis)  # horizontal
    # 37 degrees over the horizontal: the sine is 0.6, the cosine 0.8.
    slant = 0.8 * level / np.linalg.norm(level) + 0.6 * up
    return slant / np.linalg.norm(slant)


def _check_shown(points: NDArray[Any], title: Any) -> None:
    """Raises if the page cannot show the points or the title."""
    farthest = 1e100  # squares, which the script of the page computes, stay finite
    finite = points[np.isfinite(points)]
    if len(finite) and np.abs(finite).max() > farthest:
        raise ValueError("points: some are farther than 1e100 from zero, which no page can show")
    if title is not None and not isinstance(title, str):
        raise TypeError(f"title: has to be a str, not {title!r:.80}")


def write_html(
    path: Union[str, "os.PathLike[str]"], points: Points, labels: NDArray[Any], planes: Planes, *,
    title: Optional[str] = None, up: Optional[Up] = None,
    viewpoint: Vector = (0.0, 0.0, 0.0), max_points: int = 2_000_000,
) -> None:
    """Write a page that shows a point cloud and its planes in a browser.

    One file that loads nothing from elsewhere: points in the colors of their planes, the
    list of planes, the plane of a point that is clicked, outlines, edges and normals.

    path: of the page, .html.
    points, labels, planes: array of shape (N, 3), and what segment returned for it.
    title: by default the name of the file.
    up: vector against gravity, or "camera"; None: the up that the planes were found with.
    viewpoint: the position of the sensor.
    max_points: of more points than this an even sample is shown, with points of each plane.

    Raises OSError if the file cannot be written; then an existing file stays as it was.
    """
    file = file_name(path)
    name = os.fsdecode(file)
    if os.path.splitext(name)[1].lower() != ".html":
        raise ValueError(f"{name}: has an unknown extension; give .html")
    planes = plane_list("planes", planes)
    upwards = up_of(planes, up)
    array = points_array(points)
    _check_shown(array, title)
    numbers = plane_numbers("labels", labels, np.shape(points)[:-1], -1)
    if numbers.max() > len(planes):
        raise ValueError(f"labels: the label {numbers.max() - 1} is none of {len(planes)} planes")
    max_shown = checked_number("max_points", max_points, lambda count: count >= 0, "a number of points", int)
    sensor = finite_vector("viewpoint", viewpoint)
    is_seen = is_seen_from(array, sensor)
    description = {
        "title": os.path.basename(name) if title is None else title,
        "up": upwards.tolist(), "backs": not is_seen,
        "view": _direction_to_eye(array, sensor, upwards, is_seen).tolist(),
        "planes": [_described(i + 1, plane, upwards) for i, plane in enumerate(planes)],
        "edges": [{"from": edge.start.tolist(), "to": edge.end.tolist()}
                  for edge in find_plane_edges(planes)[0]]}
    from . import _page  # here, so that only those who write a page load it

    single, origin = single_precision(array)
    _page.save(file, json.dumps(description, allow_nan=False), single, origin, numbers, len(planes),
               max_shown)
