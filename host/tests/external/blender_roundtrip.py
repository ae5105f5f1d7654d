# SPDX-License-Identifier: BSD-3-Clause
"""Blender imports scenes of ours, shows the slides as empties and the cages as meshes, and exports them again.

    blender -b --factory-startup --python-exit-code 3 -P blender_roundtrip.py -- IN OUT.glb [IN OUT.glb]...

Writes OUT.glb with extras and OUT.plain.glb without. Exit: 0 all is where it should be; 1 not, with one line for each
IN; 3 this script failed.
"""
import os
import re
import sys

import numpy

# Blender 3.4's glTF add-on asks for a name that numpy 1.24 no longer has.
if "bool" not in numpy.__dict__:
    numpy.bool = bool

import bpy  # noqa: E402

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True
from gltf_file import CAGE, SLIDE, GltfFile, multiply  # noqa: E402

# Blender keeps transforms and positions in single precision.
TOLERANCE = 1e-5

# glTF's Y is up, Blender's Z: (x, y, z) becomes (x, -z, y), for the scene and for every object's own axes.
TO_BLENDER = [[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]
FROM_BLENDER = [[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]]


class CheckError(Exception):
    pass


def expect(condition, sentence):
    if not condition:
        raise CheckError(sentence)


def ask_blender(operator, **options):
    try:
        result = operator(**options)
    except RuntimeError as error:
        reason = [line for line in str(error).splitlines() if line and not line.startswith("Location:")][-1]
        raise CheckError(f"Blender's {operator.idname_py()} fails: {reason}") from error
    expect(result == {"FINISHED"}, f"Blender's {operator.idname_py()} ends with {result}")


def import_scene(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    ask_blender(bpy.ops.import_scene.gltf, filepath=path)
    bpy.context.view_layer.update()


def flat(matrix):
    return [matrix[i][j] for i in range(4) for j in range(4)]


def distance(thing, wanted):
    return max(abs(a - b) for a, b in zip(flat(thing.matrix_world), flat(wanted)))


def world_matrix(scene, number):
    """Of a node in Blender's axes; where an animation moves a node above it, as that one stands in Blender."""
    local, moved = scene.matrix_below_moved(number)
    matrix = multiply(multiply(TO_BLENDER, local), FROM_BLENDER)
    if moved is None:
        return matrix
    name = scene.nodes[moved].get("name", "")
    above = [o for o in bpy.data.objects if o.name == name]
    expect(len(above) == 1, f"there are {len(above)} objects called {name!r} in Blender, not one")
    return multiply([list(row) for row in above[0].matrix_world], matrix)


def plain_name(name):
    """Blender gives a name only once: a second "waist" is called "waist.001"."""
    return re.sub(r"\.\d{3}$", "", name)


def object_of(kind, scene, number):
    """The object that the node has become, by custom property and name; of several it is the nearest one."""
    name, wanted = scene.nodes[number]["name"], world_matrix(scene, number)
    found = [o for o in bpy.data.objects if kind in o and plain_name(o.name) == plain_name(name)]
    expect(found, f"no object in Blender is called {name!r} and has the property {kind}")
    thing = min(found, key=lambda o: distance(o, wanted))
    off = distance(thing, wanted)
    expect(off <= TOLERANCE * max(map(abs, flat(wanted))),
           f"{name!r} is elsewhere in Blender: its world matrix is off by {off:.3g}")
    return thing


def check_slides(scene):
    slides = scene.own_nodes(SLIDE)
    for number, _, value in slides:
        thing = object_of(SLIDE, scene, number)
        expect(thing.type == "EMPTY", f"slide {thing.name!r} is a {thing.type} in Blender, not an EMPTY")
        expect(thing[SLIDE]["id"] == value["id"], f"slide {thing.name!r} has the id {thing[SLIDE]['id']} in Blender")
    return len(slides)


def check_cages(scene):
    cages = scene.own_nodes(CAGE)
    for number, node, _ in cages:
        thing = object_of(CAGE, scene, number)
        expect(thing.type == "MESH", f"cage {thing.name!r} is a {thing.type} in Blender, not a MESH")
        positions, triangles = scene.cage_positions(node)
        vertices, faces = thing.data.vertices, thing.data.polygons
        expect(len(vertices) == len(positions),
               f"cage {thing.name!r} has {len(vertices)} vertices in Blender, not {len(positions)}")
        expect(len(faces) == triangles and all(len(face.vertices) == 3 for face in faces),
               f"cage {thing.name!r} has {len(faces)} faces in Blender, not {triangles} triangles")
        size = max(abs(x) for p in positions for x in p)
        off = max(abs(b - g) for v, (x, y, z) in zip(vertices, positions) for b, g in zip(v.co, (x, -z, y)))
        expect(off <= TOLERANCE * size, f"cage {thing.name!r}: a vertex is off by {off:.3g} in Blender")
    return len(cages)


def export_scene(path, extras):
    ask_blender(bpy.ops.export_scene.gltf, filepath=path, export_format="GLB", export_extras=extras)
    return GltfFile(path)


def check_exported(scene, path):
    with_extras = export_scene(path, True)
    without = export_scene(path[:-len(".glb")] + ".plain.glb", False)
    for kind in SLIDE, CAGE:
        wanted = sorted(plain_name(node["name"]) for _, node, _ in scene.own_nodes(kind))
        kept = sorted(plain_name(node["name"]) for _, node, _ in with_extras.own_nodes(kind))
        expect(kept == wanted, f"Blender exported {kept} as {kind}, not {wanted}")
        expect(not without.own_nodes(kind), f"exported without extras it still has {kind}")
        names = {plain_name(node.get("name", "")) for node in without.nodes}
        expect(names.issuperset(wanted), f"exported without extras it lacks some of {wanted}")


def round_trip(path, out):
    scene = GltfFile(path)
    import_scene(path)
    slides, cages = check_slides(scene), check_cages(scene)
    expect(slides + cages > 0, "holds neither slides nor cages")
    check_exported(scene, out)
    print(f"blender_roundtrip.py: {path}: {slides} slides and {cages} cages are in place and exported again")


def main(arguments):
    if not arguments or len(arguments) % 2 or not all(out.endswith(".glb") for out in arguments[1::2]):
        sys.exit("blender_roundtrip.py: usage: blender_roundtrip.py -- IN OUT.glb [IN OUT.glb]...")
    failed = False
    for path, out in zip(arguments[::2], arguments[1::2]):
        try:
            round_trip(os.path.abspath(path), os.path.abspath(out))
        except CheckError as error:
            print(f"blender_roundtrip.py: {path}: {error}", file=sys.stderr)
            failed = True
    sys.exit(1 if failed else 0)


main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
