# SPDX-License-Identifier: BSD-3-Clause
"""The models of the figures, and where their files are."""
import os
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OWN = ("biped", "quadruped", "octopus", "genus3", "blob")
REAL = ("armadillo", "elk", "man", "bunny00", "elephant")
BY_HAND = {"armadilloman": "armadillo/bounding_mesh.obj", "horse": "horse/bounding_meshb.obj"}


@dataclass(frozen=True)
class Model:
    name: str
    file: Path
    slides: Path
    by_hand: Path | None = None  # a cage that somebody made by hand

    @property
    def is_own(self):
        return self.name in OWN or self.name == "legs"


def folders():
    """Where models are looked for: made by ./dev, fetched, and those with cages by hand."""
    found = [ROOT / "build/own-models", Path(os.environ.get("CAGEWRIGHT_REAL_MODELS") or ROOT / "build/models")]
    if os.environ.get("CAGEWRIGHT_MVC_CAGES"):
        found += [Path(os.environ["CAGEWRIGHT_MVC_CAGES"]) / name for name in ("armadillo", "horse")]
    return found


def find(name, where=None):
    """The model of that name, or None where its file is in none of the folders."""
    for folder in folders() if where is None else where:
        for ending in (".off", ".obj"):
            file = folder / (name + ending)
            if file.is_file():
                cage = BY_HAND.get(name)
                cage = folder.parent / cage if cage else None
                slides = ROOT / "testdata/slides" / f"{name}.slides.json"
                return Model(name, file, slides, cage if cage and cage.is_file() else None)
    return None


def find_all(names):
    """(models that are there, names of those that are not)"""
    found = {name: find(name) for name in names}
    return [model for model in found.values() if model], [name for name, model in found.items() if not model]
