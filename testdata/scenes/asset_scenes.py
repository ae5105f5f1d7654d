# SPDX-License-Identifier: BSD-3-Clause
"""Scenes without slides and cages: what the file holds beside geometry, and every way in which geometry is stored."""
import struct

import scene_parts
from scene_parts import (PROFILE, SEGMENTS, TOP, VERTICES, Scene, chunk, described, glb, gltf, limb, limb_scene,
                         normals_of, packed, picture, raw)

READ = "98 triangles"


def save_glb(files, name, scene, what, expected=READ):
    scene_parts.save_glb(files, name, scene, what, expected)


def save_gltf(files, name, scene, what, expected=READ):
    scene_parts.save_gltf(files, name, scene, what, expected)


def textured_limb():
    scene = limb_scene()
    points, triangles = limb()
    attributes = scene.root["meshes"][0]["primitives"][0]["attributes"]
    attributes["NORMAL"] = scene.accessor(normals_of(points, triangles), "f", VERTICES)
    attributes["TEXCOORD_0"] = scene.accessor([(0.5 + x, 0.5 - y / 2) for x, y, _ in points], "f", VERTICES)
    scene.root["meshes"][0]["primitives"][0]["material"] = scene.add("materials", {
        "name": "chequered", "doubleSided": True, "alphaMode": "MASK", "alphaCutoff": 0.25,
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 0}, "baseColorFactor": [1, 1, 1.0, 0.5],
                                 "metallicFactor": 0.0, "roughnessFactor": 1}})
    scene.add("samplers", {"magFilter": 9728, "minFilter": 9987, "wrapS": 33071, "wrapT": 10497})
    scene.add("textures", {"sampler": 0, "source": 0})
    return scene


def material_scenes(files):
    scene = textured_limb()
    scene.add("images", {"name": "squares", "mimeType": "image/png", "bufferView": scene.view(picture())})
    save_glb(files, "material_texture", scene, "material, sampler, texture, PNG in a buffer view")

    scene = textured_limb()
    scene.add("images", {"uri": "material_external_image.png"})
    files.add("material_external_image.gltf", gltf(scene.with_buffers(["material_external_image.bin"])),
              "image and buffer are files beside it", READ, bin=scene.buffers[0], png=picture())

    scene = textured_limb()
    scene.add("images", {"uri": "there_is_no_such_image.png"})
    save_gltf(files, "material_missing_image", scene, "names an image that is not there",
              READ + "; images are not opened")


def buffer_scenes(files):
    scene = limb_scene()
    save_gltf(files, "buffers_data_uri", scene, "the buffer is a data URI")
    root = scene.with_buffers(["data"])
    root["buffers"][0]["uri"] = root["buffers"][0]["uri"].replace("octet-stream", "gltf-buffer")
    files.add("buffers_data_uri_gltf_buffer.gltf", gltf(root), "data URI of the type application/gltf-buffer", READ)
    files.add("buffers_percent_encoded.gltf", gltf(scene.with_buffers(["buffers%20percent%2Dencoded.bin"])),
              "the URI of the buffer is percent-encoded: a blank, a hyphen", READ)
    files.beside("buffers percent-encoded.bin", scene.buffers[0])
    files.add("buffers_glb_without_bin.glb", glb(scene.with_buffers(["data"])), "no BIN chunk; data URI", READ)
    files.add("buffers_glb_unknown_chunk.glb",
              glb(scene.with_buffers([None]), scene.buffers[0],
                  chunk(b"\0\1\2\3", b"") + chunk(b"ACME", b"kept as is!!")),
              "two chunks of unknown types after BIN, the first of them empty", READ + "; the chunks are kept")
    padded = limb_scene()
    padded.view(b"ABCDE")
    save_glb(files, "buffers_glb_padded", padded, "BIN chunk 3 bytes longer than its buffer")

    two = Scene()
    two.buffers.append(bytearray())
    two.node(name="limb", mesh=two.mesh("limb", two.primitive(*limb(), index_buffer=1)))
    files.add("buffers_external_and_data_uri.gltf",
              gltf(two.with_buffers(["buffers_external_and_data_uri.bin", "data"])),
              "positions in a file beside it, indices in a data URI", READ, bin=two.buffers[0])
    files.add("buffers_glb_bin_and_external.glb",
              glb(two.with_buffers([None, "buffers_glb_bin_and_external.bin"]), two.buffers[0]),
              "positions in the BIN chunk, indices in a file beside it", READ, bin=two.buffers[1])


