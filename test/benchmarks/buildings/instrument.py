# SPDX-License-Identifier: BSD-3-Clause
"""Errors of terrestrial scanners that the simulator's rays do not have: registration, mixed pixels, faint grazing returns. Metres."""
import numpy as np

from proving import pcd

SHIFT = (0.006, 0.006, 0.003)       # registration of a station, standard deviations along x, y and z
TURN = np.radians((0.02, 0.02, 0.04))  # the same of its rotations about x, y and z
MIXED_SHARE = 0.3                   # of neighbouring returns at different depths that have one between them
MIXED_DEPTHS = (0.1, 6.0)           # how far apart these lie
GRAZING = np.radians(80)            # incidence on floors and ceilings from which returns are lost
GRAZING_LOST = 0.6                  # share of those
NOISE_AT_10_M = 0.003               # standard deviation added along the ray, proportional to the range


def spoil(folder, seed):
    """Gives scan.pcd of a folder of the simulator these errors."""
    stations = np.loadtxt(folder / "positions.txt", ndmin=2)
    pcd.write(folder / "scan.pcd", measure(pcd.read(folder / "scan.pcd"), stations, seed))


def measure(points, stations, seed):
    """The points of a scan as scanned from `stations`, rows of x y z and number of points, in the same form."""
    rng = np.random.default_rng([seed, 7])
    ends = np.cumsum(stations[:, 3]).astype(int)
    return np.concatenate([measure_station(points[end - int(s[3]):end], s[:3], rng) for s, end in zip(stations, ends)])


def measure_station(points, station, rng):
    rays = np.stack([points[k] for k in "xyz"], -1).astype(float) - station
    ranges = np.linalg.norm(rays, axis=1)
    is_level = (points["label"] == 1) | (points["label"] == 2)
    is_grazing = is_level & (np.abs(rays[:, 2]) < np.cos(GRAZING) * ranges)
    kept = ~is_grazing | (rng.random(len(rays)) >= GRAZING_LOST)
    rays *= (1 + NOISE_AT_10_M / 10 * rng.standard_normal(len(rays)))[:, None]
    mixed, of = mixed_pixels(rays, ranges, rng)
    rays = np.vstack([rays[kept], mixed])
    result = np.concatenate([points[kept], points[of]])
    result["label"][kept.sum():] = 0
    rays = rays @ rotation(rng.normal(0, TURN)).T + station + rng.normal(0, SHIFT)
    for k, values in zip("xyz", rays.T):
        result[k] = values
    return result


def mixed_pixels(rays, ranges, rng):
    """Points between neighbours of a scan line, and the rows of the first neighbours."""
    jump = np.abs(np.diff(ranges))
    apart = np.linalg.norm(np.diff(rays, axis=0), axis=1)
    is_edge = (jump > MIXED_DEPTHS[0]) & (apart < MIXED_DEPTHS[1]) & (jump > 0.8 * apart)
    of = np.flatnonzero(is_edge & (rng.random(len(jump)) < MIXED_SHARE))
    share = rng.random((len(of), 1))
    return rays[of] * (1 - share) + rays[of + 1] * share, of


def rotation(angles):
    x, y, z = angles  # so small that their order does not matter
    return np.array([[1, -z, y], [z, 1, -x], [-y, x, 1]])
