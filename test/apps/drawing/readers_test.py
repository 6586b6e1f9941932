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
    """The standard output of a program that is run in a folder; raises if the program fails."""
    return subprocess.run([program, *arguments], cwd=folder, check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def rounded(value):
    """A value of GeoJSON with its numbers rounded to 9 decimals: GDAL writes only 15 digits."""
    if isinstance(value, dict):
        return {name: rounded(part) for name, part in value.items()}
    if isinstance(value, list):
        return [rounded(part) for part in value]
    if isinstance(value, float):
        return round(value, 9) + 0.0  # 0.0 in place of -0.0
    return value


def needs(program):
    """Skips a test where a program is not installed."""
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


def grid(length, width):
    """Positions of points 4 cm apart on a rectangle of a length and a width [m]."""
    spacing = 0.04
    return [(spacing * (i + 0.5), spacing * (j + 0.5))
            for i in range(round(length / spacing)) for j in range(round(width / spacing))]


def write_two_rooms(file):
    """Writes two rooms of 4 m x 3 m, 2.5 m high, side by side along x.

    Between them are a wall of 10 cm and a door. Of the wall at x = 8.1 m, which is 3 m long, only
    the first meter is there. Points scatter by 2 mm.
    """
    points = []
    for room_x in (0.0, 4.1):
        points += [(room_x + x, y, z) for x, y in grid(4, 3) for z in (0.0, 2.5)]
        points += [(room_x + x, y, z) for x, z in grid(4, 2.5) for y in (0.0, 3.0)]
    points += [(0.0, y, z) for y, z in grid(3, 2.5)]
    for y, z in grid(3, 2.5):
        is_in_door = 1.0 < y < 1.9 and z < 2.05
        if not is_in_door:
            points += [(4.0, y, z), (4.1, y, z)]
    points += [(8.1, y, z) for y, z in grid(1, 2.5)]
    random_numbers = random.Random(1)
    noise = 0.002  # standard deviation of each coordinate [m]
    with file.open("w") as stream:
        for point in points:
            x, y, z = (coordinate + random_numbers.gauss(0.0, noise) for coordinate in point)
            stream.write(f"{x:.4f} {y:.4f} {z:.4f}\n")


def present(properties):
    """Properties without those that are null."""
    return {name: value for name, value in properties.items() if value is not None}


def properties_of(features, layer):
    """The properties of the features of a plan that are on a layer."""
    return [feature["properties"] for feature in features
            if feature["properties"]["layer"] == layer]


class SimulatedRoom(unittest.TestCase):
    """Outputs for one simulated room."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        # A room of 6.194 m x 5.779 m x 2.856 m with a door 0.90 m and a window 1.21 m wide.
        output_of(cls.folder, PROGRAMS / "pcl_ops_simulate", "room.pcd", "--seed", "402",
                  "--points", "300000", "--quiet")
        for outputs in (("--floor-plan", "plan.dxf", "--edges", "edges.dxf",
                         "--planes", "map.geojson", "--mesh", "mesh.obj"),
                        ("--floor-plan", "plan.geojson", "--edges", "edges.geojson"),
                        ("--floor-plan", "plan.svg")):
            output_of(cls.folder, PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", *outputs)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def features(self, name):
        """The features of a GeoJSON file; fails if there are none."""
        features = json.loads((self.folder / name).read_text())["features"]
        self.assertTrue(features, name)
        return features

    def properties_in_plan(self, layer):
        return properties_of(self.features("plan.geojson"), layer)

    def test_a_plan_has_the_walls_openings_and_the_room_of_the_simulator(self):
        (room,) = self.properties_in_plan("ROOM")
        self.assertAlmostEqual(room["area"], 35.79, delta=0.02 * 35.79)
        self.assertAlmostEqual(room["height"], 2.856, delta=0.01)
        lengths = sorted(wall["length"] for wall in self.properties_in_plan("WALL"))
        self.assertGreaterEqual(len(lengths), 4)
        for length, simulated in zip(lengths[-4:], (5.779, 5.779, 6.194, 6.194)):
            self.assertAlmostEqual(length, simulated, delta=0.01 * simulated)
        widths = sorted(opening["length"] for opening in self.properties_in_plan("OPENING"))
        self.assertEqual(len(widths), 2)
        for width, simulated in zip(widths, (0.90, 1.21)):
            self.assertAlmostEqual(width, simulated, delta=0.05)

    @unittest.skipUnless(ezdxf, "ezdxf is not installed")
    def test_ezdxf_reads_plans_and_edges_in_meters_without_a_complaint(self):
        for name, layers in (("plan.dxf", {"WALL", "OPENING", "ROOM", "TEXT"}),
                             ("edges.dxf", {"EDGE"})):
            drawing = ezdxf.readfile(self.folder / name)
            audit = drawing.audit()
            self.assertEqual([*audit.errors, *audit.fixes], [], name)
            code_of_meters = 6  # in DXF
            self.assertEqual(drawing.units, code_of_meters)
            self.assertEqual({entity.dxf.layer for entity in drawing.modelspace()}, layers)
        plan = ezdxf.readfile(self.folder / "plan.dxf")
        drawn = collections.Counter(entity.dxf.layer for entity in plan.modelspace())
        self.assertEqual(drawn["OPENING"], len(self.properties_in_plan("OPENING")))
        self.assertEqual(drawn["ROOM"], 1)

    @unittest.skipUnless(ezdxf, "ezdxf is not installed")
    def test_texts_of_a_dxf_plan_say_area_and_height_of_the_room(self):
        # ezdxf does not decode the code of DXF for a superscript two.
        plan = ezdxf.readfile(self.folder / "plan.dxf")
        texts = [entity.dxf.text.replace(r"\U+00B2", "\u00b2")
                 for entity in plan.modelspace().query("TEXT")]
        (room,) = self.properties_in_plan("ROOM")
        self.assertEqual(texts, [f"{room['area']:.2f} m\u00b2", f"h = {room['height']:.2f} m"])

    @unittest.skipUnless(shapely, "shapely is not installed")
    def test_geos_calls_all_geometries_valid(self):
        for name in ("map.geojson", "plan.geojson", "edges.geojson"):
            for feature in self.features(name):
                shape = shapely.geometry.shape(feature["geometry"])
                self.assertTrue(shape.is_valid, (name, shapely.validation.explain_validity(shape)))

    def test_a_vertical_plane_on_a_map_is_a_line(self):
        types = {(feature["properties"]["orientation"] == "vertical", feature["geometry"]["type"])
                 for feature in self.features("map.geojson")}
        self.assertEqual(types, {(True, "MultiLineString"), (False, "Polygon")})

    @needs("ogrinfo")
    def test_gdal_finds_features_in_plans_edges_and_maps(self):
        for name in ("plan.dxf", "edges.dxf", "map.geojson", "plan.geojson", "edges.geojson"):
            summary = output_of(self.folder, "ogrinfo", "-al", "-so", "-ro", name)
            self.assertRegex(summary, "Feature Count: [1-9]", name)

    def test_properties_have_names_that_differ_in_a_shapefile(self):
        output_of(self.folder, PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", "--pieces",
                  "--planes", "pieces.geojson")
        for name in ("plan.geojson", "edges.geojson", "map.geojson", "pieces.geojson"):
            for feature in self.features(name):
                # Shapefiles cut names to 10 characters. Of "orientation", the only longer name,
                # "orientatio" is left.
                names = [name for name in feature["properties"] if name != "orientation"]
                self.assertLessEqual(max(map(len, names)), 10)
                self.assertNotIn("orientatio", names)

    @needs("ogrinfo")
    def test_gdal_reads_geopackages_as_it_reads_geojson(self):
        done = self.write_geopackages("--planes", "map.gpkg", "--edges", "edges.gpkg",
                                      "--floor-plan", "plan.gpkg", "--crs", "EPSG:25832")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name, layer in (("map", "planes"), ("edges", "edges"), ("plan", "plan")):
            summary = output_of(self.folder, "ogrinfo", "-ro", "-so", name + ".gpkg", layer)
            self.assertIn("ETRS89 / UTM zone 32N", summary)
            output_of(self.folder, "ogr2ogr", "converted.geojson", name + ".gpkg", layer)
            converted = self.features("converted.geojson")
            (self.folder / "converted.geojson").unlink()  # ogr2ogr replaces no GeoJSON
            expected = self.features(name + ".geojson")
            self.assertEqual(len(converted), len(expected))
            for pair in zip(converted, expected):
                self.assertEqual(*(json.dumps(rounded(feature["geometry"])) for feature in pair))
                self.assertEqual(*(rounded(present(feature["properties"])) for feature in pair))

    def write_geopackages(self, *outputs):
        """Runs pcl_ops_segment; skips the test if the program cannot write GeoPackages."""
        done = subprocess.run([PROGRAMS / "pcl_ops_segment", "room.pcd", "--quiet", *outputs],
                              cwd=self.folder, text=True, stderr=subprocess.PIPE)
        if "libsqlite3-dev" in done.stderr:
            self.skipTest("built without SQLite")
        return done

    def test_a_geopackage_has_the_same_bytes_if_it_is_written_again(self):
        contents = []
        for name in ("once.gpkg", "twice.gpkg"):
            self.write_geopackages("--planes", name)
            contents.append((self.folder / name).read_bytes())
        self.assertEqual(*contents)

    @needs("assimp")
    def test_assimp_finds_faces_in_the_mesh(self):
        summary = output_of(self.folder, "assimp", "info", "mesh.obj")
        self.assertRegex(summary, "Faces: *[1-9]")

    def test_faces_of_a_mesh_use_its_first_to_its_last_vertex(self):
        vertex_count, corners = 0, []
        for line in (self.folder / "mesh.obj").read_text().splitlines():
            keyword, *words = line.split()
            if keyword == "v":
                vertex_count += 1
            elif keyword == "f":
                corners += map(int, words)  # numbers of vertices, from 1
        self.assertEqual((min(corners), max(corners)), (1, vertex_count))

    def test_an_svg_is_on_paper_at_a_scale(self):
        drawing = xml.etree.ElementTree.parse(self.folder / "plan.svg").getroot()
        self.assertTrue(drawing.get("width").endswith("mm"))
        texts = [element.text for element in drawing.iter("{http://www.w3.org/2000/svg}text")]
        self.assertRegex(texts[-1], "^[125]0* m, 1:[125]0*$")  # length of the bar, scale
        # If PCL_OPS_PICTURES names a folder, the plan stays there for people to look at.
        if "PCL_OPS_PICTURES" in os.environ:
            shutil.copy(self.folder / "plan.svg", os.environ["PCL_OPS_PICTURES"])


class TwoRooms(unittest.TestCase):
    """Plans of two rooms with a door between them and a wall that is not seen as a whole."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        write_two_rooms(cls.folder / "flat.xyz")
        for plan in ("plan.geojson", "plan.svg", "plan.dxf"):
            output_of(cls.folder, PROGRAMS / "pcl_ops_segment", "flat.xyz", "--quiet",
                      "--floor-plan", plan)
        cls.features = json.loads((cls.folder / "plan.geojson").read_text())["features"]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_have_a_door_to_each_other(self):
        rooms = properties_of(self.features, "ROOM")
        self.assertEqual([room["doors_to"] for room in rooms], ["2", "1"])
        openings = properties_of(self.features, "OPENING")
        self.assertEqual(sorted((opening["before"], opening["behind"]) for opening in openings),
                         [(1, 2), (2, 1)])
        self.assertEqual({opening["opening"] for opening in openings}, {"door"})

    def test_have_an_unseen_line_where_no_wall_is(self):
        (unseen,) = [feature for feature in self.features
                     if feature["properties"]["layer"] == "UNSEEN"]
        self.assertAlmostEqual(unseen["properties"]["length"], 2.0, delta=0.05)
        ((start, end),) = unseen["geometry"]["coordinates"]
        self.assertLess(math.dist(start, (8.1, 1.0)), 0.05)
        self.assertLess(math.dist(end, (8.1, 3.0)), 0.05)

    def test_have_a_dashed_unseen_line_in_svg(self):
        drawing = xml.etree.ElementTree.parse(self.folder / "plan.svg").getroot()
        dashed = [group.get("id") for group in drawing if group.get("stroke-dasharray")]
        self.assertEqual(dashed, ["UNSEEN"])

    @unittest.skipUnless(ezdxf, "ezdxf is not installed")
    def test_have_a_dashed_unseen_line_in_dxf(self):
        drawing = ezdxf.readfile(self.folder / "plan.dxf")
        audit = drawing.audit()
        self.assertEqual([*audit.errors, *audit.fixes], [])
        dashed = [layer.dxf.name for layer in drawing.layers if layer.dxf.linetype == "DASHED"]
        self.assertEqual(dashed, ["UNSEEN"])
        self.assertEqual(len(drawing.modelspace().query('*[layer=="UNSEEN"]')), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