def stored_limb(attributes, indices=None, mode=None):
    """A scene of a limb; `attributes` and `indices` are called with the scene and make its accessors."""
    scene = Scene()
    primitive = {"attributes": attributes(scene)}
    if indices:
        primitive["indices"] = indices(scene)
    if mode is not None:
        primitive["mode"] = mode
    scene.node(name="limb", mesh=scene.mesh("limb", primitive))
    return scene


def positions(points):
    return lambda scene: {"POSITION": scene.accessor(points, "f", VERTICES, True)}


def index_scenes(files):
    points, triangles = limb()
    for component, bits in (("B", 8), ("H", 16), ("I", 32)):
        save_glb(files, f"geometry_indices_{bits}bit",
                 stored_limb(positions(points), lambda s, c=component: s.indices(triangles, c)),
                 f"{bits}-bit indices")
    save_glb(files, "geometry_unindexed", stored_limb(positions([points[i] for t in triangles for i in t])),
             "no indices; closed once equal positions are welded")

    strip = []  # from pole to pole for each segment; joined by two corners, so that each part starts at an even one
    for j in range(SEGMENTS):
        k = (j + 1) % SEGMENTS
        part = [0] + [1 + SEGMENTS * ring + i for ring in range(len(PROFILE)) for i in (j, k)] + [TOP]
        strip += [strip[-1], part[0], *part] if strip else part
    save_glb(files, "geometry_strip", stored_limb(positions(points), lambda s: s.indices([strip]), 5),
             "one triangle strip, with triangles without area where it jumps")

    around = [i % SEGMENTS for i in range(SEGMENTS + 1)]
    below, above = [1 + i for i in around], [TOP - 1 - i for i in around]
    scene = stored_limb(positions(points), lambda s: s.indices([[0, *below]]), 6)
    for mode, corners in ((6, [[TOP, *above]]), (4, [t for t in triangles if 0 not in t and TOP not in t])):
        scene.root["meshes"][0]["primitives"].append(
            {"attributes": {"POSITION": 0}, "indices": scene.indices(corners), "mode": mode})
    save_glb(files, "geometry_fans", scene, "two triangle fans, and triangles between; they share positions")

    scene = limb_scene()
    for mode, corners in ((0, [[0, TOP]]), (1, [[0, TOP]]), (3, [[1, 2, 3]])):
        scene.root["meshes"][0]["primitives"].append(
            {"attributes": {"POSITION": 0}, "indices": scene.indices(corners), "mode": mode})
    save_glb(files, "geometry_points_and_lines", scene, "points and lines beside the triangles",
             READ + "; a note says that 3 primitives are not used")


