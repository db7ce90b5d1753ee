# SPDX-License-Identifier: BSD-3-Clause
"""Reads and writes PCD files of any fields, as a structured array of numpy."""
import numpy as np


def unpacked(data, size):
    """Bytes of a block that LZF has packed."""
    out = bytearray()
    at = 0
    while at < len(data):
        control = data[at]
        at += 1
        if control < 32:  # a run of new bytes
            out += data[at:at + control + 1]
            at += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += data[at]
            at += 1
        start = len(out) - ((control & 31) << 8 | data[at]) - 1
        at += 1
        for k in range(start, start + length + 2):  # may overlap what it writes
            out.append(out[k])
    if len(out) != size:
        raise ValueError(f"{len(out)} bytes were packed, not {size}")
    return bytes(out)


def read(path):
    """The points of a PCD file; fields of several values are left out of none."""
    with open(path, "rb") as file:
        head = {}
        while "DATA" not in head:
            line = file.readline()
            if not line:
                raise ValueError(f"{path} is no PCD")
            name, *words = line.decode("ascii", "replace").split() or ["#"]
            head[name] = words
        data = file.read()
    counts = list(map(int, head.get("COUNT", ["1"] * len(head["FIELDS"]))))
    fields = [(f"{name}{k}" if name == "_" else name, {"F": "f", "U": "u", "I": "i"}[kind] + size, count)
              for k, (name, kind, size, count) in enumerate(zip(head["FIELDS"], head["TYPE"], head["SIZE"], counts))]
    rows = np.dtype([field if field[2] > 1 else field[:2] for field in fields])
    size = int(head["POINTS"][0])
    if head["DATA"] == ["binary"]:
        return np.frombuffer(data, rows, size)
    if head["DATA"] == ["ascii"]:
        return np.loadtxt(data.decode().splitlines(), rows, max_rows=size, ndmin=1)
    packed, whole = np.frombuffer(data, "<u4", 2)
    columns = unpacked(data[8:8 + packed], whole)
    points, at = np.zeros(size, rows), 0
    for name, kind, count in fields:  # field by field
        points[name] = np.frombuffer(columns, kind, size * count, at).reshape(points[name].shape)
        at += size * count * np.dtype(kind).itemsize
    return points


def write(path, points):
    """Writes fields of one value each."""
    forms = [points.dtype[name] for name in points.dtype.names]
    rows = (("FIELDS", points.dtype.names), ("SIZE", [f.itemsize for f in forms]), ("TYPE", [f.kind.upper() for f in forms]),
            ("COUNT", [1] * len(forms)), ("WIDTH", [len(points)]), ("HEIGHT", [1]), ("POINTS", [len(points)]), ("DATA", ["binary"]))
    header = "".join(name + "".join(f" {value}" for value in values) + "\n" for name, values in rows)
    with open(path, "wb") as file:
        file.write(b"# .PCD v0.7\nVERSION 0.7\n" + header.encode() + points.tobytes())


def places(points):
    return np.stack([points[axis].astype("f8") for axis in "xyz"], 1)
