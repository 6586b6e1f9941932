# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Other programs open plans, edges, meshes and maps of pcl_ops_segment.

python3 readers_test.py PROGRAMS: the folder of pcl_ops_segment and pcl_ops_simulate. A test is
skipped if its reader is not installed: ezdxf, shapely, ogrinfo (gdal-bin), assimp (assimp-utils).
"""

import collections
import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAMS = pathlib.Path(sys.argv[1])

try:
    import ezdxf
except ImportError:
    ezdxf = None
try:
    import shapely.geometry
    import shapely.validation
except ImportError:
    shapely = None


def output_of(folder, program, *arguments):
    return subprocess.run([program, *arguments], cwd=folder, check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def rounded(value):
    """A value of GeoJSON with its numbers rounded to 9 decimals: GDAL writes only 15 digits."""
    if isinstance(value, dict):
        return {name: rounded(part) for name, part in value.items()}
    if isinstance(value, list):
        return [rounded(part) for part in value]
    return round(value, 9) + 0.0 if isinstance(value, float) else value


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


def write_two_rooms(file):
    """Writes two rooms of 4 m x 3 m, side by side along x, with a wall of 10 cm and a door between them.
    Of the wall at x = 8.1 m only the first of 3 m is there. Points scatter by 2 mm."""
    random_numbers = random.Random(1)
    step = 0.04

    def grid(u, v):
        return [(step * (i + 0.5), step * (j + 0.5))
                for i in range(round(u / step)) for j in range(round(v / step))]

    points = []
    for left in (0.0, 4.1):
        points += [(left + u, v, z) for u, v in grid(4, 3) for z in (0.0, 2.5)]
        points += [(left + u, y, v) for u, v in grid(4, 2.5) for y in (0.0, 3.0)]
    points += [(0.0, u, v) for u, v in grid(3, 2.5)]
    points += [(x, u, v) for u, v in grid(3, 2.5) for x in (4.0, 4.1)
               if not (1.0 < u < 1.9 and v < 2.05)]
    points += [(8.1, u, v) for u, v in grid(1, 2.5)]
    file.write_text("".join(
        "%.4f %.4f %.4f\n" % tuple(c + random_numbers.gauss(0.0, 0.002) for c in point)
        for point in points))


class Readers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        # A room of 6.194 m x 5.779 m x 2.856 m with a door and a window.
        output_of(cls.folder, PROGRAMS / "pcl_ops_simulate", "room.pcd", "--seed", "402",
                  "--points", "300000", "--quiet")
        for names in (("plan.dxf", "edges.dxf", "map.geojson", "mesh.obj"),
                      ("plan.geojson", "edges.geojson"), ("plan.svg",)):
            outputs = [part for name in names for part in (
                {"map.": "--planes", "plan": "--floor-plan", "edge": "--edges", "mesh": "--mesh"}[name[:4]],
                name)]
            output_of(cls.folder, PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", *outputs)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def features(self, name):
        return json.loads((self.folder / name).read_text())["features"]

    def of_layer(self, layer):
        return [one for one in self.features("plan.geojson") if one["properties"]["layer"] == layer]

    def test_a_plan_has_the_walls_openings_and_the_room_of_the_simulator(self):
        (room,) = self.of_layer("ROOM")
        self.assertAlmostEqual(room["properties"]["area"], 35.79, delta=0.02 * 35.79)
        self.assertAlmostEqual(room["properties"]["height"], 2.856, delta=0.01)
        lengths = sorted(one["properties"]["length"] for one in self.of_layer("WALL"))
        for length, true in zip(lengths[-4:], (5.779, 5.779, 6.194, 6.194)):
            self.assertAlmostEqual(length, true, delta=0.01 * true)
        widths = sorted(one["properties"]["length"] for one in self.of_layer("OPENING"))
        self.assertEqual(len(widths), 2)
        for width, true in zip(widths, (0.90, 1.21)):
            self.assertAlmostEqual(width, true, delta=0.05)

    @unittest.skipUnless(ezdxf, "ezdxf is not installed")
    def test_ezdxf_reads_plans_and_edges_in_meters_without_a_complaint(self):
        for name, layers in (("plan.dxf", {"WALL", "OPENING", "ROOM", "TEXT"}),
                             ("edges.dxf", {"EDGE"})):
            drawing = ezdxf.readfile(self.folder / name)
            audit = drawing.audit()
            self.assertEqual([*audit.errors, *audit.fixes], [], name)
            meters = 6  # in DXF
            self.assertEqual(drawing.units, meters)
            self.assertEqual({one.dxf.layer for one in drawing.modelspace()}, layers)
        drawn = collections.Counter(one.dxf.layer for one in
                                    ezdxf.readfile(self.folder / "plan.dxf").modelspace())
        self.assertEqual(drawn["OPENING"], len(self.of_layer("OPENING")))
        self.assertEqual(drawn["ROOM"], 1)

    def test_a_plan_of_two_rooms_has_the_door_between_them_and_dashes_where_no_wall_is(self):
        with tempfile.TemporaryDirectory() as name:
            flat = pathlib.Path(name)
            write_two_rooms(flat / "flat.xyz")
            for plan in ("plan.geojson", "plan.svg", "plan.dxf"):
                output_of(flat, PROGRAMS / "pcl_ops_segment", "flat.xyz", "--quiet", "--floor-plan",
                          plan)
            written = json.loads((flat / "plan.geojson").read_text())["features"]
            features = [one["properties"] for one in written]
            rooms = [one for one in features if one["layer"] == "ROOM"]
            self.assertEqual([one["doors_to"] for one in rooms], ["2", "1"])
            openings = [one for one in features if one["layer"] == "OPENING"]
            self.assertEqual(sorted((one["before"], one["behind"]) for one in openings),
                             [(1, 2), (2, 1)])
            self.assertEqual({one["opening"] for one in openings}, {"door"})
            (unseen,) = [one for one in features if one["layer"] == "UNSEEN"]
            self.assertAlmostEqual(unseen["length"], 2.0, delta=0.05)
            (((start, end),),) = [one["geometry"]["coordinates"] for one in written
                                  if one["properties"]["layer"] == "UNSEEN"]
            for found, true in ((start, (8.1, 1.0)), (end, (8.1, 3.0))):
                self.assertLess(math.dist(found, true), 0.05)
            dashed = [group.get("id") for group in
                      xml.etree.ElementTree.parse(flat / "plan.svg").getroot()
                      if group.get("stroke-dasharray")]
            self.assertEqual(dashed, ["UNSEEN"])
            if ezdxf:
                drawing = ezdxf.readfile(flat / "plan.dxf")
                audit = drawing.audit()
                self.assertEqual([*audit.errors, *audit.fixes], [])
                self.assertEqual([layer.dxf.name for layer in drawing.layers
                                  if layer.dxf.linetype == "DASHED"], ["UNSEEN"])
                self.assertEqual(len(drawing.modelspace().query('*[layer=="UNSEEN"]')), 1)

    @unittest.skipUnless(ezdxf, "ezdxf is not installed")
    def test_texts_of_a_dxf_say_area_and_height(self):
        # ezdxf does not decode the code of DXF for a superscript two.
        texts = [one.dxf.text.replace(r"\U+00B2", "\u00b2") for one in
                 ezdxf.readfile(self.folder / "plan.dxf").modelspace().query("TEXT")]
        (room,) = self.of_layer("ROOM")
        self.assertEqual(texts, [f"{room['properties']['area']:.2f} m\u00b2",
                                 f"h = {room['properties']['height']:.2f} m"])

    @unittest.skipUnless(shapely, "shapely is not installed")
    def test_geos_calls_all_geometries_valid(self):
        for name in ("map.geojson", "plan.geojson", "edges.geojson"):
            for feature in self.features(name):
                shape = shapely.geometry.shape(feature["geometry"])
                self.assertTrue(shape.is_valid, (name, shapely.validation.explain_validity(shape)))

    def test_a_facade_on_a_map_is_a_line(self):
        for feature in self.features("map.geojson"):
            is_upright = feature["properties"]["orientation"] == "vertical"
            self.assertEqual(feature["geometry"]["type"],
                             "MultiLineString" if is_upright else "Polygon")

    @needs("ogrinfo")
    def test_gdal_reads_them_all(self):
        for name in ("plan.dxf", "edges.dxf", "map.geojson", "plan.geojson", "edges.geojson"):
            said = output_of(self.folder, "ogrinfo", "-al", "-so", "-ro", name)
            self.assertRegex(said, "Feature Count: [1-9]", name)

    def test_properties_have_names_that_a_shapefile_takes(self):
        output_of(self.folder, PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", "--pieces",
                  "--planes", "pieces.geojson")
        for name in ("plan.geojson", "edges.geojson", "map.geojson", "pieces.geojson"):
            for feature in self.features(name):
                # Shapefiles take 10 characters. Only orientation is longer: its name is that of the list
                # of planes (files.md).
                names = [one for one in feature["properties"] if one != "orientation"]
                self.assertLessEqual(max(map(len, names)), 10)
                self.assertNotIn("orientatio", names)

    @needs("ogrinfo")
    def test_gdal_reads_geopackages_as_it_reads_geojson(self):
        done = subprocess.run(
            [PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", "--planes", "map.gpkg",
             "--edges", "edges.gpkg", "--floor-plan", "plan.gpkg", "--crs", "EPSG:25832"],
            cwd=self.folder, text=True, stderr=subprocess.PIPE)
        if "libsqlite3-dev" in done.stderr:
            self.skipTest("built without SQLite")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name, layer in (("map", "planes"), ("edges", "edges"), ("plan", "plan")):
            said = output_of(self.folder, "ogrinfo", "-ro", "-so", name + ".gpkg", layer)
            self.assertIn("ETRS89 / UTM zone 32N", said)
            output_of(self.folder, "ogr2ogr", "again.geojson", name + ".gpkg", layer)
            again = self.features("again.geojson")
            (self.folder / "again.geojson").unlink()
            once = self.features(name + ".geojson")
            self.assertEqual(len(again), len(once))
            for one, other in zip(again, once):
                self.assertEqual(*(json.dumps(rounded(feature["geometry"])) for feature in (one, other)))
                self.assertEqual(*({name: rounded(value) for name, value in feature["properties"].items()
                                    if value is not None} for feature in (one, other)))

    def test_a_map_has_the_same_bytes_again(self):
        texts = []
        for name in ("once.gpkg", "twice.gpkg"):
            done = subprocess.run([PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", "--planes", name],
                                  cwd=self.folder, text=True, stderr=subprocess.PIPE)
            if "libsqlite3-dev" in done.stderr:
                self.skipTest("built without SQLite")
            texts.append((self.folder / name).read_bytes())
        self.assertEqual(*texts)

    @needs("assimp")
    def test_assimp_reads_the_mesh(self):
        said = output_of(self.folder, "assimp", "info", "mesh.obj")
        self.assertRegex(said, "Faces: *[1-9]")

    def test_a_mesh_names_vertices_that_it_has(self):
        lines = [line.split() for line in (self.folder / "mesh.obj").read_text().splitlines()]
        vertices = sum(line[0] == "v" for line in lines)
        corners = [int(corner) for line in lines if line[0] == "f" for corner in line[1:]]
        self.assertEqual((min(corners), max(corners)), (1, vertices))

    def test_an_svg_is_on_paper_at_a_scale(self):
        drawing = xml.etree.ElementTree.parse(self.folder / "plan.svg").getroot()
        self.assertTrue(drawing.get("width").endswith("mm"))
        texts = [one.text for one in drawing.iter("{http://www.w3.org/2000/svg}text")]
        self.assertRegex(texts[-1], "^[125]0* m, 1:[125]0*$")
        if "PCL_OPS_PICTURES" in os.environ:
            shutil.copy(self.folder / "plan.svg", os.environ["PCL_OPS_PICTURES"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