def layout_scenes(files):
    points, triangles = limb()
    normals = normals_of(points, triangles)

    def interleaved(scene):
        rows = b"".join(
            struct.pack("<6f2H4B", *p, *n, round(65535 * (0.5 + p[0])), round(32767 * (1 - p[1])), 250, 200, 150, 255)
            for p, n in zip(points, normals))
        view = scene.view(rows, target=VERTICES, byteStride=32)
        keys = {"bufferView": view}
        return {name: scene.add("accessors", described(values, component, name == "POSITION", **keys, **more))
                for name, values, component, more in (
                    ("NORMAL", normals, "f", {"byteOffset": 12}), ("POSITION", points, "f", {"byteOffset": 0}),
                    ("TEXCOORD_0", [(0, 0)] * len(points), "H", {"byteOffset": 24, "normalized": True}),
                    ("COLOR_0", [(0, 0, 0, 0)] * len(points), "B", {"byteOffset": 28, "normalized": True}))}

    save_glb(files, "geometry_interleaved", stored_limb(interleaved, lambda s: s.indices(triangles)),
             "byteStride 32: positions, normals, normalised 16-bit texture coordinates and 8-bit colours")

    for name, component, normalized, values, placed, what in (
            ("short_normalized", "h", True, [tuple(round(32767 * c) for c in p) for p in points], {},
             "positions are normalised signed 16-bit"),
            ("byte", "B", False, [tuple(round(127.5 * (c + 1)) for c in p) for p in points],
             {"translation": [-1, -1, -1], "scale": [0.00784313725490196] * 3},
             "positions are unsigned 8-bit, from 0 to 255; the node scales them")):
        scene = stored_limb(lambda s, c=component, n=normalized, v=values: {
            "POSITION": s.accessor(v, c, VERTICES, True, **({"normalized": True} if n else {})),
            "NORMAL": s.accessor([tuple(round(127 * x) for x in n) for n in normals], "b", VERTICES, normalized=True),
        }, lambda s: s.indices(triangles))
        scene.root["nodes"][0] |= placed
        scene.uses("KHR_mesh_quantization")
        scene.root["extensionsRequired"] = ["KHR_mesh_quantization"]
        save_glb(files, "geometry_quantized_" + name, scene, what + "; KHR_mesh_quantization is required")


def sparse_scenes(files):
    points, triangles = limb()

    def sparse(scene, rows, component, base):
        """Puts these rows, number and value, in the place of the accessor's."""
        scene.root["accessors"][base]["sparse"] = {
            "count": len(rows),
            "indices": {"bufferView": scene.view(packed([(i,) for i, _ in rows], component)),
                        "componentType": {"B": 5121, "H": 5123}[component]},
            "values": {"bufferView": scene.view(packed([v for _, v in rows], "f"))}}

    def partly(scene):
        moved = {0, 7, 30, TOP}
        base = scene.accessor([(9.0, 9.0, 9.0) if i in moved else p for i, p in enumerate(points)], "f", VERTICES)
        scene.root["accessors"][base] |= described(points, "f", True)
        sparse(scene, [(i, points[i]) for i in sorted(moved)], "B", base)
        return {"POSITION": base}

    def wholly(scene):
        base = scene.add("accessors", described(points, "f", True))
        sparse(scene, list(enumerate(points)), "H", base)
        return {"POSITION": base}

    save_glb(files, "geometry_sparse", stored_limb(partly, lambda s: s.indices(triangles)),
             "4 of the positions are sparse; what they replace is at (9, 9, 9)", READ + ", all within 1 of 0")
    save_glb(files, "geometry_sparse_without_view", stored_limb(wholly, lambda s: s.indices(triangles)),
             "positions without a buffer view: all of them are sparse", READ + ", all within 1 of 0")

    scene = limb_scene()
    bulge = scene.accessor([(x / 4, 0.0, 0.0) for x, _, _ in points], "f", VERTICES, True)
    tip = scene.add("accessors", described([(0.0, 0.0, 0.0), (0.0, 0.25, 0.0)], "f", True))
    scene.root["accessors"][tip]["count"] = len(points)
    sparse(scene, [(TOP, (0.0, 0.25, 0.0))], "B", tip)
    mesh = scene.root["meshes"][0]
    mesh["primitives"][0]["targets"] = [{"POSITION": bulge}, {"POSITION": tip}]
    mesh |= {"weights": [0, 0.25], "extras": {"targetNames": ["bulge", "tip"]}}
    scene.root["nodes"][0]["weights"] = [0.5, 0]
    times = scene.accessor([(0.0,), (1.5,)], bounds=True)
    weights = scene.accessor([(0.0,), (1.0,), (1.0,), (0.0,)])
    scene.add("animations", {"name": "breath", "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
                             "samplers": [{"input": times, "output": weights}]})
    save_glb(files, "geometry_morph_targets", scene, "two morph targets, one sparse without a buffer view; animated",
             READ + "; targets are not applied")


