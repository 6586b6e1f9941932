# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the strips of pictures show: the better setting of a method, rooms without the near walls
that would hide them, and a strip for each cloud; and where the report says that the values of
parameters come from.

python3 figures_test.py SOURCES: the project's folder.
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "lab/evaluation"))
import report  # noqa: E402

try:
    import figures
    import numpy as np
except ImportError:
    figures = None

FLOOR, WALL = 1, 2


def room_seen_all_around():
    """Points of a floor of 6 m by 6 m and of four walls of 3 m around it, and their labels."""
    along, across = (grid.ravel() for grid in np.meshgrid(*[np.linspace(0, 6, 150)] * 2))
    zero = np.zeros_like(along)
    walls = [[along, zero, across / 2], [along, zero + 6, across / 2],
             [zero, along, across / 2], [zero + 6, along, across / 2]]
    points = np.concatenate([np.stack(part, axis=1) for part in ([along, across, zero], *walls)])
    return points, np.repeat([FLOOR, WALL, WALL, WALL, WALL], along.size)


def write_cloud(file, points, labels):
    """Writes a PCD as pcl_ops_evaluate does, with the lines of its header that figures.py reads."""
    rows = np.empty(len(points), dtype=[("position", "<f4", 3), ("label", "<u4")])
    rows["position"], rows["label"] = points, labels
    file.write_bytes(b"VIEWPOINT 0 0 0 1 0 0 0\nDATA binary\n" + rows.tobytes())


class ValuesOfParameters(unittest.TestCase):
    def test_come_from_the_paper_for_rows_of_its_tables_alone(self):
        # A mean without a time is that of a user's own detector (report.is_own).
        has_time = {"clouds": 1, "detection_ms": 1.0}
        for method, source in (("ops-3-30", "paper"), ("ops-s1-3-10", "paper"),
                               ("fspf-0.07-0.14", "paper"), ("ops", "default"),
                               ("ops-voxels", "default"), ("ops-without-merging", "default"),
                               ("pcl-sac", "tutorial"), ("pcl-sac-measured", "cloud")):
            self.assertEqual(report.values_of(method, has_time), source, method)


@unittest.skipUnless(figures, "needs NumPy, matplotlib and Pillow")
class Strips(unittest.TestCase):
    def test_a_method_is_shown_by_the_setting_with_the_higher_score(self):
        with tempfile.TemporaryDirectory() as folder:
            cloud = pathlib.Path(folder, "rooms", "room-1")
            cloud.mkdir(parents=True)
            for name in ("truth", "ops", "pcl-sac", "pcl-sac-measured"):
                (cloud / f"{name}.pcd").touch()
            scores = {("rooms", "room-1", "ops"): 0.7, ("rooms", "room-1", "pcl-sac"): 0.2,
                      ("rooms", "room-1", "pcl-sac-measured"): 0.4}
            shown = figures.panels_of_strip(cloud / "truth.pcd", [], scores)
            scores["rooms", "room-1", "pcl-sac-measured"] = float("nan")  # it was stopped
            shown_of_one = figures.panels_of_strip(cloud / "truth.pcd", [], scores)
        self.assertEqual({title: file.stem for title, file in shown.items()},
                         {"truth\n": "truth", "pcl_ops\nF 0.70": "ops",
                          "PCL SACSegmentation loop\nF 0.40": "pcl-sac-measured"})
        self.assertEqual(shown_of_one["PCL SACSegmentation loop\nF 0.20"].stem, "pcl-sac")

    def test_clouds_with_the_same_name_have_a_strip_in_each_data_set(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for data_set in ("rooms", "streets"):
                cloud = folder / "labels" / data_set / "1"
                cloud.mkdir(parents=True)
                write_cloud(cloud / "truth.pcd", *room_seen_all_around())
            figures.plot_strips(None, folder)
            strips = sorted(file.name for file in folder.glob("*.png"))
        self.assertEqual(strips, ["strip-rooms-1.png", "strip-streets-1.png"])

    def test_a_view_from_above_has_at_least_20000_points_if_there_are_as_many(self):
        for count in (3, 20000, 20001):
            points = np.zeros((count, 3))
            points[:, 0] = 20 * np.arange(count)  # 30 m around zero there are two
            shown = figures.from_above(points, np.zeros(3)).shown
            self.assertEqual(np.count_nonzero(shown), min(count, 20000))

    def test_the_walls_of_a_room_do_not_hide_its_floor(self):
        points, labels = room_seen_all_around()
        image = figures.picture_of(points, labels, np.array([3.0, 3.0, 1.5]), np.eye(3))
        of_floor, of_walls = (np.count_nonzero(np.all(np.isclose(image, color), axis=-1))
                              for color in figures.plt.get_cmap("tab20").colors[:2])
        self.assertGreater(of_floor, 0.5 * of_walls)

    def test_of_two_points_in_a_line_of_sight_the_nearer_one_is_drawn(self):
        corners, middle = np.array([0.0, 1.0, 0.0, 1.0]), np.array([0.5, 0.5])
        columns = np.concatenate([corners, middle])
        rows = np.concatenate([[0.0, 0.0, 1.0, 1.0], middle])
        red, blue = (1, 0, 0), (0, 0, 1)
        for near, far in ((4, 5), (5, 4)):
            depth, colors = np.full(6, 2.0), np.array([red] * 6)
            depth[near], colors[near] = 1.0, blue
            image = figures.drawn(columns, rows, depth, colors, 50)
            # The middle of 45 pixels; 5 of the 50 are room for squares.
            self.assertEqual(tuple(image[22, 22]), blue, f"{far} is behind")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
