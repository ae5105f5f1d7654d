# SPDX-License-Identifier: BSD-3-Clause
"""How near each idea of enclosing came, for docs/algorithms/enclosing.md: from the refined cage to the tightened ones."""
import models
import program
from figures import OFF, OUT, Missing, model_of, pictures
from program import settings
from table import figure, markdown

FREE = settings(enclose_in_plane="false")
LOOSE = settings(enclose_tighten="false")
ROADS = {
    "refined": OFF,
    "certified, in plane": LOOSE,
    "tightened, in plane": [],
    "certified, free": [*LOOSE, *FREE],
    "tightened, free": FREE,
}
ANGLES = ("5", "15", "45")


def cell(report):
    """Volume ratio / mean gap in thousandths of the diagonal; a star where the cage does not enclose."""
    tight = report["tightness"]
    star = "" if report["certificate"]["encloses"] else "*"
    return f"{figure(tight['volume_ratio'])} / {figure(1000 * tight['mean_gap_over_diagonal'], 1)}{star}"


def tables():
    """{block: text}; models that are not there are left out of the tables and named below them."""
    ratios, angles, missing = [], [], []
    for name in (*models.OWN, *models.REAL):
        try:
            model = model_of(name)
        except Missing:
            missing.append(name)
            continue
        reports = {road: program.cage(model, OUT / "road.obj", options) for road, options in ROADS.items()}
        ratios.append([name, *(cell(report) for report in reports.values())])
        by_angle = {"15": reports["tightened, in plane"]}
        for angle in ANGLES:
            if angle not in by_angle:
                by_angle[angle] = program.cage(model, OUT / "road.obj", settings(enclose_corner_angle=angle))
        angles.append([name, *(cell(by_angle[angle]) for angle in ANGLES)])
    note = f"\nNot measured, for want of the model: {', '.join(missing)}.\n" if missing else ""
    biped = model_of("biped")
    roads = ("refined", "certified, in plane", "tightened, in plane", "tightened, free")
    pictures(biped, "enclosing", [(biped, ROADS[road]) for road in roads], "260x360")
    return {"roads": markdown(["model", *ROADS], ratios) + note,
            "angles": markdown(["model", *(f"{angle} degrees" for angle in ANGLES)], angles) + note}