def moving_scenes(files):
    points, triangles = limb()
    scene = limb_scene()
    scene.root["nodes"][0] |= {"skin": 0}
    attributes = scene.root["meshes"][0]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = scene.accessor([(0, 1, 0, 0)] * len(points), "B", VERTICES)
    weights = [min(max(round(128 * (1 - y)), 1), 255) / 256 for _, y, _ in points]
    attributes["WEIGHTS_0"] = scene.accessor([(w, 1 - w, 0.0, 0.0) for w in weights], "f", VERTICES)
    hip = scene.node(name="hip", translation=[0, -1, 0])
    knee = scene.node(hip, name="knee", translation=[0, 1.0, 0], rotation=[0, 0, 0, 1])
    inverse = [(1.0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, float(y), 0, 1) for y in (1, 0)]
    scene.add("skins", {"joints": [hip, knee], "skeleton": hip, "inverseBindMatrices": scene.accessor(inverse)})
    save_glb(files, "geometry_skin", scene, "skin of two joints with inverse bind matrices",
             READ + "; the skin is not applied")
    del scene.root["skins"][0]["inverseBindMatrices"]
    save_glb(files, "geometry_skin_without_matrices", scene, "skin without inverse bind matrices, which is allowed",
             READ + "; the skin is not applied")

    scene = limb_scene()
    times = scene.accessor([(0.0,), (0.5,), (2.0,)], bounds=True)
    turns = scene.accessor([(0.0, 0.0, 0.0, 1.0), (0.0, 0.6, 0.0, 0.8), (0.0, 0.0, 0.0, 1.0)])
    moves = scene.accessor([(0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)])
    scene.add("animations", {"channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}},
                                          {"sampler": 1, "target": {"node": 0, "path": "translation"}}],
                             "samplers": [{"input": times, "output": turns},
                                          {"input": times, "interpolation": "STEP", "output": moves}]})
    save_glb(files, "geometry_animation", scene, "the mesh node turns and moves", READ + "; at rest")


def two_limbs():
    scene = Scene()
    meshes = [scene.mesh(name, scene.primitive(*limb((0, shift, 0)))) for name, shift in (("lower", 0), ("upper", 3))]
    return scene, meshes


