# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a page of pcl_ops_segment --view has and, where Chromium is installed, shows.

python3 browser_test.py PROGRAMS: the folder of the programs.
"""

import base64
import collections
import html
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
CHROMIUM = (shutil.which("chromium") or shutil.which("chromium-browser")
            or shutil.which("google-chrome"))
WIDTH, HEIGHT = 900, 600  # of the window [pixel]

# A filter is the first byte of a line of pixels in a PNG; 0 stands for no filter.
SUB, UP, AVERAGE, PAETH = 1, 2, 3, 4

# Put before everything else on the page: collects the messages of errors and warnings.
WATCH = """<script>
const problems = [];
addEventListener('error', event => problems.push(event.message));
console.error = console.warn = (...words) => problems.push(words.join(' '));
</script>"""
# Put behind everything else on the page: runs SCRIPT after 1.5 s, when the page is drawn. What
# SCRIPT returns and the problems go into the attribute data-result of the body. SCRIPT may use
# these functions and all names of viewer.js.
ACT = """<script>
// Returns the number of pixels with points.
function drawnPixels() {
  draw();
  const bytes = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bytes.filter((byte, i) => i % 4 === 3 && byte).length;
}
// Switches all off but the plane with index i.
function showOnly(i) {
  for (const id of ['none', 'rest'])  // all planes, and points on no plane
    element(id).click();
  element('rows').children[i].querySelector('input').click();
}
function click(x, y) {
  for (const kind of ['pointerdown', 'pointerup'])
    element('points').dispatchEvent(new PointerEvent(
      kind, {clientX: x, clientY: y, pointerId: 1, bubbles: true}));
}
setTimeout(() => {
  const result = (() => { SCRIPT })();
  document.body.setAttribute('data-result', JSON.stringify({result, problems}));
}, 1500);
</script>"""


def run(folder, *command):
    """Runs a program in a folder and returns its standard output; raises if the program fails."""
    return subprocess.run([PROGRAMS / command[0], *command[1:]], cwd=folder, check=True,
                          stdout=subprocess.PIPE, text=True).stdout


def part_of(page, name):
    """The text of the script element of a page with this id."""
    return re.search(rf'id="{name}">(.*?)</script>', page, re.DOTALL)[1]


def pixels_of(png):
    """For each (red, green, blue), the number of pixels of a PNG file that have it.

    The PNG has 8 bits in RGB or RGBA.
    """
    packed = b""
    for kind, content in chunks_of(png.read_bytes()):
        if kind == b"IHDR":
            width, height, _, color_type = struct.unpack(">IIBB", content[:10])
        elif kind == b"IDAT":
            packed += content
    pixel_size = {2: 3, 6: 4}[color_type]  # [byte] for RGB and RGBA
    lines, line_size = zlib.decompress(packed), pixel_size * width
    above, counts = bytearray(line_size), collections.Counter()
    for row in range(height):
        start = row * (1 + line_size)  # a line follows the byte of its filter
        line = bytearray(lines[start + 1:start + 1 + line_size])
        unfilter(lines[start], line, above, pixel_size)
        counts.update(zip(line[0::pixel_size], line[1::pixel_size], line[2::pixel_size]))
        above = line
    return counts


def chunks_of(png):
    """Yields the name and the content of each chunk in the bytes of a PNG."""
    signature_size, head_size, checksum_size = 8, 8, 4  # [byte]
    offset = signature_size
    while offset < len(png):
        size, name = struct.unpack(">I4s", png[offset:offset + head_size])
        offset += head_size
        yield name, png[offset:offset + size]
        offset += size + checksum_size


def unfilter(kind, line, above, pixel_size):
    """Undoes the filter of a line of pixels, in place (PNG specification, section 9.2).

    above is the line above, already without its filter; pixel_size is in bytes.
    """
    for i, byte in enumerate(line):
        left = line[i - pixel_size] if i >= pixel_size else 0
        above_left = above[i - pixel_size] if i >= pixel_size else 0
        if kind == SUB:
            byte += left
        elif kind == UP:
            byte += above[i]
        elif kind == AVERAGE:
            byte += (left + above[i]) // 2
        elif kind == PAETH:
            guess = left + above[i] - above_left
            byte += min((left, above[i], above_left), key=lambda other: abs(guess - other))
        line[i] = byte & 255


def is_shade(pixel, color):
    """Whether a pixel has this color, or the color darkened to 0.6 or more of its brightness."""
    light = max(pixel) / max(color)
    max_rounding = 4  # of a component from 0 to 255
    return 0.6 < light < 1.02 and all(abs(component - light * of_color) < max_rounding
                                      for component, of_color in zip(pixel, color))


def name_of(plane):
    """How the page names a plane: by its kind, or by its orientation if it is of no kind."""
    return plane["orientation"] if plane["kind"] == "other" else plane["kind"]


def largest_difference(first, second):
    """The largest difference of two positions along an axis."""
    return max(abs(a - b) for a, b in zip(first, second))


def distance_to_plane(plane, point):
    """The distance of a point to a plane, positive on the side of its normal."""
    return sum(n * (p - c) for n, p, c in zip(plane["normal"], point, plane["centroid"]))


class Page(unittest.TestCase):
    """A page with a simulated room, and the list of its planes."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        run(cls.folder, "pcl_ops_simulate", "room.pcd", "--seed", "1", "--quiet")
        run(cls.folder, "pcl_ops_segment", "room.pcd", "--quiet", "--view", "room.html",
            "--planes", "room.json")
        cls.page = (cls.folder / "room.html").read_text(encoding="utf-8")
        cls.description = json.loads(part_of(cls.page, "description"))
        cls.planes = json.loads((cls.folder / "room.json").read_text())["planes"]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def chromium(self, page, *options):
        """The standard output of Chromium for the file of a page.

        It needs no graphics card, and no sandbox, which root cannot have.
        """
        command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-dev-shm-usage",
                   "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                   "--hide-scrollbars",
                   f"--user-data-dir={self.folder / 'profile'}", f"--window-size={WIDTH},{HEIGHT}",
                   "--virtual-time-budget=10000", *options, page.as_uri()]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              check=True, timeout=120,
                              env={**os.environ, "HOME": str(self.folder)})
        return done.stdout

    def result_of(self, script):
        """What a script returns on the drawn page; fails if the page reports a problem."""
        page = self.page.replace("<head>", "<head>" + WATCH)
        page = page.replace("</body>", ACT.replace("SCRIPT", script) + "</body>")
        file = self.folder / "with_script.html"
        file.write_text(page, encoding="utf-8")
        dom = self.chromium(file, "--dump-dom")
        found = re.search(r'data-result="([^"]*)"', dom)
        self.assertTrue(found, "the script did not end")
        outcome = json.loads(html.unescape(found[1]))
        self.assertEqual(outcome["problems"], [])
        return outcome["result"]


