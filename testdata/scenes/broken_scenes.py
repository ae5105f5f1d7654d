# SPDX-License-Identifier: BSD-3-Clause
"""Files that have to be refused with one sentence. Each is a good scene of one box with one thing made wrong."""
import copy
import struct

from scene_parts import (BIN_CHUNK, JSON_CHUNK, Scene, chunk, glb, glb_file, gltf, json_text, packed, raw,
                         tower)
from slide_scenes import CAGE, SLIDE, cage, cage_mesh, slide

GONE = object()  # instead of a value: the key is taken out


def box_scene():
    """Node 0 shows mesh 0: 8 vertices (accessor 0, view 0), 36 16-bit indices (accessor 1, view 1), 168 bytes."""
    scene = Scene()
    scene.node(name="box", mesh=scene.mesh("box", scene.primitive(*tower([-1.0, 1.0], 0.5, 0.25))))
    return scene


def changed(root, changes):
    """The JSON with a value put at each of these places, as "nodes/0/mesh"; at the end of an array is "nodes/1"."""
    root = copy.deepcopy(root)
    for pointer, value in changes.items():
        place, *keys = [root], "0", *pointer.split("/")
        for key, following in zip(keys, keys[1:]):
            place = place[int(key)] if isinstance(place, list) else place.setdefault(key, {})
        key = keys[-1]
        if value is GONE:
            del place[key]
            continue
        value = copy.deepcopy(value)  # cases share values
        if isinstance(place, list):
            place[int(key):int(key) + 1] = [value]
        else:
            place[key] = value
    return root


TREE = {"nodes/1": {"children": [0]}, "scenes/0/nodes": [1]}

