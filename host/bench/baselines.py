#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""baselines.py [MODEL...]: the table of docs/baselines.md, cages of ours beside those of other ways. Without a model: all
that are there, and the document is written anew. Cages, reports and the whole of the figures go to build/baselines."""
import csv
import json
import shutil
import sys

import models
import program
from table import figure, markdown, write_blocks

OUT = models.ROOT / "build/baselines"
DOCUMENT = models.ROOT / "docs/baselines.md"
OURS = {"ours": [], "ours, free": program.settings(refine_in_plane="false", enclose_in_plane="false")}
OTHERS = {"alpha wrap": "wrap", "offset, decimated": "offset", "voxel grid": "voxels"}
KEYS = ("model", "cage", "triangles", "volume_ratio", "mean_gap", "max_gap", "self_intersections", "encloses", "oracle",
        "seconds", "parameters")


def measured(model, way, cage_file, seconds, parameters=""):
    """The row of one cage file, whoever made it, as `check` and the oracle see it."""
    report = program.check(model.file, cage_file, cage_file.with_suffix(".check.json"))
    seen = program.oracle(model.file, cage_file)
    agreed = None
    if seen:
        agreed = (seen["closed"] and seen["self_intersecting_pairs"] == 0 and seen["model_vertices_outside"] == 0
                  and seen["model_triangles_crossing_cage"] == 0)
    tightness = report["tightness"]
    return {"model": model.name, "cage": way, "triangles": report["cage"]["triangles"],
            "volume_ratio": tightness["volume_ratio"], "mean_gap": tightness["mean_gap_over_diagonal"],
            "max_gap": tightness["max_gap_over_diagonal"],
            "self_intersections": report["certificate"]["self_intersections"],
            "encloses": report["certificate"]["encloses"], "oracle": agreed, "seconds": seconds,
            "parameters": parameters}


def own_rows(model, folder):
    """Ours, as users get it and with free sections. The time is that of the stages, without reading the file."""
    for way, options in OURS.items():
        file = folder / (way.replace(", ", "-") + ".off")
        report = program.cage(model, file, options)
        stages = ("prepare", "segment", "orient", "meshing", "refine", "enclose")
        seconds = sum(report["timings_ms"][stage] or 0 for stage in stages) / 1000
        yield measured(model, way, file, seconds, f"{len(report['slides'])} slides")


def searched(model, method, triangles, file):
    """What cagewright_baselines found, now or when it was last asked the same: a search takes a minute or so."""
    tool, kept = program.BIN / "cagewright_baselines", file.with_suffix(".json")
    if kept.is_file() and kept.stat().st_mtime > max(tool.stat().st_mtime, model.file.stat().st_mtime):
        found = json.loads(kept.read_text(encoding="utf-8"))
        if found["most_triangles"] == triangles:
            return found
    found = json.loads(program.run([tool, method, model.file, triangles, file])[0]) | {"most_triangles": triangles}
    kept.write_text(json.dumps(found) + "\n", encoding="utf-8")
    return found


def other_rows(model, folder, triangles):
    for way, method in OTHERS.items():
        file = folder / (method + ".off")
        found = searched(model, method, triangles, file)
        parameters = f"{found['parameters']} (best of {found['tried']} in {found['search_seconds']:.0f} s)"
        yield measured(model, way, file, found["seconds"], parameters)
    if model.by_hand:
        file = folder / ("by-hand" + model.by_hand.suffix)
        shutil.copyfile(model.by_hand, file)
        yield measured(model, "by hand", file, None, "MVC paper")


def rows_of(model):
    folder = OUT / model.name
    folder.mkdir(parents=True, exist_ok=True)
    rows = list(own_rows(model, folder))
    return rows + list(other_rows(model, folder, rows[0]["triangles"]))


def is_first(rows, key, own=0):
    """Whether the row of that number, one of ours, is smaller than all of others that enclose; None where it does not
    enclose itself."""
    if not rows[own]["encloses"]:
        return None
    return all(rows[own][key] < row[key] for row in rows[len(OURS):] if row["encloses"])


def table(rows):
    head = ["model", "cage", "triangles", "volume ratio", "mean gap", "max gap", "self-intersections", "encloses",
            "oracle agrees", "seconds"]
    cells = []
    for row in rows:
        agreed = None if row["oracle"] is None else row["oracle"] == row["encloses"]
        cells.append([row["model"], row["cage"], row["triangles"], row["volume_ratio"], figure(row["mean_gap"], 4),
                      figure(row["max_gap"], 4), row["self_intersections"], row["encloses"], agreed,
                      figure(row["seconds"], 2)])
    return markdown(head, cells)


def verdict(groups):
    """On how many models ours is smallest of all that enclose, and on which it is not."""
    lines = []
    for own, way in enumerate(OURS):
        for key, name in (("volume_ratio", "volume ratio"), ("mean_gap", "mean gap")):
            behind = [rows[0]["model"] for rows in groups if not is_first(rows, key, own)]
            lines.append(f"- {way}: smallest {name} of all that enclose on {len(groups) - len(behind)} of {len(groups)} models"
                         + (f"; not on {', '.join(behind)}." if behind else "."))
    return "\n".join(lines) + "\n"


def write_files(rows):
    (OUT / "baselines.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    with (OUT / "baselines.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, KEYS)
        writer.writeheader()
        writer.writerows(rows)


def main(names):
    wanted = names or [*models.BY_HAND, *models.REAL, *models.OWN]
    there, missing = models.find_all(wanted)
    if missing:
        print(f"left out, for want of the file (see testdata/README.md): {', '.join(missing)}", file=sys.stderr)
    if not there:
        return 3
    groups = []
    for model in there:
        print(f"{model.name} ...", file=sys.stderr, flush=True)
        groups.append(rows_of(model))
    rows = [row for group in groups for row in group]
    write_files(rows)
    text = table(rows)
    print(text + "\n" + verdict(groups))
    if not names and not missing:
        write_blocks(DOCUMENT, {"table": text, "verdict": verdict(groups)})
        print(f"written: {DOCUMENT}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (program.ProgramError, OSError, ValueError) as error:
        sys.exit(f"baselines: {error}")
