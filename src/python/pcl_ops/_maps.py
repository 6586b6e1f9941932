# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes as maps and tables for other programs."""

import csv
import io
import json
import math
import os
import re
import tempfile
from typing import Any, Dict, List, Literal, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._arguments import Vector
from ._geopackage import geopackage_of
from ._planes import TABLE_COLUMNS, Planes, plane_list

Rings = List[NDArray[np.float64]]


def write_planes(
    path: Union[str, "os.PathLike[str]"], planes: Planes, *, crs: Optional[str] = None,
    hull: Literal["convex", "concave"] = "convex", up: Optional[Vector] = None,
    labels: Optional[Sequence[int]] = None,
) -> None:
    """Write planes with their outlines, as --planes of the programs does.

    path: .geojson or .gpkg, maps for QGIS and others, .csv, a table with the outline as the
        column wkt, or .json, the list that pcl_ops_evaluate planes and others read.
    planes: list of Plane.
    crs: of a map, the reference system of the coordinates, as "EPSG:25832"; without it
        programs take them for degrees.
    hull: the outlines, and the column area by them; "concave" with holes.
    up: vector against gravity, of slope, aspect and height; None: the one that segment was
        given, for its list, else z.
    labels: the column id; None: 1, 2, ..., as write numbers the planes in a cloud.

    Raises OSError where the file cannot be written, ValueError or TypeError where the
    arguments do not fit.
    """
    name = os.fsdecode(path)
    axis = getattr(planes, "up", (0.0, 0.0, 1.0)) if up is None else up
    listed = plane_list("planes", planes)
    numbers = range(1, len(listed) + 1) if labels is None else [int(one) for one in labels]
    if len(numbers) != len(listed):
        raise ValueError(f"labels: {len(numbers)} are not one for each of {len(listed)} planes")
    if hull not in ("convex", "concave"):
        raise ValueError(f"hull: has to be 'convex' or 'concave', not {hull!r:.80}")
    rows = [{"id": number, **plane.as_dict(axis)} for number, plane in zip(numbers, listed)]
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
        text = _geojson(rows, outlines, crs)
    elif extension == ".gpkg":
        return _replace_file(name, geopackage_of(_geojson(rows, outlines, crs), "planes"))
    elif extension == ".csv":
        text = _csv(rows, outlines)
    elif extension == ".json":
        text = _json(rows, outlines, listed)
    else:
        raise ValueError(f"{name}: has an unknown extension; give .geojson, .gpkg, .csv or .json")
    _replace_file(name, text.encode())


def _replace_file(name: str, content: bytes) -> None:
    """Under another name until it is complete: a failure leaves an existing file as it is."""
    target = os.path.realpath(name)
    folder, base = os.path.split(target)
    # One for each call: threads may write one file.
    descriptor, unfinished = tempfile.mkstemp(".part", base + ".", folder)
    try:
        with open(descriptor, "wb") as file:
            file.write(content)
        os.chmod(unfinished, _mode_of(target))
        os.replace(unfinished, target)
    except BaseException:
        os.remove(unfinished)
        raise


def _mode_of(target: str) -> int:
    """That of the file, or of a new one; mkstemp has others not read its files."""
    try:
        return os.stat(target).st_mode & 0o7777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask


def _seen_from_above(rings: Rings) -> Rings:
    """The outline counter-clockwise, its holes clockwise, as maps want them; closed."""
    turned = []
    for ring in rings:
        x, y = (ring - ring[0])[:, :2].T  # far from zero areas have few digits left
        area = x @ np.roll(y, -1) - y @ np.roll(x, -1)
        is_wrong = area < 0.0 if not turned else area > 0.0
        ring = ring[::-1] if is_wrong else ring
        turned.append(np.vstack([ring, ring[:1]]))
    return turned


