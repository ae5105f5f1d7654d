# SPDX-License-Identifier: BSD-3-Clause
"""The paper's figures on our models: each function makes one, and returns the text of its block in docs/paper-figures.md."""
import json

import models
import plot
import png
import program
from program import settings
from sections import turns
from table import figure, markdown

OUT = models.ROOT / "build/paper"
PICTURES = models.ROOT / "docs/pictures"
OFF = settings(enclose_mode="off")


class Missing(Exception):
    """A model is not there; the text says which."""


def model_of(name):
    model = models.find(name)
    if model is None:
        raise Missing(f"the model {name} is in none of {', '.join(map(str, models.folders()))}")
    return model


def without(model, dropped):
    """The model with the slides of these names left out."""
    if not dropped:
        return model
    content = json.loads(model.slides.read_text(encoding="utf-8"))
    unknown = set(dropped) - {slide["name"] for slide in content["slides"]}
    if unknown:
        raise ValueError(f"{model.slides.name} has no slide {', '.join(sorted(unknown))}")
    content["slides"] = [slide for slide in content["slides"] if slide["name"] not in dropped]
    file = OUT / f"{model.name}-without-{'-'.join(sorted(dropped))[:60].replace(' ', '_')}.slides.json"
    file.write_text(json.dumps(content), encoding="utf-8")
    return models.Model(model.name, model.file, file)


def pictures(model, name, variants, size, view=()):
    """One picture of the model's cages for several sets of options, side by side: in docs/pictures where the model is ours,
    else in build/paper. `variants`: [(model, options)]."""
    files = []
    for i, (varied, options) in enumerate(variants):
        file = OUT / f"{name}-{i}.png"
        program.cage(varied, OUT / f"{name}-{i}.obj", options, picture=[file, "--picture-size", size, *view])
        files.append(file)
    out = (PICTURES if model.is_own else OUT) / f"{name}.png"
    png.side_by_side(files, out)
    return out


def row_of(report):
    """What the tables say of a cage."""
    tight, sure = report["tightness"], report["certificate"]
    return [figure(tight["volume_ratio"]), figure(tight["mean_gap_over_diagonal"], 4),
            figure(100 * tight["coverage"], 2) if tight["coverage"] is not None else None,
            sure["self_intersections"], sure["vertices_outside"], sure["encloses"]]


ROW_HEAD = ["volume ratio", "mean gap", "coverage, %", "self-intersections", "vertices outside", "encloses"]


def alignment():
    """Figure 5."""
    rows = []
    for name in ("biped", "quadruped", "armadillo"):
        model = model_of(name)
        for value in ("1e6", "4", "0"):
            words = ["--lambda", value]
            scene = OUT / f"{name}-lambda-{value}.glb"
            program.cage(model, scene, [*words, *OFF, "--iterations", "0"])
            seen = turns(scene)
            report = program.cage(model, OUT / f"{name}-lambda-{value}.obj", words)
            rows.append([name, value] + [figure(seen[key], 1) for key in (
                "mean_twist", "worst_twist", "mean_off_radii", "worst_off_radii")]
                + [figure(report["tightness"]["volume_ratio"]), report["certificate"]["encloses"]])
    biped = model_of("biped")
    pictures(biped, "paper-figure-5", [(biped, ["--lambda", value]) for value in ("1e6", "4", "0")], "300x400")
    return markdown(["model", "lambda", "mean twist", "worst twist", "mean off radii", "worst off radii", "volume ratio",
                     "encloses"], rows)


def tightness():
    """Figure 10."""
    rows = []
    model = model_of("biped")
    for delta in ("0", "0.002", "0.005", "0.01", "0.02"):
        words = ["--delta", delta]
        free = program.cage(model, OUT / f"delta-{delta}-off.obj", [*words, *OFF])
        sure = program.cage(model, OUT / f"delta-{delta}.obj", words)
        rows.append([delta, figure(free["tightness"]["volume_ratio"]),
                     figure(-free["refinement"]["max_signed_distance_over_diagonal"][-1], 5),
                     free["refinement"]["converged"], free["certificate"]["vertices_outside"],
                     figure(sure["tightness"]["volume_ratio"]), figure(sure["tightness"]["clearance_over_diagonal"], 5),
                     sure["certificate"]["encloses"]])
    pictures(model, "paper-figure-10", [(model, ["--delta", delta]) for delta in ("0", "0.01")], "420x400")
    return markdown(["delta", "ratio, refined", "least distance by (9)", "converged", "vertices outside",
                     "ratio, certified", "clearance", "encloses"], rows)


def convergence_of(model, options):
    """([largest signed distance over the diagonal], [coverage]) before each step and after the last."""
    words = [*OFF, *options]
    report = program.cage(model, OUT / "convergence.obj", words)
    distances = report["refinement"]["max_signed_distance_over_diagonal"]
    covered = [program.cage(model, OUT / "convergence.obj", [*words, "--iterations", str(step)])["tightness"]["coverage"]
               for step in range(len(distances) - 1)]
    return distances, covered + [report["tightness"]["coverage"]]