class Data(Page):
    """The data in the page, read without a browser."""

    def test_has_the_planes_of_the_list_with_their_points(self):
        groups = json.loads(part_of(self.page, "groups"))
        self.assertGreater(len(self.planes), 0)
        self.assertEqual(len(self.description["planes"]), len(self.planes))
        self.assertEqual(len(groups), len(self.planes) + 1)  # the last one: points on no plane
        for plane, shown, group in zip(self.planes, self.description["planes"], groups):
            self.assertEqual(plane, {name: shown[name] for name in plane})
            self.assertRegex(shown["color"], "^#[0-9a-f]{6}$")
            self.assertEqual((group["all"], group["shown"]), (plane["points"], plane["points"]))
        self.assertEqual(self.description["title"], "room.pcd")
        self.assertEqual(self.description["up"], [0.0, 0.0, 1.0])
        self.assertGreater(len(self.description["edges"]), 0)

    def test_hides_planes_from_behind_in_a_room_but_not_in_a_survey(self):
        self.assertFalse(self.description["backs"])
        run(self.folder, "pcl_ops_simulate", "survey.pcd", "--scene", "survey", "--points", "20000",
            "--quiet")
        run(self.folder, "pcl_ops_segment", "survey.pcd", "--quiet", "--view", "survey.html")
        survey = (self.folder / "survey.html").read_text(encoding="utf-8")
        self.assertTrue(json.loads(part_of(survey, "description"))["backs"])

    def test_of_tiles_has_the_planes_of_the_run_with_their_points(self):
        run(self.folder, "pcl_ops_simulate", "town", "--scene", "town", "--points", "20000",
            "--quiet")
        run(self.folder, "pcl_ops_tiles", "town", "--output-dir", "out", "--tile", "60", "--quiet",
            "--view", "town.html")
        page = (self.folder / "town.html").read_text(encoding="utf-8")
        description = json.loads(part_of(page, "description"))
        found = json.loads((self.folder / "out" / "planes.json").read_text())
        groups = json.loads(part_of(page, "groups"))
        self.assertGreater(len(found["planes"]), 0)
        self.assertEqual(len(description["planes"]), len(found["planes"]))
        self.assertEqual(len(groups), len(found["planes"]) + 1)
        for shown, plane, group in zip(description["planes"], found["planes"], groups):
            del shown["color"]
            self.assertEqual({name: plane[name] for name in shown}, shown)
            self.assertEqual((group["all"], group["shown"]), (plane["points"], plane["points"]))
            # The centroid is within the bounding box of the points.
            for low, step, middle in zip(group["origin"], group["step"], plane["centroid"]):
                high = low + 65535 * step
                self.assertTrue(low <= middle <= high)
        self.assertEqual(sum(group["all"] for group in groups), found["points"])
        self.assertGreater(description["view"][2], 0.3)  # from above
        self.assertGreater(len(description["edges"]), 0)

    def test_has_points_on_their_planes(self):
        # For each point its numbers of steps along x, y and z, of 16 bits.
        numbers = memoryview(base64.b64decode(part_of(self.page, "steps"))).cast("H")
        group, plane = json.loads(part_of(self.page, "groups"))[0], self.planes[0]
        squared_distances = 0.0
        for i in range(group["shown"]):
            steps = numbers[3 * i:3 * i + 3]
            point = [origin + length * number for origin, length, number in
                     zip(group["origin"], group["step"], steps)]
            squared_distances += distance_to_plane(plane, point)**2
        rms = (squared_distances / group["shown"])**0.5
        self.assertAlmostEqual(rms, plane["rms"], delta=0.02 * plane["rms"])


