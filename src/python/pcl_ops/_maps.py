# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes planes as maps and tables for other programs."""

import csv
import io
import json
import math
import os
import re
from typing import Any, Dict, List, Literal, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._arguments import Up, array_of, file_name
from ._geopackage import geopackage_of
from ._planes import TABLE_COLUMNS, Plane, Planes, plane_list, up_of

# The outline of a plane, then its holes: arrays of corners, of shape (m, 3).
Rings = List[NDArray[np.float64]]


def write_planes(
    path: Union[str, "os.PathLike[str]"], planes: Planes, *, crs: Optional[str] = None,
    hull: Literal["convex", "concave"] = "convex", up: Optional[Up] = None,
    labels: Optional[Sequence[int]] = None,
) -> None:
    """Write planes with their outlines, as --planes of the programs does.

    path: .geojson or .gpkg, maps for QGIS and others, .csv, a table with the outline as the
        column wkt, or .json, the list that pcl_ops_evaluate planes and others read.
    planes: list of Plane.
    crs: for a map, the reference system of the coordinates, as "EPSG:25832"; without it
        programs take them for degrees.
    hull: the kind of outlines, from which the column area follows; "concave" ones have holes.
    up: vector against gravity, or "camera", for slope, aspect and height; None: the up that the
        planes were found with.
    labels: the column id, whole numbers from 0 that differ; None: 1, 2, ..., the numbers that
        pcl_ops.write gives planes.

    Raises OSError if the file cannot be written, ValueError or TypeError if the arguments do
    not fit.
    """
    file = file_name(path)
    name = os.fsdecode(file)
    listed = plane_list("planes", planes)
    upwards = up_of(listed, up)
    ids = _ids(labels, len(listed))
    if hull not in ("convex", "concave"):
        raise ValueError(f"hull: has to be 'convex' or 'concave', not {hull!r:.80}")
    rows = [_row(plane_id, plane, upwards) for plane_id, plane in zip(ids, listed)]
    outlines = [[plane.hull] if len(plane.hull) else [] for plane in listed]
    if hull == "concave":
        concave = [plane.concave_outline() for plane in listed]
        outlines = [rings for rings, _ in concave]
        for row, (_, area) in zip(rows, concave):
            row["area"] = area
    outlines = [_seen_from_above(rings) for rings in outlines]
    extension = os.path.splitext(name)[1].lower()
    if crs is not None and extension not in (".geojson", ".gpkg"):
        raise ValueError(f"crs: is about a .geojson or a .gpkg, not {name}")
    if extension == ".geojson":
        content = _geojson(rows, outlines, crs).encode()
    elif extension == ".gpkg":
        content = geopackage_of(_geojson(rows, outlines, crs), "planes")
    elif extension == ".csv":
        content = _csv(rows, outlines).encode()
    elif extension == ".json":
        content = _json(rows, outlines, listed).encode()
    else:
        raise ValueError(f"{name}: has an unknown extension; give .geojson, .gpkg, .csv or .json")
    from . import _files  # here, so that only those who write a file load it

    _files.replace(file, content)


def _row(plane_id: int, plane: Plane, up: NDArray[np.float64]) -> Dict[str, Any]:
    """The columns of a plane; those of a piece have the id of the plane it lies on."""
    row: Dict[str, Any] = {"id": plane_id}
    if plane.lies_on is not None:
        row["plane"] = plane.lies_on + 1
    row.update(plane.as_dict(up))
    return row


def _ids(labels: Any, plane_count: int) -> Sequence[int]:
    """The labels as ids of so many planes; 1, 2, ... for None."""
    if labels is None or plane_count == np.size(labels) == 0:
        return range(1, plane_count + 1)
    array = array_of("labels", labels, "iu", "0", (plane_count,), "planes")
    if array.min() < 0:
        raise ValueError(f"labels: have to be 0 or more, not {array.min()}")
    # Compared as int: NumPy would compare both as floats. A GeoPackage has no larger ids.
    if int(array.max()) > np.iinfo(np.int64).max:
        raise ValueError(f"labels: have to be below 2^63, not {array.max()}")
    distinct, counts = np.unique(array, return_counts=True)
    if counts.max() > 1:
        raise ValueError(f"labels: {distinct[counts.argmax()]} is there twice; give each plane its own")
    return array.tolist()


def _seen_from_above(rings: Rings) -> Rings:
    """The rings as maps want them, closed: seen from above the outline counter-clockwise, holes clockwise.
    """
    closed_rings = []
    for ring in rings:
        # Relative to a corner, as areas of coordinates far from zero lose digits.
        x, y = (ring - ring[0])[:, :2].T
        twice_area = x @ np.roll(y, -1) - y @ np.roll(x, -1)
        is_outline = not closed_rings
        is_wrong = twice_area < 0.0 if is_outline else twice_area > 0.0
        ring = ring[::-1] if is_wrong else ring
        closed_rings.append(np.vstack([ring, ring[:1]]))
    return closed_rings


