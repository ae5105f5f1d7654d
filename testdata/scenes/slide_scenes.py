# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that hold cut slides and cages, as docs/scene-format.md says, fresh or after other tools have had them."""
import math

from scene_parts import Scene, glb, limb, limb_scene, raw, save_glb, save_gltf, tower

SLIDE, CAGE = "CAGEWRIGHT_cut_slide", "CAGEWRIGHT_cage"
TURN = [-0.7071067811865476, 0, 0, 0.7071067811865476]  # local Z becomes Y, along the limb; local Y becomes -Z
LEVELS = {"waist": (0.06, 0.245, 0.196), "foot": (-0.52, 0.255, 0.204)}  # of each slide: height and radii


def transform(name):
    y, rx, rz = LEVELS[name]
    return {"translation": [0, y, 0], "rotation": TURN, "scale": [rx, rz, round((rx + rz) / 2, 6)]}


def slide(name, identity, **more):
    """A slide's node as we write it; `more` are keys of its extension."""
    return {"name": name, **transform(name), "extensions": {SLIDE: {"id": identity, **more}},
            "extras": {SLIDE: {"id": identity}}}


def stroke(name):
    """Five sixths of the way round the slide, wavering a little about its plane."""
    y, rx, rz = LEVELS[name]
    angles = [math.pi * 2 * 5 / 6 * i / 15 for i in range(16)]
    points = [(rx * math.cos(a), y + 0.01 * math.sin(5 * a), rz * math.sin(a)) for a in angles]
    return [[round(c, 4) for c in p] for p in points]


def fitted(name):
    return [value for part in transform(name).values() for value in part]


def cage(source, mesh, slides, **more):
    """The node of a cage round the limb that the slides, which are numbers, cut at most once."""
    corners = [0] * 4 + [-1] * 8 if slides else [-1] * 8
    certificate = {"closed": True, "self_intersections": None, "model_cage_intersections": None,
                   "vertices_outside": None, "encloses": None}
    return {"name": "limb cage", "mesh": mesh,
            "extensions": {CAGE: {"source": source, "parameters": {"orient.lambda": 4, "refine.delta": 0.01},
                                  "slides": slides, "sections": corners, "certificate": certificate, **more}},
            "extras": {CAGE: {"slides": slides}}}


def cage_mesh(scene, level=None):
    """A box with a section at this height, or without one; in a new buffer. The number of the mesh."""
    levels = [-1.125, 1.125] if level is None else [-1.125, level, 1.125]
    points, triangles = tower(levels, 0.375, 0.3125)
    if level is not None:  # the section's corners come first
        order = [4, 5, 6, 7, 0, 1, 2, 3, 8, 9, 10, 11]
        points = [points[i] for i in order]
        triangles = [tuple(order.index(i) for i in t) for t in triangles]
    scene.buffers.append(bytearray())
    last = len(scene.buffers) - 1
    return scene.mesh("limb cage", scene.primitive(points, triangles, last, last))


