#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits the odds that two parts of the air are one room: border_odds.py FOLDER..., each with scan.pcd and truth.json as
random_buildings.py --keep-failures leaves them, by what room_basins tells of the scan (SEDR_BUILD_BENCHMARKS; --bin names it).

Basins of one true room are joined, the most open border first; every border met on the way, of basins that are to 80 % of
one true room, is an example. It counts by the root of what a mistake would cost: its length and the area of its smaller part,
both limited. Prints the coefficients of BorderOdds with their standard errors, and how many examples they judge wrongly.
Those in parting_parameters.h are of 82 buildings, `stacked` of 95.
"""
import argparse
import collections
import json
import pathlib
import subprocess

import numpy as np

from buildings import grades
from proving import pcd

NAMES = "any dip open neck drop stacked depth outline share".split()
RIDGE = 1e-3  # of coefficients that the examples do not tell
CELL, UNSEEN_BORDER, UNSEEN_OUTLINE, LEAST_DEPTH = 0.1, 4, 20, 0.25  # metres, cells of it, see BorderOdds, metres


class Basins:
    def __init__(self, program, folder):
        self.room, self.beside, gaps = {}, collections.defaultdict(dict), []
        for line in subprocess.run([program, folder / "scan.pcd"], capture_output=True, text=True, check=True).stdout.splitlines():
            kind, *values = line.split()
            if kind == "basin":
                self.room[int(values[0])] = np.array([float(v) for v in values[1:]] + [0.0])
            elif kind == "border":
                a, b = int(values[0]), int(values[1])
                self.beside[a][b] = self.beside[b][a] = np.array([float(v) for v in values[2:]])
            else:
                gaps.append([float(v) for v in values])
        for a, borders in self.beside.items():
            self.room[a][3] = sum(b[0] for b in borders.values())
        self.owner = owners(np.array(gaps), folder)

    def measures(self, a, b):
        links, walls, drops, dip, stacked, clear = self.beside[a][b]
        gaps, depth, *_ = np.minimum(self.room[a], self.room[b])
        outline = min(r[3] / (r[2] + r[3] + UNSEEN_OUTLINE) for r in (self.room[a], self.room[b]))
        share = links / (min(r[2] + r[3] for r in (self.room[a], self.room[b])) + UNSEEN_OUTLINE)
        x = [1, min(dip / links, 1), np.log((links + UNSEEN_BORDER) / (walls + UNSEEN_BORDER)), min(clear / depth, 1) ** 2,
             drops / links, stacked * CELL ** 2, np.log(min(depth, 1)), outline ** 2, max(share - 0.2, 0)]
        return x, np.sqrt(np.clip(gaps * CELL ** 2, 0.1, 4) * np.clip(links * CELL / 1.2, 0.1, 1))

    def join(self, a, b):
        links = self.beside[a].pop(b)[0]
        del self.beside[b][a]
        depth = max(self.room[a][1], self.room[b][1])
        self.room[a] = self.room[a] + self.room.pop(b)
        self.room[a][1], self.room[a][3] = depth, self.room[a][3] - 2 * links
        for other, border in self.beside.pop(b).items():
            del self.beside[other][b]
            self.beside[a][other] = self.beside[other][a] = added(self.beside[a].get(other, np.zeros(6)), border)

    def examples(self):
        seen, same = collections.defaultdict(list), {}

        def look(a):
            for b, border in self.beside[a].items():
                pair = min(a, b), max(a, b)
                if border[0] > 0 and min(self.owner[a], self.owner[b]) >= 0:
                    measured = self.measures(*pair)
                    if min(self.room[a][1], self.room[b][1]) >= LEAST_DEPTH:
                        seen[pair].append((*measured, self.owner[a] == self.owner[b]))
                    if self.owner[a] == self.owner[b]:
                        same[pair] = measured[0][NAMES.index("open")]

        for a in self.room:
            look(a)
        while same:
            a, b = max(same, key=lambda pair: (same[pair], (-pair[0], -pair[1])))
            self.join(a, b)
            same = {pair: open_ for pair, open_ in same.items() if b not in pair}
            look(a)
        return [(x, weight / len(all_), y) for all_ in seen.values() for x, weight, y in all_]


def added(a, b):
    return np.append(a[:-1] + b[:-1], max(a[-1], b[-1]))


def owners(gaps, folder):
    """The true room of each basin, if it is that of four fifths of its gaps."""
    of_gap = np.full(len(gaps), -1)
    truth = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    for k, place in enumerate(grades.true_places(truth, pcd.read(folder / "scan.pcd"))):
        high = np.minimum(gaps[:, 4], place.high) - np.maximum(gaps[:, 3], place.low)
        is_in = grades.within(np.array(place.plan.exterior.coords)[:-1, :2], gaps[:, 1:3])
        of_gap[is_in & (high > 0.5 * np.minimum(gaps[:, 4] - gaps[:, 3], place.high - place.low))] = k
    owner = {}
    for basin in np.unique(gaps[:, 0]).astype(int):
        mine = of_gap[gaps[:, 0] == basin]
        most, times = collections.Counter(mine).most_common(1)[0]
        owner[basin] = most if times >= 0.8 * len(mine) else -1
    return owner


def fit(x, y, weight):
    """Maximum likelihood by Newton's method: coefficients, standard errors."""
    w = np.zeros(x.shape[1])
    for _ in range(50):
        p = 1 / (1 + np.exp(-np.clip(x @ w, -30, 30)))
        information = x.T @ (x * (weight * p * (1 - p))[:, None]) + RIDGE * np.eye(len(w))
        step = np.linalg.solve(information, x.T @ (weight * (y - p)) - RIDGE * w)
        w += step
        if abs(step).max() < 1e-6:
            break
    return w, np.sqrt(np.diag(np.linalg.inv(information)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--bin", default="build/dev/bin/room_basins")
    options = parser.parse_args()
    examples = [e for folder in options.folders for e in Basins(options.bin, folder).examples()]
    x, weight, y = (np.array(v, float) for v in zip(*examples))
    coefficients, errors = fit(x, y, weight)
    for name, value, error in zip(NAMES, coefficients, errors):
        print(f"{name:8} {value:7.2f} +- {error:.2f}")
    wrong = ((x @ coefficients > 0) != (y > 0))
    print(f"{len(y)} examples of weight {weight.sum():.0f}, wrongly joined {weight[wrong & (y == 0)].sum():.0f}, "
          f"wrongly parted {weight[wrong & (y == 1)].sum():.0f}")


if __name__ == "__main__":
    main()
