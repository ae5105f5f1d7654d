#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""That the scenes of testdata/scenes are what their README.md says:  scene_files_test.py SCENES

Reads glTF by itself, with nothing but the standard library and nothing of the scripts that make the scenes.
"""
import base64
import collections
import json
import math
import pathlib
import re
import struct
import sys
import unittest
import urllib.parse

SCENES = pathlib.Path()
FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
SLIDE, CAGE = "CAGEWRIGHT_cut_slide", "CAGEWRIGHT_cage"


class File:
    """A scene's text, JSON and buffers."""

    def __init__(self, name):
        path, data, self.chunks = SCENES / name, (SCENES / name).read_bytes(), []
        if data[:4] == b"glTF":
            at = 12
            while at < len(data):
                length, = struct.unpack_from("<I", data, at)
                self.chunks.append((data[at + 4:at + 8], data[at + 8:at + 8 + length]))
                at += 8 + length
            data = self.chunks[0][1]
        self.text = data.decode()
        self.json = json.loads(data)
        self.buffers = []
        for buffer in self.json["buffers"]:
            uri = buffer.get("uri")
            if uri is None:
                content = next(chunk for kind, chunk in self.chunks if kind == b"BIN\0")
            elif uri.startswith("data:"):
                content = base64.b64decode(uri.partition(",")[2], validate=True)
            else:
                content = (path.parent / urllib.parse.unquote(uri)).read_bytes()
            self.buffers.append(content)

    def rows(self, view, offset, count, kind, width):
        view = self.json["bufferViews"][view]
        form = f"<{width}{kind}"
        stride = view.get("byteStride", struct.calcsize(form))
        start = view.get("byteOffset", 0) + offset
        return [struct.unpack_from(form, self.buffers[view["buffer"]], start + i * stride) for i in range(count)]

    def values(self, number):
        """The accessor's rows, as they are stored."""
        accessor = self.json["accessors"][number]
        kind, width, count = FORMATS[accessor["componentType"]], WIDTHS[accessor["type"]], accessor["count"]
        rows = [(0,) * width] * count
        if "bufferView" in accessor:
            rows = self.rows(accessor["bufferView"], accessor.get("byteOffset", 0), count, kind, width)
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            places = self.rows(sparse["indices"]["bufferView"], 0, sparse["count"],
                               FORMATS[sparse["indices"]["componentType"]], 1)
            replaced = self.rows(sparse["values"]["bufferView"], 0, sparse["count"], kind, width)
            for (place,), row in zip(places, replaced):
                rows[place] = row
        return rows

    def triangles(self, mesh):
        """The mesh's triangles as triples of positions, without those that have no area by their indices."""
        found = []
        for primitive in self.json["meshes"][mesh]["primitives"]:
            points = self.values(primitive["attributes"]["POSITION"])
            corners = [i for i, in self.values(primitive["indices"])] if "indices" in primitive else range(len(points))
            mode, n = primitive.get("mode", 4), len(corners)
            triples = {4: lambda: [(i, i + 1, i + 2) for i in range(0, n, 3)],
                       5: lambda: [(i, i + 1 + i % 2, i + 2 - i % 2) for i in range(n - 2)],
                       6: lambda: [(i + 1, i + 2, 0) for i in range(n - 2)]}.get(mode, list)()
            found += [[points[corners[i]] for i in t] for t in triples if len({corners[i] for i in t}) == 3]
        return found


def surface_facts(triangles):
    """Open or non-manifold edges, Euler characteristic, signed volume, once equal positions are one vertex."""
    edges = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
    bad = sum(1 for (a, b), n in edges.items() if n != 1 or edges[b, a] != 1)
    euler = len({p for t in triangles for p in t}) - len(edges) // 2 + len(triangles)
    volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6
    return bad, euler, volume


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def matrix(node):
    if "matrix" in node:
        return [[node["matrix"][4 * j + i] for j in range(4)] for i in range(4)]
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    turn = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    scale, move = node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0))
    return [[turn[i][j] * scale[j] for j in range(3)] + [move[i]] for i in range(3)] + [[0, 0, 0, 1]]


def names(folder):
    return sorted(p.name for p in folder.iterdir() if p.suffix in (".glb", ".gltf"))


