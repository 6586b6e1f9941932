# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes labeled clouds of scans of SemanticKITTI: the field label is the class of a point.

python3 kitti_clouds.py FOLDER sequences/00/velodyne/000000.bin ...: writes FOLDER/000000.pcd ...
"""

import argparse
import pathlib

import numpy as np


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path,
                        help="gets a .pcd file for each scan")
    parser.add_argument("scans", metavar="SCAN", type=pathlib.Path, nargs="+",
                        help="sequences/00/velodyne/000000.bin and the like")
    arguments = parser.parse_args()
    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    for scan in arguments.scans:
        points = np.fromfile(scan, "<f4").reshape(-1, 4)  # x, y, z, reflectance
        cloud = np.zeros(len(points), dtype=[("xyz", "<f4", 3), ("label", "<u4")])
        cloud["xyz"] = points[:, :3]
        labels = scan.parents[1] / "labels" / f"{scan.stem}.label"
        # The class is in the lower 16 bits, the instance in the upper ones.
        cloud["label"] = np.fromfile(labels, "<u4") & 0xFFFF
        (folder / f"{scan.stem}.pcd").write_bytes(
            ("VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
             f"HEIGHT 1\nWIDTH {len(cloud)}\nPOINTS {len(cloud)}\nDATA binary\n").encode()
            + cloud.tobytes())


if __name__ == "__main__":
    main()
