# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Maps as GeoPackages (OGC 12-128r18), as the programs write them."""

import json
import os
import pathlib
import struct
import tempfile
from typing import Any, Dict, List, Tuple

# The number that the standard gives to undefined Cartesian reference systems.
_UNKNOWN_SYSTEM = -1

Box = Tuple[float, float, float, float]  # min x, max x, min y, max y


def _tables_of_all() -> str:
    """SQL that makes the tables of every GeoPackage; the programs use the same."""
    return pathlib.Path(__file__).with_name("geopackage.sql").read_text(encoding="utf-8")


def geopackage_of(geojson: str, layer: str) -> bytes:
    """A GeoPackage with the features of a map, polygons and lines in space, as one layer.

    geojson: the map, with its reference system in "crs" if it has one.
    """
    import sqlite3  # not every build of Python has it

    collection = json.loads(geojson)
    system = _system_of(collection)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "map.gpkg")
        database = sqlite3.connect(file)
        try:
            database.executescript(_tables_of_all())
            if system > 0:
                # The definition of the system is left out: readers know it by its number.
                database.execute(
                    "INSERT OR IGNORE INTO gpkg_spatial_ref_sys VALUES "
                    "(?, ?, 'EPSG', ?, 'undefined', NULL)", (f"EPSG:{system}", system, system))
            boxes = _add_features(database, collection["features"], layer, system)
            _add_contents(database, layer, system, boxes)
            database.commit()
        finally:
            database.close()
        with open(file, "rb") as stream:
            return stream.read()


def _system_of(collection: Dict[str, Any]) -> int:
    """The EPSG number of the reference system of a GeoJSON."""
    if "crs" not in collection:
        return _UNKNOWN_SYSTEM
    return int(collection["crs"]["properties"]["name"].rsplit(":", 1)[1])


def _column_types(features: List[Dict[str, Any]]) -> Dict[str, str]:
    """The SQL type of each property of the features; empty for one that is always null."""
    types: Dict[str, str] = {}
    for feature in features:
        for name, value in feature["properties"].items():
            known = types.setdefault(name, "")
            if isinstance(value, str):
                types[name] = "TEXT"
            elif isinstance(value, float):
                types[name] = "REAL"
            elif value is not None and known != "REAL":
                types[name] = "INTEGER"
    return types


def _add_features(database: Any, features: List[Dict[str, Any]], layer: str, system: int) -> List[Box]:
    """Makes the table of a layer; returns the box of each feature that has a geometry."""
    types = _column_types(features)
    columns = "".join(f', "{name}" {sql_type or "TEXT"}' for name, sql_type in types.items())
    database.execute(f'CREATE TABLE "{layer}" (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, '
                     f"geom GEOMETRY{columns})")
    boxes = []
    for feature in features:
        blob = None
        if feature["geometry"] is not None:
            blob, box = _blob_of(feature["geometry"], system)
            boxes.append(box)
        values = [feature["properties"].get(name) for name in types]
        database.execute(f'INSERT INTO "{layer}" VALUES (NULL, ?{", ?" * len(values)})', [blob, *values])
    return boxes


def _add_contents(database: Any, layer: str, system: int, boxes: List[Box]) -> None:
    """Registers a layer; its limits are those of all boxes, or 0 if there are none."""
    min_x, max_x, min_y, max_y = list(zip(*boxes)) or [(0.0,)] * 4
    limits = min(min_x), min(min_y), max(max_x), max(max_y)
    # A fixed time of writing, so that the same map has the same bytes.
    database.execute("INSERT INTO gpkg_contents VALUES (?, 'features', ?, '', '1970-01-01T00:00:00.000Z', "
                     "?, ?, ?, ?, ?)", (layer, layer, *limits, system))
    heights_optional, measures_prohibited = 2, 0
    database.execute("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'GEOMETRY', ?, ?, ?)",
                     (layer, system, heights_optional, measures_prohibited))


def _blob_of(geometry: Dict[str, Any], system: int) -> Tuple[bytes, Box]:
    """A geometry as a GeoPackage has it, and its box.

    It is a header with the reference system and the box, then well-known binary (ISO 13249-3).
    """
    parts: List[bytes] = []
    positions: List[List[float]] = []
    _write_geometry(geometry["type"], geometry["coordinates"], parts, positions)
    x, y = zip(*(position[:2] for position in positions))
    box = min(x), max(x), min(y), max(y)
    version, little_endian_with_box = 0, 3  # the latter are flags
    return struct.pack("<2sBBi4d", b"GP", version, little_endian_with_box, system, *box) + b"".join(parts), box


def _write_geometry(kind: str, coordinates: Any, parts: List[bytes], positions: List[List[float]]) -> None:
    """Appends the binary of a geometry to parts, and its positions to positions."""
    codes = {"LineString": 1002, "Polygon": 1003, "MultiLineString": 1005}  # of those with z
    little_endian = 1
    parts.append(struct.pack("<BII", little_endian, codes[kind], len(coordinates)))
    for part in coordinates:
        if kind == "MultiLineString":
            _write_geometry("LineString", part, parts, positions)
        elif kind == "Polygon":
            parts.append(struct.pack("<I", len(part)))
            for position in part:
                _write_position(position, parts, positions)
        else:
            _write_position(part, parts, positions)


def _write_position(
    position: List[float], parts: List[bytes], positions: List[List[float]]
) -> None:
    """The same for one position x, y, z."""
    parts.append(struct.pack("<3d", *position))
    positions.append(position)
