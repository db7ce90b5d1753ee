#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs pcl_sedr on variants of real scans and compares the rooms: scan_variants.py SCAN... [options]

What pcl_sedr finds should not depend on how a scan lies in its frame, on its noise or on what else is in the file. Each scan
is turned by 27 and 45 degrees, mirrored, moved by 2 cm, tilted by 0.2 degrees, thinned to a third, given 1 cm of noise, cut in
half and set on top of itself as a second storey. The rooms that pcl_sedr --no-mesh finds are moved back and paired with those of the scan
as it is. A room is kept if the intersection over union of both plans is 0.7 or more. A kept room need not be right: a mistake
that is made each time is kept too. The table has a line a variant; the summary comes last. Needs numpy, scipy and shapely.
Exit code 0: all variants were compared, however well; 1: not all were.
"""
import json
import pathlib
import zlib

from buildings import runs

runs.require("numpy", "scipy", "shapely")
import numpy as np  # noqa: E402
from scipy.optimize import linear_sum_assignment  # noqa: E402
from shapely.affinity import affine_transform  # noqa: E402

from buildings import grades  # noqa: E402
from proving import meshes, pcd  # noqa: E402

KEPT = 0.7     # intersection over union of a room that is kept
MARGIN = 0.5   # metres that a room lies from a cut that does not touch it
SLAB = 0.3     # metres between two storeys


class Variant:
    """Points of a scan, how its plan was moved (a matrix and a shift), and the rooms that should be found."""

    def __init__(self, points, matrix=np.eye(2), shift=np.zeros(2), expected=lambda rooms: rooms):
        self.points, self.matrix, self.shift, self.expected = points, np.asarray(matrix, float), np.asarray(shift, float), expected

    def back(self, plan):
        """A polygon of the variant where it lies in the scan."""
        inverse = np.linalg.inv(self.matrix)
        return affine_transform(plan, [*inverse.ravel(), *(-inverse @ self.shift)])


def moved(points, matrix=np.eye(2), shift=(0, 0)):
    new = points.copy()
    new[:, :2] = points[:, :2] @ np.asarray(matrix).T + shift
    return Variant(new, matrix, shift)


def turned(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return lambda points, rng: moved(points, [[c, -s], [s, c]])


def tilted(points, rng):
    new = points.copy()
    new[:, 2] += np.tan(np.radians(0.2)) * points[:, 0]
    return Variant(new)


def halved(points, rng):
    cut = float(np.median(points[:, 0]))
    return Variant(points[points[:, 0] < cut], expected=lambda rooms: [r for r in rooms if r.plan.bounds[2] < cut - MARGIN])


def doubled(points, rng):
    low, high = np.percentile(points[:, 2], (0.5, 99.5))
    rise = high - low + SLAB

    def twice(rooms):
        return rooms + [grades.Place(r.name, r.plan, r.low + rise, r.high + rise) for r in rooms]
    return Variant(np.vstack([points, points + [0, 0, rise]]), expected=twice)


VARIANTS = {"turned_27": turned(27), "turned_45": turned(45),
            "mirrored": lambda points, rng: moved(points, np.diag([-1.0, 1.0])),
            "moved": lambda points, rng: moved(points, shift=(0.02, 0.02)),
            "tilted": tilted,
            "thinned": lambda points, rng: Variant(points[rng.random(len(points)) < 1 / 3]),
            "noisy": lambda points, rng: Variant(points + rng.normal(0, 0.01, points.shape)),
            "halved": halved, "doubled": doubled}


def read_points(scan, folder, options):
    """x, y, z of a scan of any format that pcl_parallel_voxel_grid reads, a point a millimetre at most."""
    file = folder / "points.pcd"
    runs.output_of([options.bin / "pcl_parallel_voxel_grid", scan, file, "--leaf", "0.001", "--keep-strays", "--scan-axes"])
    points = pcd.places(pcd.read(file))
    return points[np.isfinite(points).all(1)]


def rooms_of(points, folder, options):
    """The rooms that pcl_sedr finds, with its exit code and seconds."""
    meshes.write_xyz(folder / "scan.pcd", points)
    plan = folder / "out" / "floorplan.json"
    plan.unlink(missing_ok=True)
    figures, _ = runs.model(folder, options)
    found = grades.found_places(json.loads(plan.read_text(encoding="utf-8"))) if plan.exists() else []
    return found, figures


def kept(expected, found):
    """How many of the expected rooms are paired with a found one of 0.7 intersection over union or more."""
    table = np.array([[grades.iou(e, f) for f in found] for e in expected]).reshape(len(expected), len(found))
    return sum(table[i, k] >= KEPT for i, k in zip(*linear_sum_assignment(-table)))


def name_of(scan):
    return scan.parent.name if scan.stem == "scan" else scan.stem


def rows_of(scan, folder, options):
    points = read_points(scan, folder, options)
    base, figures = rooms_of(points, folder, options)
    yield {"scan": name_of(scan), "variant": "as it is", **figures, "rooms": len(base), "expected": "", "kept": ""}
    for name in options.variants or VARIANTS:
        variant = VARIANTS[name](points, np.random.default_rng(zlib.crc32(f"{name_of(scan)} {name}".encode())))
        expected = variant.expected(base)
        found, figures = rooms_of(variant.points, folder, options)
        for room in found:
            room.plan = variant.back(room.plan)
        yield {"scan": name_of(scan), "variant": name, **figures, "rooms": len(found), "expected": len(expected),
               "kept": kept(expected, found)}


def summary(rows):
    compared = [r for r in rows if r["expected"] != ""]
    lines = []
    for key in ("scan", "variant"):
        for value in dict.fromkeys(r[key] for r in compared):
            mine = [r for r in compared if r[key] == value]
            lines.append(f"{value}: {sum(r['kept'] for r in mine)} of {sum(r['expected'] for r in mine)} rooms kept")
    return "\n".join(lines)


def main():
    parser = runs.parser(__doc__)
    parser.add_argument("scans", type=pathlib.Path, nargs="+", metavar="SCAN")
    parser.add_argument("--variants", nargs="+", choices=VARIANTS, help="these only")
    parser.set_defaults(options="--partial")  # half of a scan, or two with the ground outside, may be modelled in part
    options = parser.parse_args()
    runs.all_rows(options, ["pcl_parallel_voxel_grid"], options.scans, rows_of, summary)


if __name__ == "__main__":
    main()
