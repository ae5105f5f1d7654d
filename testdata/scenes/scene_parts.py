# SPDX-License-Identifier: BSD-3-Clause
"""What every scene is put together from: shapes, accessors, buffers, PNG pictures, JSON text and .glb chunks.

Everything is computed so that it is the same bytes on every machine: coordinates are multiples of 1/1024, which floats
hold exactly, and pictures are stored without compression, as zlib's output depends on its version.
"""
import base64
import copy
import json
import math
import re
import struct
import zlib

SIZES = {"b": 1, "B": 1, "h": 2, "H": 2, "I": 4, "f": 4}
COMPONENT_TYPES = {"b": 5120, "B": 5121, "h": 5122, "H": 5123, "I": 5125, "f": 5126}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
VERTICES, INDICES = 34962, 34963  # what a buffer view is for
SEGMENTS = 7  # of the limb, whose rings are at these heights and have this share of the full radius
PROFILE = [(-0.9, 0.55), (-0.65, 0.9), (-0.35, 1.0), (0, 0.93), (0.35, 0.95), (0.7, 0.85), (0.9, 0.5)]
TOP = len(PROFILE) * SEGMENTS + 1  # the last of its vertices
JSON_CHUNK, BIN_CHUNK = b"JSON", b"BIN\0"

# Shapes: positions, and triangles that are counter-clockwise as seen from outside.


def snap(value):
    return round(value * 1024) / 1024


def limb(offset=(0, 0, 0)):
    """A capsule along Y, 2 long, 0.5 by 0.4 thick, with a waist; the pole below is first, the other one last."""
    points = [(0, -1, 0)]
    for y, radius in PROFILE:
        for j in range(SEGMENTS):
            angle = 2 * math.pi * j / SEGMENTS + 0.2
            points.append((0.25 * radius * math.cos(angle), y, 0.2 * radius * math.sin(angle)))
    points.append((0, 1, 0))
    triangles = []
    for j in range(SEGMENTS):
        k = (j + 1) % SEGMENTS
        triangles.append((0, 1 + j, 1 + k))
        for ring in range(len(PROFILE) - 1):
            low, high = 1 + ring * SEGMENTS, 1 + (ring + 1) * SEGMENTS
            triangles += [(low + j, high + j, low + k), (low + k, high + j, high + k)]
        triangles.append((TOP, TOP - SEGMENTS + k, TOP - SEGMENTS + j))
    return [tuple(snap(c + o) for c, o in zip(p, offset)) for p in points], triangles


def tower(levels, half_x, half_z):
    """A box along Y with a ring of four corners at each level, the first level's corners first."""
    points = [(sx * half_x, y, sz * half_z) for y in levels for sx, sz in ((1, 1), (1, -1), (-1, -1), (-1, 1))]
    last = 4 * (len(levels) - 1)
    triangles = [(0, 2, 1), (0, 3, 2), (last, last + 1, last + 2), (last, last + 2, last + 3)]
    for low in range(0, last, 4):
        for j in range(4):
            a, b = low + j, low + (j + 1) % 4
            triangles += [(a, b, a + 4), (b, b + 4, a + 4)]
    return [tuple(snap(c) for c in p) for p in points], triangles


def normals_of(points, triangles):
    """The unit normal of each vertex, of four decimals."""
    sums = [[0.0, 0.0, 0.0] for _ in points]
    for a, b, c in triangles:
        u, v = ([q - p for p, q in zip(points[a], points[corner])] for corner in (b, c))
        cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for corner in (a, b, c):
            sums[corner] = [s + x for s, x in zip(sums[corner], cross)]
    return [tuple(round(x / math.hypot(*s), 4) for x in s) for s in sums]


def picture(width=4, height=4):
    """A PNG: a chequered square of two colours."""
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in ((230, 180, 60) if (x + y) % 2 else (40, 60, 120)))
                    for y in range(height))
    stored = b"\x78\x01\x01" + struct.pack("<HH", len(rows), len(rows) ^ 0xFFFF) + rows + \
        struct.pack(">I", zlib.adler32(rows))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + \
        chunk(b"IDAT", stored) + chunk(b"IEND", b"")


# JSON text.


def raw(text):
    """A key or value that stands in the file letter by letter, as 1e3 or 1.0 or "\\u00e9"."""
    return f"<<raw {text}>>"


def json_text(value, indent=None):
    text = json.dumps(value, ensure_ascii=False, indent=indent, separators=(",", ": " if indent else ":"))
    if indent:  # arrays of plain values in one line
        text = re.sub(r"\[\n[^][{}]*?\n\s*\]", lambda found: re.sub(r"\s*\n\s*", " ", found[0]), text)
    return re.sub(r'"<<raw (.*?)>>"', lambda found: json.loads(f'"{found[1]}"'), text)


# Scenes.


def packed(rows, component):
    return b"".join(struct.pack(f"<{len(row)}{component}", *row) for row in rows)