# Name, what is changed in the box's JSON, what the sentence names, and in words what is wrong.
JSON_CASES = [
    # JSON of the wrong types
    ("type_asset_missing", {"asset": GONE}, "`asset`", "no `asset`"),
    ("type_asset_version_1", {"asset/version": "1.0"}, "version 1.0", "glTF 1.0"),
    ("type_asset_version_3", {"asset/version": "3.0"}, "version 3.0", "glTF 3.0"),
    ("type_asset_version_number", {"asset/version": 2.0}, "`asset.version`", "the version is a number"),
    ("type_asset_min_version", {"asset/minVersion": "2.9"}, "version 2.9", "a reader of at least 2.9 is asked for"),
    ("type_nodes_object", {"nodes": {"0": {"mesh": 0}}}, "`nodes`", "`nodes` is an object"),
    ("type_node_number", {"nodes/1": 5}, "node 1", "a node is a number"),
    ("type_node_null", {"nodes/1": None}, "node 1", "a node is null"),
    ("type_node_mesh_string", {"nodes/0/mesh": "0"}, "node 0", "`mesh` is a string"),
    ("type_node_mesh_fraction", {"nodes/0/mesh": 0.5}, "node 0", "`mesh` is 0.5"),
    ("type_node_name_number", {"nodes/0/name": 7}, "node 0", "`name` is a number"),
    ("type_node_children_number", {"nodes/0/children": 1}, "node 0", "`children` is a number"),
    ("type_node_children_strings", {"nodes/0/children": ["a"]}, "node 0", "`children` are strings"),
    ("type_node_translation_of_2", {"nodes/0/translation": [1, 2]}, "node 0", "a translation of two numbers"),
    ("type_node_translation_strings", {"nodes/0/translation": ["1", "2", "3"]}, "node 0",
     "a translation of strings"),
    ("type_node_matrix_of_12", {"nodes/0/matrix": [1] * 12}, "node 0", "a matrix of twelve numbers"),
    ("type_scenes_number", {"scenes": 1}, "`scenes`", "`scenes` is a number"),
    ("type_mesh_string", {"meshes/0": "box"}, "mesh 0", "a mesh is a string"),
    ("type_primitives_missing", {"meshes/0/primitives": GONE}, "mesh 0", "no `primitives`"),
    ("type_primitives_object", {"meshes/0/primitives": {}}, "mesh 0", "`primitives` is an object"),
    ("type_attributes_array", {"meshes/0/primitives/0/attributes": [0]}, "mesh 0", "`attributes` is an array"),
    ("type_position_string", {"meshes/0/primitives/0/attributes/POSITION": "0"}, "mesh 0",
     "POSITION is a string"),
    ("type_mode_9", {"meshes/0/primitives/0/mode": 9}, "mesh 0", "mode 9"),
    ("type_accessor_count_string", {"accessors/0/count": "8"}, "accessor 0", "`count` is a string"),
    ("type_accessor_count_missing", {"accessors/0/count": GONE}, "accessor 0", "no `count`"),
    ("type_accessor_component_type", {"accessors/0/componentType": 9999}, "accessor 0", "component type 9999"),
    ("type_accessor_type", {"accessors/0/type": "VEC9"}, "accessor 0", "type VEC9"),
    ("type_positions_of_2", {"accessors/0/type": "VEC2"}, "accessor 0", "positions are VEC2"),
    ("type_indices_float", {"accessors/1/componentType": 5126, "accessors/1/count": 18}, "accessor 1",
     "indices are floats"),
    ("type_stride_2", {"bufferViews/0/byteStride": 2}, "view 0", "byteStride 2, less than an element has"),
    ("type_stride_300", {"bufferViews/0/byteStride": 300}, "view 0", "byteStride 300"),
    ("type_buffers_number", {"buffers": 168}, "`buffers`", "`buffers` is a number"),
    ("type_buffer_uri_number", {"buffers/0/uri": 5}, "buffer 0", "`uri` is a number"),
    ("type_extensions_used_object", {"extensionsUsed": {}}, "`extensionsUsed`", "`extensionsUsed` is an object"),
    # Indices out of range, and negative ones
    ("index_of_node_mesh", {"nodes/0/mesh": 7}, "node 0", "names mesh 7 of 1"),
    ("index_of_child", {"nodes/0/children": [9]}, "node 9", "names node 9 of 1"),
    ("index_of_root_node", {"scenes/0/nodes/1": 4}, "node 4", "names node 4 of 1"),
    ("index_of_scene", {"scene": 3}, "scene 3", "the default scene is 3 of 1"),
    ("index_of_skin", {"nodes/0/skin": 0}, "node 0", "names skin 0 of none"),
    ("index_of_position", {"meshes/0/primitives/0/attributes/POSITION": 2}, "mesh 0", "names accessor 2 of 2"),
    ("index_of_indices", {"meshes/0/primitives/0/indices": 2**31}, "mesh 0", "names accessor 2^31"),
    ("index_of_view", {"accessors/0/bufferView": 2}, "accessor 0", "names view 2 of 2"),
    ("index_of_buffer", {"bufferViews/1/buffer": 1}, "view 1", "names buffer 1 of 1"),
    ("index_beyond_32_bits", {"nodes/0/mesh": 2**32}, "node 0", "names mesh 2^32, which 32 bits take for 0"),
    ("index_beyond_64_bits", {"nodes/0/mesh": 2**64}, "node 0", "names mesh 2^64, which 64 bits take for 0"),
    ("index_of_vertex", {"accessors/0/count": 7}, "vertex 7", "an index names vertex 7 of 7"),
    ("negative_mesh", {"nodes/1": {"mesh": -1}, "scenes/0/nodes/1": 1}, "node 1", "names mesh -1"),
    ("negative_child", {"nodes/0/children": [-1]}, "node 0", "names node -1"),
    ("negative_scene", {"scene": -1}, "scene -1", "the default scene is -1"),
    ("negative_indices", {"meshes/0/primitives/0/indices": -1, "accessors/0/count": 6}, "mesh 0",
     "names accessor -1 for its indices"),
    ("negative_view", {"accessors/0/bufferView": -1}, "accessor 0", "names view -1"),
    ("negative_buffer", {"bufferViews/0/buffer": -1}, "view 0", "names buffer -1"),
    ("negative_count", {"accessors/0/count": -8}, "accessor 0", "count -8"),
    ("negative_offset", {"accessors/0/byteOffset": -4}, "accessor 0", "byteOffset -4"),
    ("negative_view_offset", {"bufferViews/1/byteOffset": -4}, "view 1", "byteOffset -4"),
    ("negative_byte_length", {"buffers/0/byteLength": -168}, "buffer 0", "byteLength -168"),
    # Nodes that are no trees
    ("nodes_own_child", {"nodes/0/children": [0]}, "node 0", "a node is its own child"),
    ("nodes_cycle", TREE | {"nodes/0/children": [1]}, "node 0", "nodes 0 and 1 are children of each other"),
    ("nodes_cycle_apart", {"nodes/1": {"children": [2]}, "nodes/2": {"children": [1]}}, "node 1",
     "nodes 1 and 2, in no scene, are children of each other"),
    ("nodes_two_parents", {"nodes/1": {"children": [0]}, "nodes/2": {"children": [0]}, "scenes/0/nodes": [1, 2]},
     "node 0", "a node has two parents"),
    ("nodes_child_twice", TREE | {"nodes/1/children": [0, 0]}, "node 0", "a node is the same node's child twice"),
    ("nodes_root_and_child", TREE | {"scenes/0/nodes": [1, 0]}, "node 0", "a node is at the root and a child"),
    # Sizes
    ("size_view_beyond_buffer", {"bufferViews/1/byteLength": 74}, "view 1", "2 bytes beyond its buffer"),
    ("size_view_wraps", {"bufferViews/1/byteOffset": 2**64 - 8, "bufferViews/1/byteLength": 80}, "view 1",
     "offset and length together 2**64 round 2^64"),
    ("size_view_offset_beyond_64_bits", {"bufferViews/1/byteOffset": 2**64 + 96}, "view 1",
     "an offset beyond 64 bits"),
    ("size_accessor_beyond_view", {"accessors/0/count": 9}, "accessor 0", "12 bytes beyond its view"),
    ("size_accessor_offset", {"accessors/1/byteOffset": 2}, "accessor 1", "2 bytes beyond its view"),
    ("size_accessor_offset_wraps", {"accessors/0/byteOffset": 2**64 - 4}, "accessor 0", "an offset of 2^64 - 4"),
    ("size_count_enormous", {"accessors/0/count": 2**40}, "accessor 0", "2^40 positions"),
    ("size_count_wraps", {"accessors/0/count": 2**62 + 8}, "accessor 0",
     "2^62 + 8 positions: 12 bytes each 2**64 round 2^64 to 96"),
    ("size_count_enormous_without_view", {"accessors/0/count": 2**40, "accessors/0/bufferView": GONE},
     "accessor 0", "2^40 positions without a view, which would all be 0"),
    ("size_index_count_enormous", {"accessors/1/count": 3 * 2**40}, "accessor 1", "3 * 2^40 indices"),
    ("size_indices_35", {"accessors/1/count": 35}, "mesh 0", "35 indices, not a multiple of 3"),
    ("size_buffer_shorter_than_said", {"buffers/0/byteLength": 1000}, "buffer 0",
     "the data URI has 168 bytes, not 1000"),
    # URIs
    ("uri_missing_file", {"buffers/0/uri": "there_is_no_such_file.bin"}, "there_is_no_such_file.bin",
     "the buffer's file is not there"),
    ("uri_folder", {"buffers/0/uri": "."}, "buffer 0", "the buffer's file is a folder"),
    ("uri_http", {"buffers/0/uri": "https://example.org/box.bin"}, "buffer 0", "a buffer elsewhere"),
    ("uri_bad_base64", {"buffers/0/uri": "data:application/octet-stream;base64,%%%%"}, "buffer 0",
     "base64 with letters that it does not have"),
    ("uri_without_comma", {"buffers/0/uri": "data:application/octet-stream;base64"}, "buffer 0",
     "a data URI without data"),
    ("uri_none", {"buffers/0/uri": GONE}, "buffer 0", "a .gltf's buffer without a URI"),
    # Numbers
    ("number_infinite", {"nodes/0/translation": [0, raw("1e999"), 0]}, "node 0", "1e999, beyond a double"),
    ("number_nan", {"nodes/0/translation": [0, raw("NaN"), 0]}, "NaN", "NaN, which JSON does not have"),
    ("number_infinity", {"nodes/0/scale": [1, raw("-Infinity"), 1]}, "Infinity", "-Infinity, which JSON does not have"),
    # Nothing to cage, or nothing that can be read
    ("holds_no_mesh", {"nodes/0": {}, "meshes": GONE, "accessors": GONE, "bufferViews": GONE, "buffers": GONE},
     "no triangles", "good glTF with nothing to cage"),
    ("holds_lines_only", {"meshes/0/primitives/0/mode": 1}, "no triangles", "good glTF: lines only"),
    ("draco", {"extensionsUsed": ["KHR_draco_mesh_compression"],
               "extensionsRequired": ["KHR_draco_mesh_compression"],
               "accessors/0/bufferView": GONE, "accessors/1/bufferView": GONE,
               "meshes/0/primitives/0/extensions": {
                   "KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}},
     "Draco", "Draco compression; its data are no Draco data"),
    ("meshopt", {"extensionsUsed": ["EXT_meshopt_compression"], "extensionsRequired": ["EXT_meshopt_compression"],
                 "buffers/1": {"byteLength": 96, "extensions": {"EXT_meshopt_compression": {"fallback": True}}},
                 "bufferViews/0": {"buffer": 1, "byteLength": 96, "byteStride": 12, "extensions": {
                     "EXT_meshopt_compression": {"buffer": 0, "byteLength": 96, "byteStride": 12, "count": 8,
                                                 "mode": "ATTRIBUTES"}}}},
     "meshopt", "meshopt compression; its data are no meshopt data"),
]


def slide_cases():
    """Slides and cages of the wrong types. Node 1 is the slide `waist` of id 1, node 2 the cage, both under node 0."""
    place, box = f"nodes/1/extensions/{SLIDE}", f"nodes/2/extensions/{CAGE}"
    good = [0.0] * 3 + [0, 0, 0, 1] + [1.0] * 3
    values = (
        ("extension_array", "", [1], "the extension is an array"),
        ("extension_null", "", None, "the extension is null"),
        ("id_missing", "id", GONE, "the extension has no `id`"),
        ("id_string", "id", "1", "`id` is a string"),
        ("id_0", "id", 0, "`id` is 0"),
        ("id_negative", "id", -1, "`id` is -1"),
        ("id_fraction", "id", 1.5, "`id` is 1.5"),
        ("id_beyond_64_bits", "id", 2**70, "`id` is 2^70"),
        ("stroke_number", "stroke", 5, "`stroke` is a number"),
        ("stroke_of_strings", "stroke", ["a", "b", "c", "d", "e"], "`stroke` is an array of strings"),
        ("stroke_points_of_2", "stroke", [[0, 0], [1, 0], [1, 1], [0, 1], [0, 2]], "points of two numbers"),
        ("stroke_infinite", "stroke", [[0, 0, raw("1e999")], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 2, 0]],
         "a number beyond a double"),
        ("fitted_of_9", "fitted", good[:9], "`fitted` has nine numbers"),
        ("fitted_object", "fitted", {}, "`fitted` is an object"),
        ("keeps_string", "keeps", "/nodes/0/children", "`keeps` is a string"))
    cases = [("slide_" + name, {f"{place}/{key}".rstrip("/"): value}, "slide `waist`", what)
             for name, key, value, what in values]
    cases += [(name, {"nodes/1/scale": scale}, "slide `waist`", what) for name, scale, what in (
        ("slide_scale_0", [0.5, 0, 0.5], "the ellipse has no area"),
        ("slide_scale_infinite", [0.5, 0.5, raw("1e400")], "a scale beyond a double"))]
    values = (
        ("extension_number", "", 3, "the extension is a number"),
        ("source_string", "source", "box", "`source` is a string"),
        ("parameters_array", "parameters", [4], "`parameters` is an array"),
        ("slides_object", "slides", {}, "`slides` is an object"),
        ("slides_fraction", "slides", [0.5], "`slides` has 0.5"),
        ("sections_too_few", "sections", [-1], "`sections` has 1 number for 8 vertices"),
        ("sections_out_of_range", "sections", [3] + [-1] * 7, "`sections` names row 3 of `slides`, which has none"),
        ("sections_strings", "sections", ["a"] * 8, "`sections` are strings"),
        ("certificate_string", "certificate", "closed", "`certificate` is a string"))
    cases += [("cage_" + name, {f"{box}/{key}".rstrip("/"): value}, "cage `limb cage`", what)
              for name, key, value, what in values]
    return cases + [
        ("slide_parent_gone_of_two", {"nodes/0/children": [2], "nodes/3": {"name": "again", "mesh": 0},
                                      "scenes/0/nodes": [0, 1, 3]}, "slide `waist`",
         "the slide is under no mesh node and there are two of them"),
    ]


def sparse_box(rows, **keys):
    """The box with these rows in the place of its first positions."""
    scene = box_scene()
    entry = {"count": len(rows), "indices": {"bufferView": scene.view(packed([(i,) for i in rows], "B")),
                                             "componentType": 5121},
             "values": {"bufferView": scene.view(packed([(0.5, -1.0, 0.25)] * len(rows), "f"))}}
    scene.root["accessors"][0]["sparse"] = entry | keys
    return gltf(scene.with_buffers(["data"]))


def chunk_scenes(files):
    """What is wrong with the chunks of a .glb."""
    scene = box_scene()
    root, binary = scene.with_buffers([None]), bytes(scene.buffers[0])
    good = glb(root, binary)
    text = json_text(root).encode()
    text += b" " * (-len(text) % 4)
    json_chunk, bin_chunk = chunk(JSON_CHUNK, text), chunk(BIN_CHUNK, binary)

    def with_length(data, at, difference):
        """The file with another number at this byte."""
        return data[:at] + struct.pack("<I", struct.unpack_from("<I", data, at)[0] + difference) + data[at + 4:]

    bin_at = 12 + len(json_chunk)
    for name, data, culprit, what in (
            ("magic", b"glTG" + good[4:], "the first bytes", "the magic is glTG"),
            ("version_1", glb_file(json_chunk + bin_chunk, 1), "version 1", "binary glTF 1"),
            ("version_3", glb_file(json_chunk + bin_chunk, 3), "version 3", "binary glTF 3"),
            ("length_too_long", with_length(good, 8, 4), "byte 8", "the header says 4 bytes more than there are"),
            ("length_too_short", with_length(good, 8, -4), f"byte {bin_at}, the last chunk, and byte 8",
             "the header says 4 bytes less than there are"),
            ("length_0", with_length(good, 8, -len(good)), "byte 8", "the header says 0 bytes"),
            ("json_chunk_too_long", with_length(good, 12, 4), f"byte {bin_at + 4}, where no chunk is, and byte 12",
             "the JSON chunk ends 4 bytes late"),
            ("json_chunk_too_short", with_length(good, 12, -4), f"byte {bin_at - 4}, where no chunk is, and byte 12",
             "the JSON chunk ends 4 bytes early"),
            ("json_chunk_enormous", with_length(good, 12, 2**32 - 1 - len(text)), "byte 12",
             "the JSON chunk's length is 2^32 - 1"),
            ("json_chunk_empty", glb_file(struct.pack("<I", 0) + JSON_CHUNK), "byte 12", "the JSON chunk is empty"),
            ("json_chunk_odd", glb_file(struct.pack("<I", len(text) + 1) + JSON_CHUNK + text + b" " + bin_chunk),
             "byte 12", "the JSON chunk's length is no multiple of 4"),
            ("bin_chunk_too_long", with_length(good, bin_at, 4), f"byte {bin_at}", "the BIN chunk ends after the file"),
            ("bin_chunk_too_short", with_length(good, bin_at, -4),
             f"byte {len(good) - 4}, where no chunk is, and byte {bin_at}",
             "the BIN chunk ends 4 bytes early"),
            ("bin_chunk_odd", glb_file(json_chunk + struct.pack("<I", 169) + BIN_CHUNK + binary + b"\0"),
             f"byte {bin_at}", "the BIN chunk's length is no multiple of 4"),
            ("bin_chunk_first", glb_file(bin_chunk + json_chunk), "byte 16", "the BIN chunk is the first one"),
            ("bin_shorter_than_buffer", glb_file(json_chunk + chunk(BIN_CHUNK, binary[:-4])), "buffer 0",
             "the BIN chunk is 4 bytes shorter than its buffer"),
            ("bin_missing", glb_file(json_chunk), "buffer 0", "the buffer's BIN chunk is not there"),
            ("truncated_in_header", good[:7], "cut short", "ends after 7 bytes"),
            ("truncated_in_json", good[:200], "cut short", "ends within the JSON"),
            ("truncated_in_bin", good[:-50], "cut short", "ends within the BIN chunk"),
            ("empty", b"", "empty", "no bytes at all")):
        files.add(f"glb_{name}.glb", data, what, culprit)


def text_scenes(files):
    """What is wrong with the text of a .gltf."""
    scene = box_scene()
    whole = gltf(scene.with_buffers(["data"]))

    def with_extras(text):
        return whole.replace(b'"scene": 0,', b'"scene": 0, "extras": ' + text + b",")

    for name, data, culprit, what in (
            ("empty", b"", "empty", "no bytes at all"),
            ("truncated", whole[:len(whole) // 2], "where it ends", "ends in the middle"),
            ("comma", whole.replace(b'"scene": 0,', b'"scene": 0,,'), "line 6", "a comma too many"),
            ("garbage_after", whole + b"{}", "line", "more JSON after the end"),
            ("key_twice", whole.replace(b'"scene": 0,', b'"scene": 0, "scene": 0,'), "`scene`", "a key twice"),
            ("not_utf8", whole.replace(b'"name": "box"', b'"name": "b\xf6x"'), "UTF-8", "a name in Latin-1"),
            ("lone_surrogate", whole.replace(b'"name": "box"', b'"name": "\\ud800"'), "line", "half a surrogate pair"),
            ("root_array", b"[]\n", "the root", "the root is an array"),
            ("root_null", b"null\n", "the root", "the root is null"),
            ("root_empty_object", b"{}\n", "`asset`", "the root is an empty object"),
            ("nested_arrays", with_extras(b"[" * 10000 + b"]" * 10000), "nested",
             "extras of 10,000 arrays in one another"),
            ("nested_objects", with_extras(b'{"":' * 5000 + b"0" + b"}" * 5000), "nested",
             "extras of 5,000 objects in one another"),
            ("nested_unclosed", b"[" * 10000, "nested", "10,000 arrays that never end")):
        files.add(f"json_{name}.gltf", data, what, culprit)

    files.add("uri_file_too_short.gltf", gltf(scene.with_buffers(["uri_file_too_short.bin"])),
              "the buffer's file is 4 bytes shorter than the buffer", "buffer 0", bin=scene.buffers[0][:-4])


def value_scenes(files):
    """What is wrong in the buffers."""
    points, triangles = tower([-1.0, 1.0], 0.5, 0.25)
    for name, value in (("nan", float("nan")), ("infinity", float("inf"))):
        scene = box_scene()
        scene.buffers[0][12 * 5:12 * 5 + 4] = struct.pack("<f", value)
        files.add(f"position_{name}.glb", glb(scene.with_buffers([None]), scene.buffers[0]),
                  f"x of vertex 5 is {name}", "vertex 5")
    files.add("index_of_vertex_in_data.glb", vertex_index_box(points, triangles, 8), "an index names vertex 8 of 8",
              "vertex 8")
    files.add("index_restart.glb", vertex_index_box(points, triangles, 0xFFFF),
              "an index is 65535, which restarts a primitive", "vertex 65535")
    files.add("sparse_index_of_vertex.gltf", sparse_box([0, 8]), "a sparse index names position 8 of 8", "accessor 0")
    files.add("sparse_not_rising.gltf", sparse_box([1, 0]), "sparse indices that do not rise", "accessor 0")
    files.add("sparse_count_enormous.gltf", sparse_box([0], count=2**40), "2^40 sparse positions", "accessor 0")
    files.add("sparse_view.gltf", sparse_box([0], values={"bufferView": 9}), "sparse values in view 9 of 4",
              "accessor 0")


def vertex_index_box(points, triangles, index):
    scene = Scene()
    scene.node(mesh=scene.mesh("box", scene.primitive(points, [*triangles[:-1], (*triangles[-1][:2], index)])))
    return glb(scene.with_buffers([None]), scene.buffers[0])


def add_broken(files):
    chunk_scenes(files)
    text_scenes(files)
    root = box_scene().with_buffers(["data"])
    for name, changes, culprit, what in JSON_CASES:
        files.add(name + ".gltf", gltf(changed(root, changes)), what, culprit)
    value_scenes(files)
    scene = box_scene()
    scene.node(0, **slide("waist", 1) | {"scale": [0.6, 0.3, 0.45]})
    scene.node(0, **cage(0, cage_mesh(scene), []))
    scene.uses(SLIDE, CAGE)
    root = scene.with_buffers(["data", "data"])
    for name, changes, culprit, what in slide_cases():
        files.add(name + ".gltf", gltf(changed(root, changes)), what, culprit)
