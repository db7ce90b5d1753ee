#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tells how well a structure tells ceiling, floor, walls and details of a labelled scan apart: each point of the scan,
thinned to one in 2 cm, is predicted to be what the nearest point of the structure is. Columns count as walls."""
import argparse
import sys

import numpy as np
from scipy.spatial import cKDTree

from proving import pcd

NAMES = ("other", "ceiling", "floor", "wall", "detail")
SPACING = 0.02  # metres, of the points of the scan that are scored: near the scanner there are a hundred times as many
VOXEL_DIAGONAL = 0.0866  # metres, of a voxel of 5 cm
WALL, COLUMN = 3, 5


def scored(labels):
    """Walls for columns, other for values above 5."""
    labels = np.asarray(labels).astype(np.int64)
    return np.where(labels == COLUMN, WALL, np.where(labels < COLUMN, labels, 0))


def read(path, *fields):
    points = pcd.read(path)
    for name in ("label", *fields):
        if name not in points.dtype.names:
            raise ValueError(f"{path} has no field '{name}'")
    return points


def thinned(points):
    """The first finite point in each cube."""
    places = pcd.places(points)
    finite = np.flatnonzero(np.isfinite(places).all(1))
    if not len(finite):
        return points[:0]
    cells = np.floor(places[finite] / SPACING).astype(np.int64)
    cells -= cells.min(0)
    _, first = np.unique(np.ravel_multi_index(cells.T, cells.max(0) + 1), return_index=True)
    return points[finite[np.sort(first)]]


def nearest(cloud, queries, radius):
    """The index of the point of a cloud nearest to each query; -1 without one within the radius."""
    if not len(cloud):
        return np.full(len(queries), -1)
    finite = np.isfinite(queries).all(1)
    _, index = cKDTree(cloud).query(np.where(finite[:, None], queries, 0), distance_upper_bound=radius)
    return np.where(finite & (index < len(cloud)), index, -1)


def count(truth, predicted):
    """Numbers of points by their label (rows) and the scored prediction (columns)."""
    table = {}
    for label in np.unique(truth):
        table[int(label)] = np.bincount(scored(predicted[truth == label]), minlength=len(NAMES))
    return table


class Grades:
    """Tables of the scan's points, of the structure's points, and of the scan's points by the labels it gives them."""

    def __init__(self, structure_path, scan_path, radius=VOXEL_DIAGONAL, off_surface=0, meanings=None):
        normals = ("normal_x", "normal_y", "normal_z") if off_surface > 0 else ()
        structure = read(structure_path, *normals)
        structure = structure[np.isfinite(pcd.places(structure)).all(1)]
        scan = thinned(read(scan_path))
        given = scan["label"].astype(np.int64)
        truth = given.copy()
        for label, meaning in (meanings or {}).items():
            truth[given == label] = meaning
        if not scored(truth).any():
            raise ValueError(f"no point of {scan_path} is a ceiling, floor, wall, detail or column; --map says what its labels mean")
        of_structure, of_scan = pcd.places(structure), pcd.places(scan)
        index = nearest(of_structure, of_scan, radius)
        if normals:
            off = np.abs(np.einsum("ij,ij->i", of_scan - of_structure[index], np.stack([structure[n] for n in normals], 1)[index]))
            index = np.where(off <= off_surface, index, -1)
        predicted = np.where(index >= 0, structure["label"][index], 0)
        self.of_scan = count(truth, predicted)
        self.of_given = count(given, predicted)
        back = nearest(of_scan, of_structure, radius)  # points without one, as in a closed hole, do not count
        self.of_structure = count(truth[back[back >= 0]], structure["label"][back >= 0])

    @staticmethod
    def score(table, name):
        """Numbers of points that are of this label, that are predicted to be, and both."""
        k = NAMES.index(name)
        true = [row for label, row in table.items() if scored(label) == k]
        return sum(int(row.sum()) for row in true), sum(int(row[k]) for row in table.values()), sum(int(row[k]) for row in true)

    def recall_and_precision(self, name):
        """Shares; None without points."""
        true, predicted, right = self.score(self.of_scan, name)
        return (right / true if true else None), (right / predicted if predicted else None)


def percent(part, whole):
    return f"{100 * part / whole:.2f}" if whole else "-"


def show(grades):
    print(f"{'label':10} {'true':>9} {'predicted':>9} {'recall, %':>10} {'precision, %':>13} {'of structure, %':>15}")
    for name in NAMES[1:]:
        true, predicted, right = grades.score(grades.of_scan, name)
        _, in_structure, right_there = grades.score(grades.of_structure, name)
        print(f"{name:10} {true:9} {predicted:9} {percent(right, true):>10} {percent(right, predicted):>13} "
              f"{percent(right_there, in_structure):>15}")
    print(f"\n{'of label':10}" + "".join(f" {name:>9}" for name in NAMES))
    for label, row in grades.of_given.items():
        print(f"{label:<10}" + "".join(f" {number:9}" for number in row))


def meanings_of(text):
    """Pairs of a label of the scan and one from 0 to 5, such as 7=3,8=3."""
    pairs = [tuple(map(int, pair.split("="))) for pair in text.split(",") if pair]
    if any(len(pair) != 2 or not 0 <= pair[1] <= COLUMN for pair in pairs) or len(dict(pairs)) < len(pairs):
        raise ValueError("each label once, with one from 0 to 5")
    return dict(pairs)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("structure", help="PCD with labels, as pcl_sedr writes it")
    parser.add_argument("labelled", help="scan with true labels, a PCD")
    parser.add_argument("--radius", type=float, default=VOXEL_DIAGONAL,
                        help="metres within which a point of the structure must lie, or the prediction is 'other'")
    parser.add_argument("--off-surface", type=float, default=0,
                        help="how far off the structure's surface a point may lie, or the prediction is 'other'; 0: any")
    parser.add_argument("--map", type=meanings_of, help="what the scan's labels mean here, such as 0=1,1=2,2=3")
    options = parser.parse_args()
    show(Grades(options.structure, options.labelled, options.radius, options.off_surface, options.map))


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError) as error:
        sys.exit(f"label_grades.py: {error}")
