# SPDX-License-Identifier: BSD-3-Clause
"""As much of a glTF reader as blender_roundtrip.py needs to say where slides and cages are. Python's library only."""
import base64
import json
import math
import os
import struct
import urllib.parse

SLIDE = "CAGEWRIGHT_cut_slide"
CAGE = "CAGEWRIGHT_cage"


class GltfFile:
    def __init__(self, path):
        self.path = path
        with open(path, "rb") as file:
            data = file.read()
        self._binary = b""
        if data[:4] == b"glTF":
            length = struct.unpack_from("<I", data, 12)[0]
            if len(data) > 20 + length:
                self._binary = data[28 + length:]
            data = data[20:20 + length]
        self.json = json.loads(data)
        self.nodes = self.json.get("nodes", [])
        self._parents = {child: i for i, node in enumerate(self.nodes) for child in node.get("children", [])}

    def own_nodes(self, kind):
        """[(number, node, what the extension or the extras hold)] of the nodes of that kind."""
        found = []
        for i, node in enumerate(self.nodes):
            value = node.get("extensions", {}).get(kind) or (node.get("extras") or {}).get(kind)
            if value is not None:
                found.append((i, node, value))
        return found

    def matrix_below_moved(self, number):
        """(matrix, moved): of a node, relative to the nearest node above it that an animation moves, else to the scene
        and None. The matrix is 4 rows of 4."""
        moved = {channel["target"].get("node") for animation in self.json.get("animations", [])
                 for channel in animation["channels"] if channel["target"]["path"] != "weights"}
        matrix = local_matrix(self.nodes[number])
        while number in self._parents:
            number = self._parents[number]
            if number in moved:
                return matrix, number
            matrix = multiply(local_matrix(self.nodes[number]), matrix)
        return matrix, None

    def cage_positions(self, node):
        """The vertices of a cage's mesh, as tuples, and how many triangles it has."""
        primitive = self.json["meshes"][node["mesh"]]["primitives"][0]
        accessor = self.json["accessors"][primitive["attributes"]["POSITION"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        offset = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", 12)
        data = self._buffer(view["buffer"])
        positions = [struct.unpack_from("<3f", data, offset + i * stride) for i in range(accessor["count"])]
        return positions, self.json["accessors"][primitive["indices"]]["count"] // 3

    def cage_triangles(self, node):
        """The triangles of a cage's mesh, as tuples of three vertices."""
        accessor = self.json["accessors"][self.json["meshes"][node["mesh"]]["primitives"][0]["indices"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        offset = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        letter = {5121: "B", 5123: "H", 5125: "I"}[accessor["componentType"]]
        rows = struct.unpack_from(f"<{accessor['count']}{letter}", self._buffer(view["buffer"]), offset)
        return [rows[i:i + 3] for i in range(0, len(rows), 3)]

    def _buffer(self, number):
        uri = self.json["buffers"][number].get("uri")
        if uri is None:
            return self._binary
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        with open(os.path.join(os.path.dirname(self.path), urllib.parse.unquote(uri)), "rb") as file:
            return file.read()


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def local_matrix(node):
    if "matrix" in node:
        return [[node["matrix"][4 * j + i] for j in range(4)] for i in range(4)]
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    x, y, z, w = x / norm, y / norm, z / norm, w / norm
    turn = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    scale, move = node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0))
    return [[turn[i][j] * scale[j] for j in range(3)] + [move[i]] for i in range(3)] + [[0, 0, 0, 1]]
