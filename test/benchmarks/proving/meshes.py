# SPDX-License-Identifier: BSD-3-Clause
"""Meshes and clouds in the files that the programs write, and samples of meshes. Metres."""
import re

import numpy as np

from proving import pcd

TYPES = {"float": "<f4", "double": "<f8", "uchar": "u1", "int": "<i4", "uint": "<u4"}
WALL, DETAIL, COLUMN = 3, 4, 5


class Mesh:
    """Triangles: `corners` is n x 3 x 3, `labels` and `rooms` one a triangle."""

    def __init__(self, corners, labels, rooms):
        self.corners, self.labels, self.rooms = corners, labels, rooms

    def part(self, keep):
        return Mesh(self.corners[keep], self.labels[keep], self.rooms[keep])

    def areas(self):
        return np.linalg.norm(np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0]), axis=1) / 2

    def volume(self):
        a, b, c = (self.corners[:, k] for k in range(3))
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    def wall_area(self):
        return float(self.areas()[np.isin(self.labels, (WALL, COLUMN))].sum())


def read_mesh(path):
    """A binary PLY of triangles with labels and rooms, 0 if it has none."""
    data = path.read_bytes()
    start = data.index(b"end_header\n") + len(b"end_header\n")
    forms, counts = {}, {}
    for line in data[:start].decode().splitlines():
        word = line.split()
        if word[0] == "element":
            at, counts[word[1]] = word[1], int(word[2])
            forms[at] = []
        elif word[0] == "property" and word[1] == "list":
            forms[at] += [("three", TYPES[word[2]]), ("corners", TYPES[word[3]], 3)]
        elif word[0] == "property":
            forms[at].append((word[2], TYPES[word[1]]))
    vertices = np.frombuffer(data, forms["vertex"], counts["vertex"], start)
    faces = np.frombuffer(data, forms["face"], counts["face"], start + vertices.nbytes)
    points = np.stack([vertices[axis].astype(float) for axis in "xyz"], axis=1)
    labels, rooms = (faces[k] if k in faces.dtype.names else np.zeros(len(faces), int) for k in ("label", "room"))
    return Mesh(points[faces["corners"]], labels, rooms)


def write_mesh(path, mesh):
    """A PLY as read_mesh() reads it; equal corners are one vertex."""
    points, corners = np.unique(mesh.corners.reshape(-1, 3), axis=0, return_inverse=True)
    faces = np.empty(len(mesh.corners), [("three", "u1"), ("corners", "<i4", 3), ("label", "u1"), ("room", "<i4")])
    faces["three"], faces["corners"], faces["label"], faces["room"] = 3, corners.reshape(-1, 3), mesh.labels, mesh.rooms
    path.write_bytes(f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\n"
                     f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\n"
                     "property uchar label\nproperty int room\nend_header\n".encode() + points.astype("<f8").tobytes() + faces.tobytes())


def point_count(path):
    with open(path, "rb") as file:
        return int(re.search(rb"\nPOINTS (\d+)", file.read(1000)).group(1))


def write_xyz(path, points):
    pcd.write(path, np.ascontiguousarray(points, "<f4").view([(axis, "<f4") for axis in "xyz"]).ravel())


def samples(mesh, spacing=0.02, seed=1):
    """Places on a mesh, evenly over its area, the same for the same seed."""
    rng = np.random.default_rng(seed)
    summed = np.cumsum(mesh.areas())
    count = int(np.ceil(summed[-1] / spacing ** 2))
    triangle = np.searchsorted(summed, summed[-1] * (np.arange(count) + rng.random(count)) / count)
    step = np.arange(count) - np.searchsorted(triangle, triangle)  # in the triangle, from 0
    u, v = (rng.random((2, len(summed)))[:, triangle] + np.outer((0.7548776662466927, 0.5698402909980532), step)) % 1
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    a, b, c = (mesh.corners[triangle, k] for k in range(3))
    return a + u[:, None] * (b - a) + v[:, None] * (c - a)
