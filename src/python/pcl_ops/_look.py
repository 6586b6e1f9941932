# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages that show planes in a browser."""

import colorsys
import json
import os
from typing import Any, Dict, Optional, Union

import numpy as np
from numpy.typing import NDArray

from ._arguments import Points, Vector, direction, place, plane_numbers, points_array, single_precision
from ._planes import Plane, Planes, find_plane_edges, plane_list
from ._segmentation import is_seen_from


def _color(number: int) -> str:
    """The color of a plane: planes next to each other in the list differ clearly.

    The hue turns by the golden angle from one to the next, and the brightness changes.
    """
    hue = number * 0.381966 % 1.0
    parts = colorsys.hsv_to_rgb(hue, (0.85, 0.6, 0.95)[number % 3], (0.9, 0.8, 0.65)[number % 3])
    return "#" + "".join(f"{round(255 * part):02x}" for part in parts)


def _described(number: int, plane: Plane, up: NDArray[np.float64]) -> Dict[str, Any]:
    """What the page says of a plane, by the keys that its script reads."""
    slope = np.degrees(np.arccos(min(abs(float(plane.normal @ up)), 1.0)))
    return {"id": number, "orientation": plane.orientation, "kind": plane.kind, "rms": plane.rms, "area": plane.area,
            "slope": slope, "normal": plane.normal.tolist(), "centroid": plane.centroid.tolist(),
            "hull": plane.hull.tolist(), "holes": [], "color": _color(number)}


def _direction_to_eye(
    points: NDArray[Any], viewpoint: NDArray[np.float64], up: NDArray[np.float64], is_seen: bool
) -> NDArray[np.float64]:
    """From the points towards the eye that first looks at them.

    The eye is on the side of the sensor if that saw all of the points, else it looks from
    above at a slant.
    """
    finite = points[np.isfinite(points).all(axis=1)]
    towards = viewpoint - np.median(finite, axis=0) if is_seen and len(finite) else np.zeros(3)
    if towards.any():
        return towards / np.linalg.norm(towards)
    level = np.cross(up, np.roll(np.eye(3)[np.argmax(np.abs(up))], 1))
    slant = 0.8 * level / np.linalg.norm(level) + 0.6 * up
    return slant / np.linalg.norm(slant)


def _check_shown(points: NDArray[Any], title: Any) -> None:
    """That the page can be written: its script computes with squares, in double precision."""
    finite = points[np.isfinite(points)]
    if len(finite) and np.abs(finite).max() > 1e100:
        raise ValueError("points: some are farther than 1e100 from zero, which no page can show")
    if title is not None and not isinstance(title, str):
        raise TypeError(f"title: has to be a str, not {title!r:.80}")


def write_html(
    path: Union[str, "os.PathLike[str]"], points: Points, labels: NDArray[Any], planes: Planes, *,
    title: Optional[str] = None, up: Optional[Vector] = None,
    viewpoint: Vector = (0.0, 0.0, 0.0), max_points: int = 2_000_000,
) -> None:
    """Write a page that shows a point cloud and its planes in a browser.

    One file that loads nothing from elsewhere: points in the colors of their planes, the
    list of planes, the plane of a point that is clicked, outlines, edges and normals.

    path: of the page, .html.
    points, labels, planes: array of shape (N, 3), and what segment returned for it.
    title: by default the name of the file.
    up: vector against gravity; None: the one that segment was given or found, for its list,
        else z.
    viewpoint: where the sensor was.
    max_points: of more points than this an even sample is shown, with points of each plane.

    Raises OSError where the file cannot be written; it is complete, or as it was.
    """
    axis = getattr(planes, "up", (0.0, 0.0, 1.0)) if up is None else up
    planes = plane_list("planes", planes)
    array = points_array(points)
    _check_shown(array, title)
    numbers = plane_numbers("labels", labels, np.shape(points)[:-1], -1)
    if numbers.max() > len(planes):
        raise ValueError(f"labels: the label {numbers.max() - 1} is none of {len(planes)} planes")
    if not (isinstance(max_points, int) and max_points >= 0):
        raise ValueError(f"max_points: has to be a number of points, not {max_points!r:.80}")
    upwards, sensor = direction("up", axis), place("viewpoint", viewpoint)
    is_seen = is_seen_from(array, sensor)
    description = {
        "title": os.path.basename(os.fsdecode(path)) if title is None else title,
        "up": upwards.tolist(), "backs": not is_seen,
        "view": _direction_to_eye(array, sensor, upwards, is_seen).tolist(),
        "planes": [_described(i + 1, plane, upwards) for i, plane in enumerate(planes)],
        "edges": [{"from": edge.start.tolist(), "to": edge.end.tolist()}
                  for edge in find_plane_edges(planes)[0]]}
    from . import _page  # here, so that only those who write a page load it

    single, origin = single_precision(array)
    _page.save(os.fsencode(path), json.dumps(description, allow_nan=False), single, origin, numbers, len(planes),
               max_points)