def plain_scenes(files):
    scene = limb_scene()
    scene.node(0, **slide("waist", 1, stroke=stroke("waist"), fitted=fitted("waist")))
    scene.node(0, **slide("foot", 7))
    scene.uses(SLIDE)
    save_gltf(files, "slides_plain", scene,
              "two slides as we write them; the first has its stroke", "slides 1 `waist` (stroke) and 7 `foot`")
    save_glb(files, "slides_plain", scene, "the same as .glb", "the same")

    scene = limb_scene()
    scene.node(0, **slide("waist", 3))
    scene.node(0, **cage(0, cage_mesh(scene, LEVELS["waist"][0]), [3]))
    scene.uses(SLIDE, CAGE)
    save_gltf(files, "slides_cage", scene,
              "a slide and the cage made from it",
              "slide 3 `waist`; a cage of 12 vertices whose first 4 are the slide's section")
    files.add("slides_cage.glb", glb(scene.with_buffers([None, "data"]), scene.buffers[0]),
              "the same as .glb: the cage's buffer is a data URI there too", "the same")

    scene = limb_scene()
    scene.node(0, **slide("foot", 4))
    scene.node(0, **cage(0, cage_mesh(scene, LEVELS["waist"][0]), [3]))
    scene.uses(SLIDE, CAGE)
    save_gltf(files, "slides_cage_slide_deleted", scene,
              "the slide that the cage was made from is gone, another one has come",
              "slide 4 `foot`; the cage as it was")

    scene = Scene()
    for name, place in (("left", -2), ("right", 2)):
        mesh = scene.mesh(name, scene.primitive(*limb((place / 32, 0, 0))))
        scene.node(name=name, mesh=mesh, translation=[place, 0, 0])
    for node in (0, 1):
        scene.node(node, **slide("waist", node + 1) | {"name": "waist " + scene.root["nodes"][node]["name"]})
        moved = scene.root["nodes"][-1]
        moved["translation"] = [scene.root["nodes"][node]["translation"][0] / 32, *moved["translation"][1:]]
    for node in (0, 1):
        scene.node(node, **cage(node, cage_mesh(scene), []))
    scene.uses(SLIDE, CAGE)
    save_gltf(files, "slides_two_caged_meshes", scene,
              "two mesh nodes, each with a slide and a cage", "slide 1 of `left`, slide 2 of `right`, a cage each")

    scene = limb_scene()
    scene.node(name="again", mesh=0, translation=[2, 0, 0])
    scene.node(0, **slide("waist", 1))
    scene.node(1, **slide("foot", 2))
    scene.uses(SLIDE)
    save_gltf(files, "slides_instanced_mesh", scene,
              "two nodes show one mesh; a slide under each", "slide 1 of `limb`, slide 2 of `again`")

    scene = limb_scene()
    scene.root |= {"images": [], "cameras": [], "extensionsUsed": []}
    scene.node(0, **slide("waist", 1, keeps=["/nodes/0/children", "/extensionsUsed"]))
    scene.uses(SLIDE)
    save_gltf(files, "slides_keeps", scene,
              "`children` and `extensionsUsed` were empty before the slide came; `images` and `cameras` still are",
              "both are there and empty again when the slide is removed")


def moved_scenes(files):
    y, rx, rz = LEVELS["waist"]
    scene = limb_scene()
    node = slide("waist", 1)
    for key in ("translation", "rotation", "scale"):
        del node[key]
    scene.node(0, **node, matrix=[rx, 0, 0, 0, 0, 0, -rz, 0, 0, 0.22, 0, 0, 0, y, 0, 1])
    scene.uses(SLIDE)
    save_gltf(files, "slides_moved_matrix", scene,
              "the slide's transform is a matrix",
              "slide 1: centre (0, 0.06, 0), u (0.245, 0, 0), v (0, 0, -0.196)")

    scene = limb_scene()
    node = slide("waist", 1, stroke=stroke("waist"), fitted=fitted("waist")) | {"translation": [0, 0.15, 0]}
    scene.node(0, **node)
    scene.uses(SLIDE)
    save_gltf(files, "slides_moved_stroke", scene,
              "the slide is no longer where `fitted` says that it was",
              "the ellipse at y = 0.15; the stroke no longer counts")

    scene = limb_scene()
    node = slide("waist", 1)
    node |= {"rotation": [0.5, -0.5, -0.5, -0.5], "scale": [-rz, rx, 17]}
    scene.node(0, **node)
    scene.uses(SLIDE)
    save_gltf(files, "slides_moved_odd_scale", scene,
              "Y is the longer radius, X is mirrored, Z has a length that means nothing, the quaternion is negated",
              "u (0, 0, 0.196), v (-0.245, 0, 0), normal (0, 1, 0) as Z says, though u x v is the other way")

    scene = limb_scene()
    sheared = scene.node(0, name="group", rotation=[0, 0.3826834323650898, 0, 0.9238795325112867], scale=[1, 1, 1.25])
    scene.node(sheared, **slide("waist", 1) | {"rotation": [-0.6532814824381883, -0.27059805007309845,
                                                             -0.27059805007309845, 0.6532814824381883]})
    scene.uses(SLIDE)
    save_gltf(files, "slides_moved_sheared", scene,
              "between slide and mesh node is a node that turns and scales, so X and Y are no longer perpendicular",
              "the ellipse that the unit circle maps to, still at y = 0.06")