class Scenes(unittest.TestCase):
    def test_readme_has_a_line_for_every_scene_and_a_scene_for_every_line(self):
        text = (SCENES / "README.md").read_text()
        lines = re.findall(r"^\| `([^`]+\.gl(?:b|tf))` \| [^|]+ \| [^|]+ \|$", text, re.M)
        self.assertEqual(sorted(lines), sorted(names(SCENES) + names(SCENES / "broken")))

    def test_every_mesh_is_closed_manifold_outward_and_of_genus_0(self):
        for name in names(SCENES):
            file = File(name)
            for mesh in range(len(file.json["meshes"])):
                with self.subTest(file=name, mesh=mesh):
                    triangles = file.triangles(mesh)
                    bad, euler, volume = surface_facts(triangles)
                    self.assertEqual((bad, euler), (0, 2))
                    self.assertGreater(volume, 0)
                    self.assertIn(len(triangles), (98, 12, 20))

    def test_every_way_of_storing_the_limb_stores_the_same_one(self):
        shapes = {}  # but where it is rounded, or stands elsewhere
        for name in names(SCENES):
            file = File(name)
            if "quantized" not in name and "several" not in name and "two_caged" not in name:
                key = sorted(sorted(t) for t in file.triangles(file.json["nodes"][mesh_node(file)]["mesh"]))
                shapes.setdefault(str(key), []).append(name)
        self.assertEqual(len(shapes), 1, shapes.values())

    def test_slides_lie_across_the_limb(self):
        seen = 0
        for name in names(SCENES):
            file = File(name)
            for number, node in enumerate(file.json["nodes"]):
                if SLIDE not in node.get("extensions", {}) and SLIDE not in node.get("extras", {}):
                    continue
                seen += 1
                with self.subTest(file=name, node=number):
                    placed = to_mesh_node(file, number)
                    u, v, centre = ([placed[i][j] for i in range(3)] for j in (0, 1, 3))
                    self.assertLess(abs(u[1]) + abs(v[1]), 1e-12)  # in a plane across Y
                    self.assertLess(abs(centre[1]), 0.9)
                    self.assertLess(abs(centre[0]) + abs(centre[2]), 0.1)
                    self.assertTrue(0.24 <= math.hypot(u[0], v[0]) <= 0.29 and 0.19 <= math.hypot(u[2], v[2]) <= 0.25)
        self.assertEqual(seen, 28)

    def test_cages_are_round_the_limb_and_have_a_number_for_each_corner(self):
        seen = 0
        for name in names(SCENES):
            file = File(name)
            for node in file.json["nodes"]:
                if CAGE in node.get("extensions", {}):
                    seen += 1
                    corners = {p for t in file.triangles(node["mesh"]) for p in t}
                    self.assertEqual(len(corners), len(node["extensions"][CAGE]["sections"]), name)
                    limb = {p for t in file.triangles(file.json["nodes"][mesh_node(file)]["mesh"]) for p in t}
                    for axis in range(3):
                        self.assertLess(max(p[axis] for p in limb), max(p[axis] for p in corners), name)
                        self.assertGreater(min(p[axis] for p in limb), min(p[axis] for p in corners), name)
        self.assertEqual(seen, 7)

    def test_json_holds_what_a_careless_writer_would_lose(self):
        for name in ("json_numbers.gltf", "json_numbers.glb"):
            numbers = re.findall(r'"n\d+":\s*([^,\s}]+)', File(name).text)
            for text in ("-0.0", "1.0", "1e3", "0.1000000000000000055", "18446744073709551616", "9007199254740993"):
                self.assertIn(text, numbers)
        self.assertNotIn("zfar", File("json_camera_without_zfar.gltf").json["cameras"][0]["perspective"])
        self.assertIn(r"\u00e9 \u00C9 é", File("json_strings.gltf").text)
        self.assertIsNone(File("json_extras.glb").json["asset"]["extras"])
        self.assertEqual(list(File("json_key_order.gltf").json)[-1], "asset")
        kinds = File("json_unknown_extensions.glb").json
        for kind, entries in kinds.items():
            if isinstance(entries, list) and entries and isinstance(entries[0], dict):
                self.assertTrue(all("extensions" in entry for entry in entries), kind)
        self.assertEqual([kind for kind, _ in File("buffers_glb_unknown_chunk.glb").chunks],
                         [b"JSON", b"BIN\0", b"\0\1\2\3", b"ACME"])

    def test_storage_is_of_the_kind_that_the_name_says(self):
        def accessor(name, number=0):
            return File(name).json["accessors"][number]

        self.assertEqual([accessor(f"geometry_indices_{bits}bit.glb", 1)["componentType"] for bits in (8, 16, 32)],
                         [5121, 5123, 5125])
        self.assertIn("sparse", accessor("geometry_sparse.glb"))
        self.assertNotIn("bufferView", accessor("geometry_sparse_without_view.glb"))
        self.assertEqual(File("geometry_interleaved.glb").json["bufferViews"][0]["byteStride"], 32)
        self.assertTrue(accessor("geometry_quantized_short_normalized.glb")["normalized"])
        modes = [[p.get("mode") for p in File(f"geometry_{kind}.glb").json["meshes"][0]["primitives"]]
                 for kind in ("strip", "fans")]
        self.assertEqual(modes, [[5], [6, 6, 4]])


def mesh_node(file):
    """The first node that shows a mesh and is no cage."""
    return next(i for i, n in enumerate(file.json["nodes"]) if "mesh" in n and CAGE not in n.get("extensions", {}))


def to_mesh_node(file, number):
    """The node's transform in the space of the nearest node above that shows a mesh."""
    parents = {child: i for i, node in enumerate(file.json["nodes"]) for child in node.get("children", [])}
    placed = matrix(file.json["nodes"][number])
    while number in parents and "mesh" not in file.json["nodes"][parents[number]]:
        number = parents[number]
        placed = product(matrix(file.json["nodes"][number]), placed)
    return placed


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: scene_files_test.py SCENES")
    SCENES = pathlib.Path(sys.argv.pop())
    unittest.main()
