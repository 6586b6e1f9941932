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
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
WIDTH, HEIGHT = 900, 600

# Put before everything else on the page: collects the messages of errors and warnings.
WATCH = """<script>
const problems = [];
addEventListener('error', event => problems.push(event.message));
console.error = console.warn = (...words) => problems.push(words.join(' '));
</script>"""
# Put behind everything else on the page: runs SCRIPT after 1.5 s, when the page is drawn. What
# SCRIPT returns and the problems go into the attribute data-result of the body.
ACT = """<script>
function drawnPixels() {
  draw();
  const bytes = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bytes.filter((byte, i) => i % 4 === 3 && byte).length;
}
function showOnly(i) {
  for (const id of ['none', 'rest'])
    element(id).click();
  element('rows').children[i].querySelector('input').click();
}
function press(x, y) {
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
    return subprocess.run([PROGRAMS / command[0], *command[1:]], cwd=folder, check=True,
                          stdout=subprocess.PIPE, text=True).stdout


def part_of(page, name):
    return re.search(rf'id="{name}">(.*?)</script>', page, re.DOTALL)[1]


def pixels_of(png):
    """For each color, the number of pixels of a PNG that have it. The PNG has 8 bits in RGB or RGBA."""
    signature, checksum = 8, 4  # bytes
    data, offset, packed = png.read_bytes(), signature, b""
    while offset < len(data):
        size, kind = struct.unpack(">I4s", data[offset:offset + 8])
        content = data[offset + 8:offset + 8 + size]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", content[:10])
        elif kind == b"IDAT":
            packed += content
        offset += 8 + size + checksum
    depth = {2: 3, 6: 4}[color]  # bytes of a pixel
    rows, stride = zlib.decompress(packed), depth * width
    before, counts = bytearray(stride), collections.Counter()
    for row in range(height):
        start = row * (stride + 1)
        line = bytearray(rows[start + 1:start + 1 + stride])
        unfilter(rows[start], line, before, depth)
        counts.update(zip(line[0::depth], line[1::depth], line[2::depth]))
        before = line
    return counts


def unfilter(kind, line, above, depth):
    """Undoes the filter of a line of pixels, in place (PNG specification, section 9.2).

    above is the line above, already without its filter; depth is the number of bytes of a pixel.
    """
    for i, number in enumerate(line):
        left = line[i - depth] if i >= depth else 0
        corner = above[i - depth] if i >= depth else 0
        if kind == 1:
            number += left
        elif kind == 2:
            number += above[i]
        elif kind == 3:
            number += (left + above[i]) // 2
        elif kind == 4:
            guess = left + above[i] - corner
            number += min((left, above[i], corner), key=lambda one: abs(guess - one))
        line[i] = number & 255


def is_shade(pixel, color):
    """Whether a pixel has this color, or the color darkened to 0.6 or more of its brightness."""
    light = max(pixel) / max(color)
    return 0.6 < light < 1.02 and all(abs(p - light * c) < 4 for p, c in zip(pixel, color))


def name_of(plane):
    return plane["orientation"] if plane["kind"] == "other" else plane["kind"]


class Page(unittest.TestCase):
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
        command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
                   "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                   f"--user-data-dir={self.folder / 'profile'}", f"--window-size={WIDTH},{HEIGHT}",
                   "--virtual-time-budget=10000", *options, page.as_uri()]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              check=True, timeout=120, env={**os.environ, "HOME": str(self.folder)}).stdout

    def result_of(self, script):
        """What a script returns on the drawn page; fails if the page reports a problem."""
        acting = self.folder / "acting.html"
        page = self.page.replace("<head>", "<head>" + WATCH).replace("</body>", ACT.replace("SCRIPT", script) + "</body>")
        acting.write_text(page, encoding="utf-8")
        dom = self.chromium(acting, "--dump-dom")
        found = re.search(r'data-result="([^"]*)"', dom)
        self.assertTrue(found, "the script did not end")
        outcome = json.loads(html.unescape(found[1]))
        self.assertEqual(outcome["problems"], [])
        return outcome["result"]


class Data(Page):
    def test_has_the_planes_of_the_list_with_their_points(self):
        groups = json.loads(part_of(self.page, "groups"))
        self.assertEqual(len(groups), len(self.planes) + 1)
        for plane, shown, group in zip(self.planes, self.description["planes"], groups):
            self.assertEqual(plane, {name: shown[name] for name in plane})
            self.assertRegex(shown["color"], "^#[0-9a-f]{6}$")
            self.assertEqual((group["all"], group["shown"]), (plane["points"], plane["points"]))
        self.assertEqual(self.description["title"], "room.pcd")
        self.assertEqual(self.description["up"], [0.0, 0.0, 1.0])
        self.assertGreater(len(self.description["edges"]), 0)

    def test_hides_planes_from_behind_where_a_sensor_saw_them_only(self):
        self.assertFalse(self.description["backs"])
        run(self.folder, "pcl_ops_simulate", "survey.pcd", "--scene", "survey", "--points", "20000", "--quiet")
        run(self.folder, "pcl_ops_segment", "survey.pcd", "--quiet", "--view", "survey.html")
        survey = (self.folder / "survey.html").read_text(encoding="utf-8")
        self.assertTrue(json.loads(part_of(survey, "description"))["backs"])

    def test_of_tiles_has_the_planes_of_the_run_with_their_points(self):
        run(self.folder, "pcl_ops_simulate", "town", "--scene", "town", "--points", "20000", "--quiet")
        run(self.folder, "pcl_ops_tiles", "town", "--output-dir", "out", "--tile", "60", "--quiet",
            "--view", "town.html")
        page = (self.folder / "town.html").read_text(encoding="utf-8")
        shown = json.loads(part_of(page, "description"))
        found = json.loads((self.folder / "out" / "planes.json").read_text())
        groups = json.loads(part_of(page, "groups"))
        self.assertEqual(len(groups), len(found["planes"]) + 1)
        for one, plane, group in zip(shown["planes"], found["planes"], groups):
            self.assertEqual({name: plane[name] for name in one if name != "color"},
                             {name: value for name, value in one.items() if name != "color"})
            self.assertEqual((group["all"], group["shown"]), (plane["points"], plane["points"]))
            # The centroid is within the box of the points.
            high = [o + 65535 * s for o, s in zip(group["origin"], group["step"])]
            for low, middle, top in zip(group["origin"], plane["centroid"], high):
                self.assertTrue(low <= middle <= top)
        self.assertEqual(sum(group["all"] for group in groups), found["points"])
        self.assertGreater(shown["view"][2], 0.3)  # from above
        self.assertGreater(len(shown["edges"]), 0)

    def test_has_points_on_their_planes(self):
        numbers = memoryview(base64.b64decode(part_of(self.page, "steps"))).cast("H")
        group, plane = json.loads(part_of(self.page, "groups"))[0], self.planes[0]
        squares = 0.0
        for i in range(group["shown"]):
            point = [o + s * n for o, s, n in zip(group["origin"], group["step"], numbers[3 * i:3 * i + 3])]
            squares += sum(n * (p - c) for n, p, c in zip(plane["normal"], point, plane["centroid"]))**2
        self.assertAlmostEqual((squares / group["shown"])**0.5, plane["rms"], delta=0.02 * plane["rms"])


@unittest.skipUnless(CHROMIUM, "there is no Chromium here")
class Browser(Page):
    def screenshot(self, name, *options):
        # If PCL_OPS_PICTURES names a folder, the picture stays there for people to look at.
        picture = pathlib.Path(os.environ.get("PCL_OPS_PICTURES", self.folder), name)
        self.chromium(self.folder / "room.html", f"--screenshot={picture}", *options)
        return pixels_of(picture)

    def test_draws_the_largest_planes_in_their_colors(self):
        pixels = self.screenshot("page.png")
        for plane in self.description["planes"][:5]:
            color = [int(plane["color"][at:at + 2], 16) for at in (1, 3, 5)]
            shades = sum(count for pixel, count in pixels.items() if is_shade(pixel, color))
            self.assertGreater(shades, 1000, plane["id"])
        self.assertGreater(pixels[255, 255, 255], 10000)

    def test_is_dark_where_the_browser_is(self):
        pixels = self.screenshot("page_dark.png", "--blink-settings=preferredColorScheme=0")
        self.assertLess(pixels[255, 255, 255], 3000)
        self.assertGreater(pixels[0x16, 0x18, 0x1b], 10000)

    def test_lists_all_planes(self):
        rows = self.result_of(
            "return [...element('rows').children].map(row => row.innerText.split(/\\s+/).filter(x => x));")
        self.assertEqual([row[:3] for row in rows],
                         [[str(one["id"]), name_of(one), str(one["points"])] for one in self.planes])
        for row, plane in zip(rows, self.planes):
            for shown, name, error in zip(row[3:], ("area", "rms", "slope"), (0.01, 0.1, 0.01)):
                self.assertAlmostEqual(float(shown), plane[name], delta=error * plane[name] + 0.06 * (name == "slope"))

    def test_a_click_says_plane_position_and_distance(self):
        for plane in self.planes[:3]:
            answer, point = self.result_of(f"""
              const i = {plane["id"] - 1}, group = groups[i], at = 3 * group.first;
              const point = group.fromMiddle.map((x, k) => x + group.step[k] * steps[at + k]);
              showOnly(i);  // others may be in front of it
              look(point, group.normal, radius / 4);
              const box = element('points').getBoundingClientRect();
              press(box.left + box.width / 2, box.top + box.height / 2);
              return [element('answer').textContent, add(point, middle)];""")
            facts, answer = answer.split("; ")
            self.assert_are_facts(facts, plane)
            found = re.fullmatch(r"at (\S+), (\S+), (\S+), distance to the plane (\S+) ± (\S+)", answer)
            self.assertTrue(found, answer)
            shown = [float(found[i]) for i in (1, 2, 3)]
            self.assertLess(max(abs(a - b) for a, b in zip(shown, point)), 0.01)
            distance = sum(n * (p - c) for n, p, c in zip(plane["normal"], shown, plane["centroid"]))
            self.assertAlmostEqual(float(found[4]), distance, delta=0.001)
            self.assertLess(float(found[5]), 0.001)

    def assert_are_facts(self, text, plane):
        found = re.fullmatch(r"plane (\d+), (\w+): (\d+) points, area (\S+), rms (\S+), slope (\S+)", text)
        self.assertTrue(found, text)
        self.assertEqual((int(found[1]), found[2], int(found[3])), (plane["id"], name_of(plane), plane["points"]))
        self.assertAlmostEqual(float(found[4]), plane["area"], delta=0.01 * plane["area"])
        self.assertAlmostEqual(float(found[5]), plane["rms"], delta=0.1 * plane["rms"])
        self.assertAlmostEqual(float(found[6]), plane["slope"], delta=0.06)

    def test_a_click_on_a_row_marks_it_and_says_what_the_plane_is(self):
        marked, answer, target = self.result_of("""
          element('rows').children[1].click();
          return [[...document.querySelectorAll('tr.chosen')].map(row => row.rowIndex), element('answer').textContent,
                  add(camera.target, middle)];""")
        self.assertEqual(marked, [2])  # below the row of titles
        self.assert_are_facts(answer, self.planes[1])
        self.assertLess(max(abs(a - b) for a, b in zip(target, self.planes[1]["centroid"])), 1e-6)

    def test_a_click_on_a_point_marks_the_row_of_its_plane(self):
        marked = self.result_of("""
          const rows = () => [...document.querySelectorAll('tr.chosen')].map(row => row.rowIndex), marked = [];
          for (const i of [2, planes.length]) { choose({i, point: [0, 0, 0]}); marked.push(rows()); }
          return marked;""")
        self.assertEqual(marked, [[3], []])

    def test_a_second_click_says_how_far_it_is_from_the_first(self):
        answers = self.result_of("""
          const answers = [], say = found => { choose(found); answers.push(element('answer').textContent); };
          say({i: planes.length, point: [1, 0, 0]});
          say({i: planes.length, point: [1, 3, 4]});
          say(null);
          say({i: planes.length, point: [1, 0, 0]});
          return answers;""")
        self.assertRegex(answers[1], r"; 5\.0+ from the point before$")
        for answer in answers[0], answers[2], answers[3]:
            self.assertNotIn("before", answer)

    def test_lists_and_shows_planes_of_a_kind_or_a_name_alone(self):
        counts, listed, texts = self.result_of("""
          const counts = [], listed = [], texts = [];
          const look = (find, kind) => {
            Object.assign(element('find'), {value: find});
            Object.assign(element('kind'), {value: kind});
            element('filter').dispatchEvent(new Event('input'));
            counts.push(drawnPixels());
            listed.push([...element('rows').children].filter(row => !row.hidden).map(row => row.rowIndex));
            texts.push(element('found').textContent);
          };
          element('rest').click();
          look('', ''); look('', 'wall'); look('2', ''); look('Wa', ''); look('nothing', '');
          return [counts, listed, texts];""")
        walls = [one["id"] for one in self.planes if one["kind"] == "wall"]
        everything = [one["id"] for one in self.planes]
        self.assertEqual(listed, [everything, walls, [2], walls, []])
        self.assertGreater(counts[0], counts[1])
        self.assertGreater(counts[1], 0)
        self.assertEqual((counts[3], counts[4]), (counts[1], 0))
        self.assertEqual(texts[:2], ["", f"{len(walls)} of {len(everything)}"])

    def test_no_planes_switches_off_those_that_are_listed(self):
        on = self.result_of("""
          element('kind').value = 'wall';
          element('filter').dispatchEvent(new Event('input'));
          element('none').click();
          return planes.map((plane, i) => groups[i].isOn);""")
        self.assertEqual(on, [one["kind"] != "wall" for one in self.planes])

    def test_planes_and_layers_are_switched_on_and_off(self):
        counts = self.result_of("""
          const counts = [drawnPixels()];
          for (const id of ['none', 'rest', 'all']) { element(id).click(); counts.push(drawnPixels()); }
          element('rows').children[0].querySelector('input').click();
          counts.push(drawnPixels());
          element('none').click();
          for (const id of ['outlines', 'normals', 'edges']) { element(id).click(); counts.push(drawnPixels()); }
          return counts;""")
        all_, rest, nothing, planes, without_largest, outlines, normals, edges = counts
        self.assertGreater(all_, planes)
        self.assertTrue(0 < rest < all_)
        self.assertEqual(nothing, 0)
        self.assertGreater(planes, without_largest)
        self.assertEqual((outlines, normals), (0, 0))  # of planes that are off
        self.assertGreater(edges, 0)

    def test_planes_are_seen_from_behind_where_asked(self):
        before, behind, shown = self.result_of("""
          showOnly(0);
          const middle_of_plane = add(planes[0].centroid, middle, -1), counts = [];
          look(middle_of_plane, planes[0].normal, radius);
          counts.push(drawnPixels());
          look(middle_of_plane, scaled(planes[0].normal, -1), radius);
          counts.push(drawnPixels());
          element('backs').click();
          counts.push(drawnPixels());
          return counts;""")
        self.assertGreater(before, 1000)
        self.assertEqual(behind, 0)
        self.assertGreater(shown, 1000)

    def test_turns_moves_and_zooms(self):
        cameras = self.result_of("""
          const cameras = [{...camera}];
          const send = (kind, x, y, more) => canvas.dispatchEvent(new PointerEvent(kind,
            {clientX: x, clientY: y, pointerId: 1, buttons: 1, button: 0, bubbles: true, ...more}));
          const after = () => cameras.push({...camera});
          send('pointerdown', 200, 200); send('pointermove', 260, 200); send('pointerup', 260, 200); after();
          send('pointerdown', 200, 200, {buttons: 2}); send('pointermove', 200, 260, {buttons: 2});
          send('pointerup', 200, 260); after();
          canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, cancelable: true})); after();
          send('pointerdown', 200, 200); send('pointerdown', 300, 200, {pointerId: 2});
          send('pointermove', 400, 200, {pointerId: 2}); after();
          return cameras;""")
        first, turned, moved, nearer, pinched = cameras
        self.assertNotEqual(turned["yaw"], first["yaw"])
        self.assertEqual(turned["target"], first["target"])
        self.assertNotEqual(moved["target"], turned["target"])
        self.assertLess(nearer["distance"], moved["distance"])
        self.assertAlmostEqual(pinched["distance"], nearer["distance"] / 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