def node_scenes(files):
    two = "2 mesh nodes of 98 triangles"
    scene, meshes = two_limbs()
    for mesh in meshes:
        scene.node(name="limb", mesh=mesh)
    save_glb(files, "nodes_several_meshes", scene, "two meshes, whose nodes have the same name", two)

    scene = limb_scene()
    scene.node(name="again", mesh=0, translation=[2, 0, 0])
    save_gltf(files, "nodes_instanced_mesh", scene, "two nodes show one mesh", two)

    scene, meshes = two_limbs()
    scene.node(name="not shown", mesh=meshes[0])
    shown = scene.add("nodes", {"name": "shown", "mesh": meshes[1], "translation": [0, 0, 2]})
    shared = scene.add("nodes", {"name": "in both"})
    scene.add("nodes", {"name": "in none", "mesh": meshes[0]})
    scene.root["scenes"] = [{"name": "first", "nodes": [0, shared]}, {"nodes": [shown, shared]}, {"name": "nothing"}]
    scene.root["scene"] = 1
    save_gltf(files, "nodes_several_scenes", scene, "three scenes, one without nodes; the second is the default one")

    scene = limb_scene()
    del scene.root["scene"], scene.root["scenes"]
    save_gltf(files, "nodes_without_scene", scene, "nodes, but no scenes")

    placed = [("translation_rotation_scale", {"translation": [0.5, -0.25, 2], "rotation": [0.5, 0.5, -0.5, 0.5],
                                              "scale": [2, 2, 2]}, "translation, rotation and scale"),
              ("matrix", {"matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 0.5, -0.25, 2, 1]}, "a matrix"),
              ("negative_scale", {"scale": [-1, 1, 1]}, "a mirroring scale"),
              ("non_uniform_scale", {"rotation": [0, 0, 0.6, 0.8], "scale": [0.5, 3, 1]}, "a non-uniform scale")]
    for name, keys, what in placed:
        scene = Scene()
        root = scene.node(name="root", **keys)
        scene.node(root, name="limb", mesh=scene.mesh("limb", scene.primitive(*limb())), **keys)
        save_gltf(files, "nodes_" + name, scene, "mesh node and its parent have " + what)

    scene = Scene()
    parent = scene.node(scale=[1.01, 1, 0.99])
    for _ in range(198):
        parent = scene.node(parent, translation=[0.01, 0, 0])
    scene.node(parent, name="limb", mesh=scene.mesh("limb", scene.primitive(*limb())))
    save_glb(files, "nodes_deep", scene, "the mesh node is 200 deep")


KEPT = READ + "; every value is kept as it is"


def json_object_scenes(files):
    scene = limb_scene()
    scene.add("cameras", {"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01}})
    scene.add("cameras", {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1.0, "zfar": 10, "znear": 0}})
    scene.node(name="eye", camera=0, translation=[0, 0, 5])
    save_gltf(files, "json_camera_without_zfar", scene, "a camera without `zfar`", READ + "; no `zfar` appears")

    scene = limb_scene()
    scene.uses("KHR_lights_punctual")
    scene.root["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "color": [1, 0.9, 0.8], "spot": {"innerConeAngle": 0.1}}, {"type": "point", "range": 3.5}]}}
    scene.node(extensions={"KHR_lights_punctual": {"light": 1}})
    save_gltf(files, "json_lights", scene, "KHR_lights_punctual: two lights, one with a node", KEPT)

    scene = textured_limb()
    scene.add("images", {"uri": "material_external_image.png"})
    scene.uses("KHR_texture_transform")
    scene.root["extensionsRequired"] = ["KHR_texture_transform"]
    scene.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        "KHR_texture_transform": {"offset": [0, 1], "rotation": 1.5, "scale": [0.5, 0.5]}}
    save_gltf(files, "json_required_extension", scene, "an extension is required that geometry has nothing to do with",
              KEPT)


def json_value_scenes(files):
    scene = limb_scene()
    scene.root["nodes"][0]["extras"] = {
        "null": None, "nulls": [None, [None], {"": None}], "array": [], "object": {}, "arrays": [[], [[]], {}],
        "true": True, "false": False}
    scene.root["extras"] = [None]
    scene.root["asset"]["extras"] = None
    scene.root["meshes"][0]["extras"] = []
    scene.root["accessors"][0]["extras"] = {}
    scene.root["bufferViews"][0]["extras"] = "text"
    scene.root["scenes"][0]["extras"] = 0
    scene.root["meshes"][0]["primitives"][0]["extras"] = False
    save_gltf(files, "json_extras", scene, "nulls, empty arrays and objects, and plain values as extras", KEPT)
    save_glb(files, "json_extras", scene, "the same as .glb", KEPT)

    scene = limb_scene()
    numbers = ["0", "-0", "-0.0", "1.0", "1e3", "1E+3", "1e-7", "0.1", "0.1000000000000000055", "3.141592653589793238",
               "9007199254740993", "9223372036854775807", "-9223372036854775808", "18446744073709551615",
               "18446744073709551616", "123456789012345678901234567890", "-123456789012345678901234567890",
               "5e-324", "1.7976931348623157e308", "100000000000000000000.0", "2147483648", "4294967296", "1.50"]
    scene.root["nodes"][0] |= {"translation": [raw("1.0"), raw("1e0"), raw("-0.0")],
                               "scale": [raw("1.00"), 1, raw("10e-1")],
                               "extras": {f"n{i}": raw(text) for i, text in enumerate(numbers)}}
    save_gltf(files, "json_numbers", scene, "numbers of every spelling, integers up to and beyond 64 bits",
              READ + "; every number keeps its letters")
    save_glb(files, "json_numbers", scene, "the same as .glb", READ + "; every number keeps its letters")

    scene = limb_scene("Körper 身体 🦴")
    scene.root["nodes"][0]["extras"] = {
        "escapes": raw(r'"\" \\ \/ \b \f \n \r \t \u0000 \u001f \u007f"'), "accents": raw(r'"\u00e9 \u00C9 é"'),
        "pair": raw(r'"\ud83e\uddb4"'), "line ends": "\u2028\u2029", "": "empty key", raw(r'"k\u0065y"'): 1, "a/b~c": 2,
        "brackets": "[\n] {}", "looks like a number": "1e3"}
    save_gltf(files, "json_strings", scene, "names that are not ASCII, escapes, an empty key, a key with / and ~", KEPT)

    scene = limb_scene()
    root = scene.with_buffers(["data"])
    order = ("buffers", "nodes", "accessors", "scene", "meshes", "bufferViews", "scenes", "asset")
    odd = {key: root[key] for key in order}
    odd["nodes"][0] = {"mesh": 0, "extras": {"z": 1, "a": 2, "M": 3, "10": 4, "9": 5}, "name": "limb"}
    files.add("json_key_order.gltf", gltf(odd), "keys in an odd order, `asset` last", KEPT + ", in the same order")
    files.add("json_whitespace.gltf", b"\r\n\t " + gltf(root).replace(b"\n", b"\r\n\t") + b" \r\n",
              "white space before, between and after; CR LF", READ)


def unknown_extension_scenes(files):
    scene = textured_limb()
    root = scene.root
    scene.add("images", {"name": "squares", "mimeType": "image/png", "bufferView": scene.view(picture())})
    scene.add("cameras", {"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})
    scene.node(camera=0)
    scene.node(name="joint")
    unit = scene.accessor([(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)])
    scene.add("skins", {"joints": [2], "inverseBindMatrices": unit})
    times = scene.accessor([(0.0,), (1.0,)], bounds=True)
    scene.add("animations", {"channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}], "samplers": [
        {"input": times, "output": scene.accessor([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)])}]})
    rest = described([(0.0,)] * 2, "f")
    rest["sparse"] = {"count": 1, "indices": {"bufferView": scene.view(b"\1"), "componentType": 5121},
                      "values": {"bufferView": scene.view(bytes(4))}}
    scene.add("accessors", rest)

    sampler, channel = root["animations"][0]["samplers"][0], root["animations"][0]["channels"][0]
    places = [root, root["asset"], channel, channel["target"], sampler, root["cameras"][0]["perspective"],
              root["materials"][0]["pbrMetallicRoughness"],
              root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"],
              root["meshes"][0]["primitives"][0], rest["sparse"], rest["sparse"]["indices"], rest["sparse"]["values"]]
    for array in ("scenes", "nodes", "meshes", "materials", "textures", "images", "samplers", "accessors",
                  "bufferViews", "skins", "animations", "cameras"):
        places += root[array]
    for count, place in enumerate(places):
        place["extensions"] = {"ACME_unknown": {"number": count, "mesh": 0, "nodes": [0, 1], "none": None, "empty": []}}
    scene.uses("ACME_unknown")
    full = scene.with_buffers([None])
    full["buffers"][0]["extensions"] = {"ACME_unknown": {"number": len(places), "byteLength": 2**40}}
    files.add("json_unknown_extensions.glb", glb(full, scene.buffers[0]),
              "an unknown extension on every kind of object that there is", READ + "; all of it is kept")


def empty_array_scenes(files):
    for name, what, at_root, in_node, in_mesh, in_primitive in (
            ("children", '`"children": []` on the mesh node', (), ("children",), (), ()),
            ("extensions_used", '`"extensionsUsed": []`', ("extensionsUsed", "extensionsRequired"), (), (), ()),
            ("images", '`"images": []` and the like', ("images", "textures", "samplers", "materials"), (), (), ()),
            ("lists", "other arrays that are empty by mistake", ("animations", "cameras", "skins"), (), ("weights",),
             ("targets",))):
        scene = limb_scene()
        mesh = scene.root["meshes"][0]
        for place, keys in ((scene.root, at_root), (scene.root["nodes"][0], in_node), (mesh, in_mesh),
                            (mesh["primitives"][0], in_primitive)):
            place |= {key: [] for key in keys}
        save_gltf(files, "json_empty_" + name, scene, what, READ + "; empty arrays stay")


def add_assets(files):
    for add in (material_scenes, buffer_scenes, index_scenes, layout_scenes, sparse_scenes, moving_scenes, node_scenes,
                json_object_scenes, json_value_scenes, unknown_extension_scenes, empty_array_scenes):
        add(files)
