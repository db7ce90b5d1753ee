# SPDX-License-Identifier: BSD-3-Clause
"""Reads binary glTF, as tests see it."""
import json
import struct


class Glb:
    def __init__(self, content):
        magic, version, size, json_size, kind = struct.unpack_from("<4s2II4s", content)
        assert (magic, version, size, kind) == (b"glTF", 2, len(content), b"JSON")
        binary_size, kind = struct.unpack_from("<I4s", content, 20 + json_size)
        assert kind == b"BIN\0" and 28 + json_size + binary_size == len(content) and json_size % 4 == 0
        self.json, self.binary = json.loads(content[20:20 + json_size]), content[28 + json_size:]

    def values(self, accessor):
        """Places, or corners of triangles."""
        a = self.json["accessors"][accessor]
        view = self.json["bufferViews"][a["bufferView"]]
        width, kind = {("SCALAR", 5125): (1, "I"), ("VEC3", 5126): (3, "f")}[a["type"], a["componentType"]]
        assert view["byteLength"] == 4 * width * a["count"]
        rows = list(struct.iter_unpack(f"<{width}{kind}", self.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]))
        for name, end in (("min", min), ("max", max)):
            assert name not in a or a[name] == [end(r[k] for r in rows) for k in range(width)]
        return rows if width > 1 else [r[0] for r in rows]

    def parts(self):
        """Elements: name of the room above, their own, material, triangles."""
        for node in self.json["nodes"]:
            for child in (self.json["nodes"][c] for c in node.get("children", [])):
                if "mesh" in child:
                    primitive, = self.json["meshes"][child["mesh"]]["primitives"]
                    places, corners = self.values(primitive["attributes"]["POSITION"]), self.values(primitive["indices"])
                    assert set(corners) == set(range(len(places)))
                    material = self.json["materials"][primitive["material"]]["name"] if "material" in primitive else ""
                    yield node["name"], child["name"], material, list(zip(*[iter(places[k] for k in corners)] * 3))


def volume_of(triangles):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
               + a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6