def data_uri(data, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


class Scene:
    """A glTF document that is being made: `root` is its JSON, `buffers` the bytes of its buffers."""

    def __init__(self):
        self.root = {"asset": {"version": "2.0", "generator": "Cagewright testdata"}, "scene": 0,
                     "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "accessors": [], "bufferViews": []}
        self.buffers = [bytearray()]

    def view(self, data, buffer=0, **keys):
        self.buffers[buffer] += bytes(-len(self.buffers[buffer]) % 4)
        entry = {"buffer": buffer, "byteOffset": len(self.buffers[buffer]), "byteLength": len(data), **keys}
        self.buffers[buffer] += data
        return self.add("bufferViews", entry)

    def add(self, array, entry):
        """The entry's number in the array."""
        self.root.setdefault(array, []).append(entry)
        return len(self.root[array]) - 1

    def accessor(self, rows, component="f", target=None, bounds=False, buffer=0, **keys):
        """An accessor of rows of numbers, tightly packed but for vertices, which start at multiples of 4 bytes."""
        padding = -len(rows[0]) * SIZES[component] % 4 if target == VERTICES else 0
        data = b"".join(packed([row], component) + bytes(padding) for row in rows)
        view_keys = {} if target is None else {"target": target}
        if padding:
            view_keys["byteStride"] = len(rows[0]) * SIZES[component] + padding
        view = self.view(data, buffer, **view_keys)
        return self.add("accessors", described(rows, component, bounds, bufferView=view, **keys))

    def indices(self, triangles, component="H", buffer=0):
        return self.accessor([(i,) for t in triangles for i in t], component, INDICES, buffer=buffer)

    def primitive(self, points, triangles, buffer=0, index_buffer=0):
        return {"attributes": {"POSITION": self.accessor(points, "f", VERTICES, True, buffer)},
                "indices": self.indices(triangles, buffer=index_buffer)}

    def mesh(self, name, *primitives):
        return self.add("meshes", {"name": name, "primitives": list(primitives)})

    def node(self, parent=None, **keys):
        """The number of a new node, under the node `parent` or at the root of the first scene."""
        node = self.add("nodes", keys)
        if parent is None:
            self.root["scenes"][0]["nodes"].append(node)
        else:
            self.root["nodes"][parent].setdefault("children", []).append(node)
        return node

    def uses(self, *extensions):
        self.root.setdefault("extensionsUsed", []).extend(extensions)

    def with_buffers(self, uris):
        """The JSON with its buffers; a URI of None is the .glb's binary chunk, "data" a data URI."""
        root = copy.deepcopy(self.root)
        for data, uri in zip(self.buffers, uris):
            uri = data_uri(data) if uri == "data" else uri
            root.setdefault("buffers", []).append({"byteLength": len(data), **({} if uri is None else {"uri": uri})})
        return root


def described(rows, component, bounds=False, **keys):
    """An accessor's JSON but for where its bytes are."""
    entry = {**keys, "componentType": COMPONENT_TYPES[component], "count": len(rows), "type": TYPES[len(rows[0])]}
    if bounds:
        entry |= {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]}
    return entry


def limb_scene(name="limb"):
    """A scene of one node, 0, that shows one mesh, 0: the limb."""
    scene = Scene()
    scene.node(name=name, mesh=scene.mesh(name, scene.primitive(*limb())))
    return scene


def gltf(root):
    return json_text(root, indent=1).encode() + b"\n"


def chunk(kind, data, fill=b"\0"):
    data += fill * (-len(data) % 4)
    return struct.pack("<I", len(data)) + kind + data


def glb_file(chunks, version=2):
    return struct.pack("<4sII", b"glTF", version, 12 + len(chunks)) + chunks


def glb(root, binary=None, more=b""):
    binary = chunk(BIN_CHUNK, bytes(binary)) if binary is not None else b""
    return glb_file(chunk(JSON_CHUNK, json_text(root).encode(), b" ") + binary + more)


class Files:
    """The files of a folder, and a line about each of them for its README.md."""

    def __init__(self):
        self.bytes = {}
        self.lines = []

    def add(self, name, data, what, expected, **beside):
        """One scene; `beside` are the files that it names, by ending."""
        assert name not in self.bytes, name
        self.bytes[name] = bytes(data)
        self.lines.append((name, what, expected))
        for ending, content in beside.items():
            self.beside(name.rpartition(".")[0] + "." + ending, content)

    def beside(self, name, data):
        self.bytes[name] = bytes(data)

    def table(self, head):
        rows = [head, ("---",) * 3] + [(f"`{name}`", what, expected) for name, what, expected in self.lines]
        return "".join("| " + " | ".join(row) + " |\n" for row in rows)


def save_glb(files, name, scene, what, expected):
    """As .glb, with one buffer, the BIN chunk."""
    files.add(name + ".glb", glb(scene.with_buffers([None]), scene.buffers[0]), what, expected)


def save_gltf(files, name, scene, what, expected):
    """As .gltf, with data URIs."""
    files.add(name + ".gltf", gltf(scene.with_buffers(["data"] * len(scene.buffers))), what, expected)
