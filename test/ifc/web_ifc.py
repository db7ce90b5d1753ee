# SPDX-License-Identifier: BSD-3-Clause
"""What web-ifc, an independent reader, makes of the IFC files that SEDR writes: volumes, cuts of openings,
walls that stand in spaces. Needs node and web-ifc (npm install web-ifc; NODE_PATH says where)."""

import json
import os
import shutil
import subprocess
import tempfile

import numpy as np
from shapely.geometry import Polygon
from shapely.ops import unary_union

import step_reader

READER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "web_ifc_volumes.js")
NODE = shutil.which("node") or shutil.which("nodejs")
SOLID_KINDS = ("IFCSPACE", "IFCWALL", "IFCSLAB", "IFCCOLUMN", "IFCBEAM", "IFCCOVERING")


def is_there():
    return NODE is not None and subprocess.run([NODE, "-e", "require('web-ifc')"], capture_output=True).returncode == 0


def opened(path, with_triangles=False):
    """What was said, and products by kind and name: volume, box, triangles."""
    result = subprocess.run([NODE, READER, path] + ["1"] * with_triangles, capture_output=True, text=True, check=True)
    return json.loads(result.stdout)


def net_volumes(instances):
    """NetVolume of every space and wall by its kind and name, from the file's quantities."""
    return {"%s %s" % (instances[thing][0], instances[thing][1][2]): sizes["NetVolume"]
            for thing, sizes in step_reader.sets(instances, "IFCELEMENTQUANTITY").items() if "NetVolume" in sizes}


def lost(instances, products):
    """Elements of the file of which the viewer shows nothing."""
    names = ["%s %s" % (name, v[2]) for name, v in instances.values() if name in SOLID_KINDS]
    return [name for name in names if products.get(name, {"volume": 0})["volume"] <= 0]


def swept_body(instances, product):
    """Plan, bottom and top of a swept body in its placement; None of others. Of a tilted wall, and the openings
    in it, the plan at its foot."""
    shapes = instances[instances[product][1][6]][1][2]
    items = [v[3] for v in (instances[s][1] for s in shapes) if v[1] == "Body"]
    name, v = instances[items[0][0]]
    if name != "IFCEXTRUDEDAREASOLID":
        return None
    profile = instances[v[0]][1]
    loops = [[instances[p][1][0] for p in instances[n][1][0]] for n in [profile[2]] + sum(profile[3:], [])]
    axes = instances[v[1]][1]
    bottom = instances[axes[0]][1][0][2]
    return Polygon(loops[0], loops[1:]), bottom, bottom + v[3] * instances[v[2]][1][0][2]


def common_volume(wall, openings):
    """Of a swept wall and its openings, which may overlap."""
    plan, bottom, top = wall
    levels = sorted({min(max(z, bottom), top) for _, *ends in openings for z in ends})
    return sum(unary_union([hole for hole, low, high in openings if low < (z + above) / 2 < high]).intersection(plan).area * (above - z)
               for z, above in zip(levels, levels[1:]))


def fillings(instances):
    """(door or window, the wall whose opening it fills; None if there is none)."""
    filled = {v[5]: v[4] for name, v in instances.values() if name == "IFCRELFILLSELEMENT"}
    hosts = {v[5]: v[4] for name, v in instances.values() if name == "IFCRELVOIDSELEMENT"}
    return [("%s %s" % (name, v[2]), hosts.get(filled.get(i))) for i, (name, v) in instances.items()
            if name in ("IFCDOOR", "IFCWINDOW")]


def cuts(path, instances, products):
    """(wall, what its openings take of it, what they should take) of each wall with openings; the last is None
    where the wall or an opening is not swept. The file is to have its arcs as facets."""
    hosted = {}
    for name, v in instances.values():
        if name == "IFCRELVOIDSELEMENT":
            hosted.setdefault(v[4], []).append(v[5])
    with tempfile.TemporaryDirectory() as folder:
        whole = os.path.join(folder, "whole.ifc")
        with open(path) as file, open(whole, "w") as copy:
            copy.writelines(line for line in file if "=IFCRELVOIDSELEMENT(" not in line)
        without = opened(whole)["products"]
    found = []
    for host, openings in hosted.items():
        name = "IFCWALL " + instances[host][1][2]
        wall = swept_body(instances, host)
        bodies = [wall] + [swept_body(instances, n) for n in openings]
        expected = None if None in bodies else common_volume(wall, bodies[1:])
        found.append((name, without[name]["volume"] - products[name]["volume"], expected))
    return found


def heights_on(product, x, y):
    """Sorted heights at which the faces of a product are over places of a lattice, a list for each place."""
    hits = [[] for _ in range(len(x) * len(y))]
    for mesh in product["meshes"]:
        corners = np.asarray(mesh["points"]).reshape(-1, 3)[np.asarray(mesh["triangles"], dtype=int).reshape(-1, 3)]
        low, high = corners.min(1), corners.max(1)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        is_near = (high[:, 0] >= x[0]) & (low[:, 0] <= x[-1]) & (high[:, 1] >= y[0]) & (low[:, 1] <= y[-1])
        is_vertical = np.abs(normals[:, 2]) <= 0.001 * np.linalg.norm(normals, axis=1)
        for t in np.nonzero(is_near & ~is_vertical)[0]:
            (a, b, c), twice = corners[t], normals[t, 2]
            i = np.arange(np.searchsorted(x, low[t, 0]), np.searchsorted(x, high[t, 0]))
            j = np.arange(np.searchsorted(y, low[t, 1]), np.searchsorted(y, high[t, 1]))
            px, py = x[i][:, None], y[j][None, :]
            u = ((b[0] - px) * (c[1] - py) - (b[1] - py) * (c[0] - px)) / twice
            v = ((c[0] - px) * (a[1] - py) - (c[1] - py) * (a[0] - px)) / twice
            inside = (u >= 0) & (v >= 0) & (u + v <= 1)
            z = u * a[2] + v * b[2] + (1 - u - v) * c[2]
            for k, m in zip(*np.nonzero(inside)):
                hits[i[k] * len(y) + j[m]].append(z[k, m])
    return [sorted(h) for h in hits]


def inside_both(first, second):
    """Cubic metres that two products have in common, by vertical lines on a lattice that is fine enough for the
    narrower side of what their boxes have in common."""
    low = np.maximum(first["low"], second["low"])
    high = np.minimum(first["high"], second["high"])
    if (high - low).min() <= 0.001:
        return 0
    step = min(max((high - low)[:2].min() / 25, 0.002), 0.02)
    # Off the usual places of faces.
    x, y = (np.arange(low[k] + 0.37 * step, high[k], step) for k in (0, 1))
    length = 0
    for a, b in zip(heights_on(first, x, y), heights_on(second, x, y)):
        for p, q in zip(a[::2], a[1::2]):
            length += sum(max(0, min(q, s) - max(p, r)) for r, s in zip(b[::2], b[1::2]))
    return length * step * step


def within_spaces(products):
    """(cubic metres, wall or space, space) of each wall or space that stands in a space, the largest first. The
    products have their triangles."""
    walls, spaces = ([(n, p) for n, p in products.items() if n.startswith(kind)] for kind in ("IFCWALL ", "IFCSPACE "))
    found = [(inside_both(first, space), name, of) for k, (of, space) in enumerate(spaces)
             for name, first in walls + spaces[:k]]
    return sorted((f for f in found if f[0] > 0.001), reverse=True)