@unittest.skipUnless(CHROMIUM, "there is no Chromium here")
class Browser(Page):
    """What the page shows and does in Chromium."""

    def screenshot(self, name, *options):
        """The number of pixels of each color of the page."""
        # If PCL_OPS_PICTURES names a folder, the picture stays there for people to look at.
        picture = pathlib.Path(os.environ.get("PCL_OPS_PICTURES", self.folder), name)
        self.chromium(self.folder / "room.html", f"--screenshot={picture}", *options)
        return pixels_of(picture)

    def test_draws_the_largest_planes_in_their_colors(self):
        pixels = self.screenshot("page.png")
        for plane in self.description["planes"][:5]:
            color = bytes.fromhex(plane["color"].lstrip("#"))
            in_color = sum(count for pixel, count in pixels.items() if is_shade(pixel, color))
            self.assertGreater(in_color, 1000, plane["id"])
        white = (255, 255, 255)
        self.assertGreater(pixels[white], 10000)

    def test_is_dark_where_the_browser_is(self):
        pixels = self.screenshot("page_dark.png", "--blink-settings=preferredColorScheme=0")
        white, dark_background = (255, 255, 255), (0x16, 0x18, 0x1b)
        self.assertLess(pixels[white], 3000)
        self.assertGreater(pixels[dark_background], 10000)

    def test_lists_all_planes(self):
        rows = self.result_of("""
          const wordsOf = row => row.innerText.split(/\\s+/).filter(word => word);
          return [...element('rows').children].map(wordsOf);""")
        self.assertEqual(len(rows), len(self.planes))
        for row, plane in zip(rows, self.planes):
            number, name, points, area, rms, slope = row
            self.assertEqual([number, name, points],
                             [str(plane["id"]), name_of(plane), str(plane["points"])])
            self.assertAlmostEqual(float(area), plane["area"], delta=0.01 * plane["area"])
            self.assertAlmostEqual(float(rms), plane["rms"], delta=0.1 * plane["rms"])
            max_error = 0.06 + 0.01 * plane["slope"]  # a slope has one decimal [degree]
            self.assertAlmostEqual(float(slope), plane["slope"], delta=max_error)

    def test_a_click_says_plane_position_and_distance(self):
        for plane in self.planes[:3]:
            answer, point = self.result_of(f"""
              const i = {plane["id"] - 1}, group = groups[i], first = 3 * group.first;
              const point = group.fromMiddle.map(
                (x, axis) => x + group.step[axis] * steps[first + axis]);
              showOnly(i);  // else another plane may be in front of the point
              look(point, group.normal, radius / 4);
              const box = element('points').getBoundingClientRect();
              click(box.left + box.width / 2, box.top + box.height / 2);
              return [element('answer').textContent, add(point, middle)];""")
            facts, answer = answer.split("; ")
            self.assert_are_facts(facts, plane)
            found = re.fullmatch(
                r"at (\S+), (\S+), (\S+), distance to the plane (\S+) ± (\S+)", answer)
            self.assertTrue(found, answer)
            *shown_point, shown_distance, shown_error = map(float, found.groups())
            self.assertLess(largest_difference(shown_point, point), 0.01)
            expected_distance = distance_to_plane(plane, shown_point)
            self.assertAlmostEqual(shown_distance, expected_distance, delta=0.001)
            self.assertLess(shown_error, 0.001)

    def assert_are_facts(self, text, plane):
        """Fails unless a text says what the list of planes has about a plane."""
        found = re.fullmatch(
            r"plane (\d+), (\w+): (\d+) points, area (\S+), rms (\S+), slope (\S+)", text)
        self.assertTrue(found, text)
        number, name, points, area, rms, slope = found.groups()
        self.assertEqual((int(number), name, int(points)),
                         (plane["id"], name_of(plane), plane["points"]))
        self.assertAlmostEqual(float(area), plane["area"], delta=0.01 * plane["area"])
        self.assertAlmostEqual(float(rms), plane["rms"], delta=0.1 * plane["rms"])
        self.assertAlmostEqual(float(slope), plane["slope"], delta=0.06)  # [degree]

    def test_a_click_on_a_row_marks_it_shows_facts_and_turns_to_the_plane(self):
        marked, answer, target = self.result_of("""
          element('rows').children[1].click();
          return [[...document.querySelectorAll('tr.chosen')].map(row => row.rowIndex),
                  element('answer').textContent, add(camera.target, middle)];""")
        self.assertEqual(marked, [2])  # row 0 has the titles
        self.assert_are_facts(answer, self.planes[1])
        self.assertLess(largest_difference(target, self.planes[1]["centroid"]), 1e-6)

    def test_a_click_on_a_point_marks_the_row_of_its_plane(self):
        marked = self.result_of("""
          const markedRows = () =>
            [...document.querySelectorAll('tr.chosen')].map(row => row.rowIndex);
          const marked = [];
          const onNoPlane = planes.length;
          for (const i of [2, onNoPlane]) {
            choose({i, point: [0, 0, 0]});
            marked.push(markedRows());
          }
          return marked;""")
        self.assertEqual(marked, [[3], []])

    def test_a_second_point_has_its_distance_to_the_first(self):
        first, second, nothing, first_again = self.result_of("""
          const onNoPlane = planes.length;
          const answerTo = found => { choose(found); return element('answer').textContent; };
          return [
            answerTo({i: onNoPlane, point: [1, 0, 0]}),
            answerTo({i: onNoPlane, point: [1, 3, 4]}),
            answerTo(null),
            answerTo({i: onNoPlane, point: [1, 0, 0]})];""")
        self.assertRegex(second, r"; 5\.0+ from the point before$")
        for answer in first, nothing, first_again:
            self.assertNotIn("before", answer)

    def test_lists_and_shows_planes_of_a_kind_or_a_name_alone(self):
        results = self.result_of("""
          const resultOf = (find, kind) => {
            element('find').value = find;
            element('kind').value = kind;
            element('filter').dispatchEvent(new Event('input'));
            const listed = [...element('rows').children].filter(row => !row.hidden);
            return {ids: listed.map(row => row.rowIndex), pixels: drawnPixels(),
              found: element('found').textContent};
          };
          element('rest').click();  // switches the points on no plane off
          return [resultOf('', ''), resultOf('', 'wall'), resultOf('2', ''), resultOf('Wa', ''),
            resultOf('nothing', '')];""")
        unfiltered, by_kind, by_number, by_name, by_unknown_name = results
        walls = [plane["id"] for plane in self.planes if plane["kind"] == "wall"]
        all_ids = [plane["id"] for plane in self.planes]
        self.assertEqual([result["ids"] for result in results], [all_ids, walls, [2], walls, []])
        self.assertGreater(unfiltered["pixels"], by_kind["pixels"])
        self.assertGreater(by_kind["pixels"], 0)
        self.assertEqual(by_name["pixels"], by_kind["pixels"])
        self.assertEqual(by_unknown_name["pixels"], 0)
        self.assertEqual(unfiltered["found"], "")
        self.assertEqual(by_kind["found"], f"{len(walls)} of {len(all_ids)}")

    def test_the_button_no_planes_switches_off_planes_that_are_listed(self):
        are_on = self.result_of("""
          element('kind').value = 'wall';
          element('filter').dispatchEvent(new Event('input'));
          element('none').click();
          return planes.map((plane, i) => groups[i].isOn);""")
        self.assertEqual(are_on, [plane["kind"] != "wall" for plane in self.planes])

    def test_planes_and_layers_are_switched_on_and_off(self):
        pixels = self.result_of("""
          const pixelsAfterClick = on => { on.click(); return drawnPixels(); };
          const largest = element('rows').children[0].querySelector('input');
          const pixels = {all: drawnPixels()};
          pixels.rest = pixelsAfterClick(element('none'));
          pixels.nothing = pixelsAfterClick(element('rest'));
          pixels.planes = pixelsAfterClick(element('all'));
          pixels.withoutLargest = pixelsAfterClick(largest);
          element('none').click();
          pixels.outlines = pixelsAfterClick(element('outlines'));
          pixels.normals = pixelsAfterClick(element('normals'));
          pixels.edges = pixelsAfterClick(element('edges'));
          return pixels;""")
        self.assertGreater(pixels["all"], pixels["planes"])
        self.assertTrue(0 < pixels["rest"] < pixels["all"])
        self.assertEqual(pixels["nothing"], 0)
        self.assertGreater(pixels["planes"], pixels["withoutLargest"])
        self.assertEqual(pixels["outlines"], 0)  # of planes that are off
        self.assertEqual(pixels["normals"], 0)
        self.assertGreater(pixels["edges"], 0)

    def test_planes_are_seen_from_behind_if_backs_are_switched_on(self):
        from_front, from_behind, from_behind_with_backs = self.result_of("""
          showOnly(0);
          const {centroid, normal} = planes[0];
          const pixelsFrom = direction => {
            look(add(centroid, middle, -1), direction, radius);
            return drawnPixels();
          };
          const back = scaled(normal, -1);
          const withoutBacks = [pixelsFrom(normal), pixelsFrom(back)];
          element('backs').click();
          return [...withoutBacks, pixelsFrom(back)];""")
        self.assertGreater(from_front, 1000)
        self.assertEqual(from_behind, 0)
        self.assertGreater(from_behind_with_backs, 1000)

    def test_turns_moves_and_zooms(self):
        cameras = self.result_of("""
          const cameras = [{...camera}];
          const noteCamera = () => cameras.push({...camera});
          const send = (kind, x, y, changed) => canvas.dispatchEvent(new PointerEvent(kind,
            {clientX: x, clientY: y, pointerId: 1, buttons: 1, button: 0, bubbles: true,
              ...changed}));
          send('pointerdown', 200, 200);  // dragged by the left button
          send('pointermove', 260, 200);
          send('pointerup', 260, 200);
          noteCamera();
          const rightButton = {buttons: 2};
          send('pointerdown', 200, 200, rightButton);
          send('pointermove', 200, 260, rightButton);
          send('pointerup', 200, 260);
          noteCamera();
          canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, cancelable: true}));
          noteCamera();
          const secondFinger = {pointerId: 2};  // the fingers move to twice their distance
          send('pointerdown', 200, 200);
          send('pointerdown', 300, 200, secondFinger);
          send('pointermove', 400, 200, secondFinger);
          noteCamera();
          return cameras;""")
        first, turned, moved, nearer, pinched = cameras
        self.assertNotEqual(turned["yaw"], first["yaw"])
        self.assertEqual(turned["target"], first["target"])
        self.assertNotEqual(moved["target"], turned["target"])
        self.assertLess(nearer["distance"], moved["distance"])
        self.assertAlmostEqual(pinched["distance"], nearer["distance"] / 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