def copied_and_dropped_scenes(files):
    scene = limb_scene()
    scene.node(0, **slide("waist", 2))
    scene.node(0, **slide("waist", 2) | {"translation": [0, -0.25, 0]})
    scene.node(0, **slide("foot", 3) | {"name": "waist.2"})
    scene.uses(SLIDE)
    save_gltf(files, "slides_duplicated", scene,
              "a slide was duplicated, id and name; the name that the copy should get is taken",
              "three slides with ids and names of their own, as is said; node 1 keeps `waist` and 2, node 3 its id 3")

    scene = limb_scene()
    for name, identity in (("waist", 5), ("foot", 6)):
        node = slide(name, identity)
        del node["extensions"]
        scene.node(0, **node)
    node = cage(0, cage_mesh(scene, LEVELS["waist"][0]), [5])
    del node["extensions"]
    scene.node(0, **node)
    save_gltf(files, "slides_extension_dropped", scene,
              "a tool dropped the extensions and kept extras", "slides 5 `waist` and 6 `foot`, and a cage")

    scene = limb_scene()
    node = slide("waist", 1)
    del node["extensions"], node["extras"]
    scene.node(0, **node)
    scene.node(0, name="limb cage", mesh=cage_mesh(scene))
    save_gltf(files, "slides_all_dropped", scene,
              "extensions and extras are both gone",
              "no slide, no cage; two mesh nodes")


def tree_scenes(files):
    scene = limb_scene()
    group = scene.node(0, name="controls", translation=[0, 0.5, 0])
    inner = scene.node(group, name="inner", scale=[2, 2, 2])
    placed = slide("waist", 1) | {"translation": [0, -0.22, 0], "scale": [0.1225, 0.098, 0.11]}
    parent = scene.node(inner, **placed)
    scene.node(parent, name="foot", translation=[0, 0, -2.5], extensions={SLIDE: {"id": 2}}, extras={SLIDE: {"id": 2}})
    scene.uses(SLIDE)
    save_gltf(files, "slides_deep", scene,
              "a slide three nodes below the mesh node, and a slide below that slide",
              "slide 1: centre (0, 0.06, 0), u (0.245, 0, 0); slide 2: centre (0, -0.49, 0), the same radii")

    scene = limb_scene()
    parent = scene.node(0, **slide("waist", 1) | {"extras": {"mine": [1, None], SLIDE: {"id": 1}}})
    scene.root["nodes"][parent]["extensions"]["ACME_unknown"] = {"more": raw("1.0")}
    scene.node(parent, name="lamp", translation=[0, 0, 1], extras={"watts": 40})
    scene.uses(SLIDE, "ACME_unknown")
    save_gltf(files, "slides_foreign_child", scene,
              "a tool gave the slide's node a child, an extension and an extra",
              "slide 1; when it is removed, node 1 stays with `lamp`, the extension and the extra")

    scene = limb_scene()
    scene.node(0, **slide("waist", 1))
    scene.node(0, **cage(0, cage_mesh(scene, LEVELS["waist"][0]), [1]))
    scene.node(0, **slide("foot", 2))
    scene.buffers.append(bytearray())
    ball = scene.mesh("ball", scene.primitive(*tower([0.0, 1.0], 0.5, 0.5), 2, 2))
    lamp = scene.node(name="lamp", translation=[3, 0, 0])
    scene.node(lamp, name="ball", mesh=ball)
    scene.uses(SLIDE, CAGE)
    save_gltf(files, "slides_before_foreign_nodes", scene,
              "nodes 1 to 3 are ours, 4 and 5 came later, as did mesh 2 with its buffer",
              "slides 1 and 2, a cage, two other mesh nodes (`limb`, `ball`), whose numbers stay when ours are removed")

    scene = limb_scene()
    scene.node(**slide("waist", 1))
    scene.uses(SLIDE)
    save_gltf(files, "slides_parent_gone", scene,
              "the slide is at the root of the scene; there is one mesh node", "slide 1 of `limb`")

    scene = Scene()
    scene.node(name="lamp")
    mesh = scene.mesh("limb", scene.primitive(*limb()))
    scene.node(scene.node(name="root"), name="limb", mesh=mesh)
    scene.node(2, **slide("waist", 1))
    scene.node(2, **cage(0, cage_mesh(scene, LEVELS["waist"][0]), [1]))
    scene.uses(SLIDE, CAGE)
    save_gltf(files, "slides_cage_source_renumbered", scene,
              "`source` names node 0, a lamp, as it did before a tool counted nodes anew",
              "a cage of its parent, node 2")


def add_slides(files):
    plain_scenes(files)
    moved_scenes(files)
    copied_and_dropped_scenes(files)
    tree_scenes(files)
