#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws an IFC file as web-ifc shows it, without spaces and ceilings. Needs node with web-ifc, numpy and PIL.

    ifc_image.py MODEL.ifc PICTURE.png [AZIMUTH ELEVATION]
"""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

SHOWN = ("IFCWALL", "IFCCOLUMN", "IFCBEAM", "IFCCOVERING", "floor_slab", "floor_detail")
READER = Path(__file__).resolve().parent.parent / "test/ifc/web_ifc_volumes.js"
SIZE, MARGIN, FINER = (1000, 700), 20, 2


def triangles_of(path):
    """Corners and colours of what is shown."""
    read = subprocess.run(["node", str(READER), path, "1"], capture_output=True, text=True, check=True)
    corners, colours = [np.zeros((0, 3, 3))], [np.zeros((0, 3))]
    for name, product in json.loads(read.stdout)["products"].items():
        for mesh in product["meshes"] if any(s in name for s in SHOWN) else ():
            indices = np.array(mesh["triangles"], dtype=int).reshape(-1, 3)
            if len(indices):
                corners.append(np.array(mesh["points"])[indices])
                colours.append(np.tile(mesh["colour"][:3], (len(indices), 1)))
    return np.concatenate(corners), np.concatenate(colours)


def draw(corners, colours, azimuth, elevation):
    width, height = (FINER * s for s in SIZE)
    a, e = np.radians(azimuth), np.radians(elevation)
    right = np.array([-np.sin(a), np.cos(a), 0])
    forward = -np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
    view = np.stack([corners @ right, -(corners @ np.cross(right, forward)), corners @ forward], -1)
    low, high = view.reshape(-1, 3).min(0), view.reshape(-1, 3).max(0)
    scale = min((width - 2 * MARGIN) / (high[0] - low[0]), (height - 2 * MARGIN) / (high[1] - low[1]))
    view[..., :2] = (view[..., :2] - (low + high)[:2] / 2) * scale + np.array([width, height]) / 2
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12
    light = 0.45 + 0.55 * np.abs(normals @ np.array([0.4, 0.25, 0.88]))
    depth, picture = np.full((height, width), np.inf), np.full((height, width, 3), 255.0)
    for (p, q, r), colour, lit in zip(view, colours, light):
        x0, y0 = np.floor(np.min([p, q, r], 0)[:2]).astype(int)
        x1, y1 = np.ceil(np.max([p, q, r], 0)[:2]).astype(int) + 1
        x, y = np.meshgrid(np.arange(x0, x1), np.arange(y0, y1))
        whole = (q[1] - r[1]) * (p[0] - r[0]) + (r[0] - q[0]) * (p[1] - r[1])
        if abs(whole) < 1e-9:
            continue
        u = ((q[1] - r[1]) * (x - r[0]) + (r[0] - q[0]) * (y - r[1])) / whole
        v = ((r[1] - p[1]) * (x - r[0]) + (p[0] - r[0]) * (y - r[1])) / whole
        z = u * p[2] + v * q[2] + (1 - u - v) * r[2]
        part = np.s_[y0:y1, x0:x1]
        seen = (np.minimum(np.minimum(u, v), 1 - u - v) >= -1e-6) & (z < depth[part])
        depth[part][seen] = z[seen]
        picture[part][seen] = colour * lit * 255
    return Image.fromarray(picture.clip(0, 255).astype("uint8")).resize(SIZE, Image.LANCZOS)


if __name__ == "__main__":
    angles = [float(v) for v in sys.argv[3:5]] or [235.0, 40.0]
    draw(*triangles_of(sys.argv[1]), *angles).save(sys.argv[2])