def _decimals(rows: Sequence[Dict[str, Any]]) -> int:
    """Three, or as many as a thousandth of the narrowest plane takes."""
    widths = [row["width"] for row in rows if row["width"] > 0.0]
    return min(12, max([3, *(math.ceil(3 - math.log10(width)) for width in widths)]))


def _numbers(corner: NDArray[np.float64], decimals: int) -> List[str]:
    # A coordinate that is rounded to zero has no sign.
    return [f"{0.0 if abs(value) <= 0.5 * 10.0**-decimals else value:.{decimals}f}"
            for value in corner.tolist()]


def _nested(rings: Rings, decimals: int, between: str, lists: str, corners: str) -> str:
    """Lists of corners between the two signs of lists; each corner between its own."""
    texts = []
    for ring in rings:
        written = (corners[:1] + between.join(_numbers(corner, decimals)) + corners[1:]
                   for corner in ring)
        texts.append(lists[0] + ",".join(written) + lists[1])
    return lists[0] + ",".join(texts) + lists[1]


def _geojson(rows: Sequence[Dict[str, Any]], outlines: Sequence[Rings], crs: Any) -> str:
    text = '{"type":"FeatureCollection",'
    if crs is not None:
        if not (isinstance(crs, str) and re.fullmatch("EPSG:[0-9]{1,7}", crs)):
            raise ValueError(f"crs: has to be as 'EPSG:25832', not {crs!r:.80}")
        known = f"urn:ogc:def:crs:EPSG::{crs[5:]}"
        text += f'"crs":{{"type":"name","properties":{{"name":"{known}"}}}},'
    decimals = _decimals(rows)
    features = []
    for row, rings in zip(rows, outlines):
        properties = {name.replace("normal_", "n"): value for name, value in row.items()}
        coordinates = _nested(rings, decimals, ",", "[]", "[]")
        # A polygon without area on the map is not valid: facades are lines.
        is_upright = row["orientation"] == "vertical" or abs(row["normal_z"]) < 0.001
        kind = "MultiLineString" if is_upright else "Polygon"
        geometry = f'{{"type":"{kind}","coordinates":{coordinates}}}' if rings else "null"
        features.append(
            f'\n{{"type":"Feature","id":{row["id"]},"geometry":{geometry},"properties":'
            f"{json.dumps(properties, separators=(',', ':'))}}}")
    return f'{text}"features":[{",".join(features)}\n]}}\n'


def _json(rows: Sequence[Dict[str, Any]], outlines: Sequence[Rings], planes: Planes) -> str:
    """As --planes FILE.json of the programs has planes, without what they know of the run."""
    listed = []
    for row, rings, plane in zip(rows, outlines, planes):
        one = {name: row[name] for name in ("id", "orientation", "kind", "points")}
        one.update(coefficients=plane.coefficients.tolist(), centroid=plane.centroid.tolist(),
                   normal=plane.normal.tolist(), rms=plane.rms)
        if plane.noise is not None:
            one["noise"] = plane.noise
        one.update((name, row[name]) for name in ("area", "slope", "aspect", "height"))
        one["extent"] = {"length": row["length"], "width": row["width"]}
        open_rings = [ring[:-1].tolist() for ring in rings]
        one["hull"], one["holes"] = (open_rings or [[]])[0], open_rings[1:]
        listed.append(one)
    return json.dumps({"planes": listed}, indent=1, allow_nan=False) + "\n"


def _csv(rows: Sequence[Dict[str, Any]], outlines: Sequence[Rings]) -> str:
    stream = io.StringIO()
    table = csv.writer(stream, lineterminator="\n")
    table.writerow(["id", *TABLE_COLUMNS, "wkt"])
    decimals = _decimals(rows)
    for row, rings in zip(rows, outlines):
        wkt = f"POLYGON Z {_nested(rings, decimals, ' ', '()', '')}" if rings else "POLYGON Z EMPTY"
        table.writerow([*row.values(), wkt])
    return stream.getvalue()
