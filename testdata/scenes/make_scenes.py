#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the scenes of this folder, broken/ and README.md:  make_scenes.py OUTDIR

The same bytes on every machine. Needs Python 3.9 and nothing else. Run it on this folder after a change here.
"""
import pathlib
import sys
import textwrap

sys.dont_write_bytecode = True  # no __pycache__ in the source tree

from asset_scenes import add_assets  # noqa: E402
from broken_scenes import add_broken  # noqa: E402
from scene_parts import Files  # noqa: E402
from slide_scenes import add_slides  # noqa: E402

README = """# Scenes

Small glTF 2.0 scenes with one property each; the name begins with what it is about. `make_scenes.py` makes all of them
and this text (`python3 make_scenes.py .`), a test runs it again and compares every byte, and another one
(`../tests/scene_files_test.py`) checks with a reader of its own that the scenes are what they are said to be.

The model is a limb, a capsule along Y from -1 to 1 with the radii 0.25 (X) and 0.2 (Z): 51 vertices and 98 triangles,
closed, manifold, outward, of genus 0. A slide fits across it anywhere, so each scene can be given slides and caged.

{invalid}

## Without slides

{assets}
## With slides and cages

What is expected is what `docs/scene-format.md` says. Coordinates are in the mesh node's local space.

{slides}
## Broken

In `broken/`. Each has to be refused with one sentence; the column on the right says what it has to name. All but those
that begin with `slide_` and `cage_` are a box of 12 triangles in which one thing is wrong.

{broken}"""

INVALID = ("json_empty_children.gltf", "json_empty_extensions_used.gltf", "json_empty_images.gltf",
           "json_empty_lists.gltf", "slides_keeps.gltf", "material_missing_image.gltf")


def main(arguments):
    if len(arguments) != 2:
        sys.exit("usage: make_scenes.py OUTDIR")
    out = pathlib.Path(arguments[1])
    assets, slides, broken = Files(), Files(), Files()
    add_assets(assets)
    add_slides(slides)
    add_broken(broken)
    invalid = "Khronos' glTF validator finds no error in them but in those that are invalid on purpose, as such " \
        "files are common: " + ", ".join(f"`{name}`" for name in INVALID) + "."
    readme = README.format(invalid=textwrap.fill(invalid, 120, break_on_hyphens=False),
                           assets=assets.table(("file", "what is in it", "what is expected")),
                           slides=slides.table(("file", "what is in it", "what is expected")),
                           broken=broken.table(("file", "what is wrong", "what the sentence names")))
    (out / "broken").mkdir(parents=True, exist_ok=True)
    for folder, files in ((out, assets), (out, slides), (out / "broken", broken)):
        for name, data in files.bytes.items():
            (folder / name).write_bytes(data)
    (out / "README.md").write_bytes(readme.encode())


if __name__ == "__main__":
    main(sys.argv)