def convergence():
    """Figure 11."""
    rows, distances, covered = [], {}, {}
    ways = (("push 8 (default)", []), ("push 1 (the paper's weights)", settings(refine_push="1")))
    for name in ("armadillo", "biped"):
        for way, options in ways:
            far, cover = convergence_of(model_of(name), options)
            slides = len(json.loads(model_of(name).slides.read_text(encoding="utf-8"))["slides"])
            rows.append([f"{name}, {slides} slides, {way}", len(far) - 1, figure(100 * far[0], 2), figure(far[-1], 5),
                         figure(100 * cover[0], 1), figure(100 * cover[-1], 2)])
            if name == "armadillo":
                distances[way] = [(step, 100 * value) for step, value in enumerate(far)]
                covered[way] = [(step, 100 * value) for step, value in enumerate(cover)]
    rows.append(["the paper's Armadillo, 23 slides", 16, None, figure(0.00099, 5), None, None])
    plot.write_curves(PICTURES / "paper-figure-11-distance.svg", "Armadillo: largest signed distance", "step",
                      "% of the diagonal", distances, level=(0.1, "0.1 %"))
    plot.write_curves(PICTURES / "paper-figure-11-coverage.svg", "Armadillo: coverage", "step", "% of the surface inside",
                      covered)
    return markdown(["cage", "steps", "distance at first, %", "distance at last", "coverage at first, %",
                     "coverage at last, %"], rows)


def compared(name, cases, road=()):
    """Rows of a model with sets of slides left out: refined, and certified. `cases`: [(what, names)]."""
    rows = []
    model = model_of(name)
    for what, dropped in cases:
        varied = without(model, dropped)
        slides = len(json.loads(varied.slides.read_text(encoding="utf-8"))["slides"])
        for way, options in (("refined", OFF), ("certified", [])):
            start = [name, what, slides, way]
            try:
                report = program.cage(varied, OUT / "compared.obj", [*options, *road])
                rows.append(start + row_of(report))
            except program.ProgramError as error:
                rows.append(start + [str(error).split(": ", 2)[-1]] + [None] * (len(ROW_HEAD) - 1))
    return rows


COMPARED_HEAD = ["model", "slides", "number", "cage", *ROW_HEAD]


def kinds_of_cuts():
    """Figure 12."""
    rows = compared("quadruped", [("all", []), ("no cross section at the knees", QUADRUPED_KNEES),
                                  ("no sharp corner: poll", ["poll"]), ("no bump: hump", ["hump"])])
    rows += compared("armadillo", [("all", []), ("no cross section at the knees", ["left knee", "right knee"]),
                                   ("no sharp corners: heels", ["left heel", "right heel"]),
                                   ("no bump: back shell", ["back shell"])])
    model = model_of("quadruped")
    pictures(model, "paper-figure-12", [(without(model, dropped), []) for dropped in ([], ["poll"], ["hump"])], "400x340",
             ["--picture-from", "1,0.3,0.5"])
    return markdown(COMPARED_HEAD, rows)


QUADRUPED_KNEES = ["left_foreleg_knee", "right_foreleg_knee"]
BUNNY_BUMPS = ["face", "chest", "front paws", "left haunch", "left hind foot", "right haunch", "right hind foot", "tail",
               "back"]


def bumps():
    """Figure 15."""
    blob = model_of("blob")
    low = ["low_front_east", "low_front_west", "low_back_west", "low_back_east"]
    rows = compared("bunny00", [("all", []), ("no bump cuts", BUNNY_BUMPS)])
    rows += compared("blob", [("all", []), ("without the five low ones", [*low, "low_front_west_tip"])])
    pictures(blob, "paper-figure-15", [(blob, []), (without(blob, [*low, "low_front_west_tip"]), [])], "360x340")
    bunny = model_of("bunny00")
    pictures(bunny, "paper-figure-15-bunny00", [(bunny, []), (without(bunny, BUNNY_BUMPS), [])], "480x440")
    return markdown(COMPARED_HEAD, rows)


def high_genus():
    """Figure 17."""
    rows = []
    for name in ("genus3", "elephant", "elk"):
        report = program.cage(model_of(name), OUT / f"genus-{name}.obj")
        steps, times = report["refinement"]["max_signed_distance_over_diagonal"], report["timings_ms"]
        rows.append([name, report["model"]["genus"], report["cage"]["genus"], len(report["slides"]),
                     report["cage"]["triangles"], report["refinement"]["iterations"], figure(steps[-1], 5),
                     figure(report["tightness"]["volume_ratio"]), report["certificate"]["encloses"],
                     figure(times["orient"] + times["meshing"], 1), figure(times["refine"], 1)])
    model = model_of("genus3")
    pictures(model, "paper-figure-17", [(model, OFF), (model, [])], "420x440")
    return markdown(["model", "genus", "of the cage", "slides", "triangles", "steps", "distance at last", "volume ratio",
                     "encloses", "orient + mesh, ms", "refine, ms"], rows)


def touching_legs():
    """Figure 18."""
    rows = []
    for name in ("legs", "man"):
        model = model_of(name)
        for way, options in (("as meshed", [*OFF, "--iterations", "0"]), ("refined (enclose.mode=off)", OFF),
                             ("default road", []), ("free", settings(enclose_in_plane="false"))):
            report = program.cage(model, OUT / "touching.obj", options)
            rows.append([name, way, *row_of(report)])
    model = model_of("legs")
    pictures(model, "paper-figure-18", [(model, OFF), (model, [])], "360x440", ["--picture-from", "0.3,0.15,1"])
    return markdown(["model", "cage", *ROW_HEAD], rows)
