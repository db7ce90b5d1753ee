#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a simulated scan as LAS 1.2, or as text, in the coordinates of a national grid.

make_las.py SCAN.pcd SCAN.las|SCAN.xyz EAST NORTH
"""
import struct
import sys

SCALE = 0.0001  # metres


def read_pcd(path):
    """x, y, z of a binary PCD of the simulator: five fields of four bytes."""
    with open(path, "rb") as file:
        count = 0
        for line in file:
            words = line.split()
            if words[0] == b"POINTS":
                count = int(words[1])
            if words[0] == b"DATA":
                break
        data = file.read(20 * count)
    return [(x, y, z) for x, y, z, _, _ in struct.iter_unpack("<fffII", data)]


def write_text(path, points, shift):
    with open(path, "w") as file:
        for point in points:
            print(*(f"{v + s:.4f}" for v, s in zip(point, shift)), file=file)


def write_las(path, points, shift):
    low = [min(p[k] for p in points) + shift[k] for k in range(3)]
    high = [max(p[k] for p in points) + shift[k] for k in range(3)]
    header = b"LASF" + bytes(20) + struct.pack("<BB", 1, 2) + bytes(64)
    header += struct.pack("<HHHIIBHI", 1, 2026, 227, 227, 0, 0, 20, len(points))
    header += struct.pack("<5I", len(points), 0, 0, 0, 0)
    header += struct.pack("<3d3d", SCALE, SCALE, SCALE, *shift)
    for k in range(3):
        header += struct.pack("<dd", high[k], low[k])
    with open(path, "wb") as file:
        file.write(header)
        for point in points:
            file.write(struct.pack("<iii", *(round(v / SCALE) for v in point)) + bytes(8))


def main():
    points = read_pcd(sys.argv[1])
    shift = (float(sys.argv[3]), float(sys.argv[4]), 0.0)
    write = write_text if sys.argv[2].endswith(".xyz") else write_las
    write(sys.argv[2], points, shift)


main()