def _decimals(rows: Sequence[Dict[str, Any]]) -> int:
    """Decimals of coordinates: 3, or more (up to 12) for a thousandth of the narrowest plane."""
    widths = [row["width"] for row in rows if row["width"] > 0.0]
    return min(12, max([3, *(math.ceil(3 - math.log10(width)) for width in widths)]))


def _number_texts(corner: NDArray[np.float64], decimals: int) -> List[str]:
    """The coordinates of a corner with so many decimals."""
    # A coordinate that is rounded to zero has no sign.
    return [f"{0.0 if abs(value) <= 0.5 * 10.0**-decimals else value:.{decimals}f}"
            for value in corner.tolist()]


def _nested(rings: Rings, decimals: int, separator: str, list_signs: str, corner_signs: str) -> str:
    """The text of a list of rings.

    separator: stands between the numbers of a corner.
    list_signs: the two signs around a list, "[]" or "()".
    corner_signs: the two signs around a corner, "[]", or "" for none.
    """
    texts = []
    for ring in rings:
        coordinates = [separator.join(_number_texts(corner, decimals)) for corner in ring]
        corners = [corner_signs[:1] + text + corner_signs[1:] for text in coordinates]
        texts.append(list_signs[0] + ",".join(corners) + list_signs[1])
    return list_signs[0] + ",".join(texts) + list_signs[1]


def _geojson(rows: Sequence[Dict[str, Any]], outlines: Sequence[Rings], crs: Any) -> str:
    """A map of planes.

    rows: names and values of each plane, the properties of its feature.
    outlines: of each plane, empty if it has no outline.
    """
    text = '{"type":"FeatureCollection",'
    if crs is not None:
        if not (isinstance(crs, str) and re.fullmatch("EPSG:[0-9]{1,7}", crs)):
            raise ValueError(f"crs: has to be as 'EPSG:25832', not {crs!r:.80}")
        code = crs[len("EPSG:"):]
        urn = f"urn:ogc:def:crs:EPSG::{code}"
        text += f'"crs":{{"type":"name","properties":{{"name":"{urn}"}}}},'
    decimals = _decimals(rows)
    features = []
    for row, rings in zip(rows, outlines):
        # As --planes FILE.geojson names them: nx, ny, nz.
        properties = {name.replace("normal_", "n"): value for name, value in row.items()}
        coordinates = _nested(rings, decimals, ",", "[]", "[]")
        # A polygon without area on the map is not valid: upright planes become lines.
        smallest_normal_z = 0.001
        is_upright = (row["orientation"] == "vertical"
                      or abs(row["normal_z"]) < smallest_normal_z)
        kind = "MultiLineString" if is_upright else "Polygon"
        geometry = f'{{"type":"{kind}","coordinates":{coordinates}}}' if rings else "null"
        features.append(
            f'\n{{"type":"Feature","id":{row["id"]},"geometry":{geometry},"properties":'
            f"{json.dumps(properties, separators=(',', ':'), allow_nan=False)}}}")
    return f'{text}"features":[{",".join(features)}\n]}}\n'


def _json(rows: Sequence[Dict[str, Any]], outlines: Sequence[Rings], planes: Planes) -> str:
    """A list of planes as --planes FILE.json of the programs writes it, but without entries
    about the run."""
    entries = []
    for row, rings, plane in zip(rows, outlines, planes):
        entry = {name: row[name] for name in ("id", "orientation", "kind", "points")}
        entry.update(coefficients=plane.coefficients.tolist(), centroid=plane.centroid.tolist(),
                     normal=plane.normal.tolist(), rms=plane.rms)
        if plane.noise is not None:
            entry["noise"] = plane.noise
        entry.update((name, row[name]) for name in ("area", "slope", "aspect", "height"))
        entry["extent"] = {"length": row["length"], "width": row["width"]}
        open_rings = [ring[:-1].tolist() for ring in rings]
        entry["hull"] = open_rings[0] if open_rings else []
        entry["holes"] = open_rings[1:]
        if "plane" in row:
            entry["plane"] = row["plane"]
        entries.append(entry)
    return json.dumps({"planes": entries}, indent=1, allow_nan=False) + "\n"


def _csv(rows: Sequence[Dict[str, Any]], outlines: Sequence[Rings]) -> str:
    """A table of planes, with the outline as well-known text in the last column."""
    stream = io.StringIO()
    table = csv.writer(stream, lineterminator="\n")
    plane_of_piece = ["plane"] if any("plane" in row for row in rows) else []
    columns = ["id", *plane_of_piece, *TABLE_COLUMNS]
    table.writerow([*columns, "wkt"])
    decimals = _decimals(rows)
    for row, rings in zip(rows, outlines):
        wkt = f"POLYGON Z {_nested(rings, decimals, ' ', '()', '')}" if rings else "POLYGON Z EMPTY"
        table.writerow([*(row.get(name) for name in columns), wkt])
    return stream.getvalue()
