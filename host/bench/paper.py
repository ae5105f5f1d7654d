#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""paper.py [FIGURE...]: makes the numbers, plots and pictures of docs/paper-figures.md and of the tables in
docs/algorithms/enclosing.md again. Without a figure: all. Pictures of models that are not ours go to build/paper."""
import sys

import figures
import models
import roads
from program import ProgramError
from table import write_blocks

PAGE = models.ROOT / "docs/paper-figures.md"
FIGURES = {"5": figures.alignment, "10": figures.tightness, "11": figures.convergence, "12": figures.kinds_of_cuts,
           "15": figures.bumps, "17": figures.high_genus, "18": figures.touching_legs}


def make(name):
    print(f"figure {name} ..." if name in FIGURES else f"{name} ...", flush=True)
    if name == "enclosing":
        blocks = roads.tables()
        write_blocks(models.ROOT / "docs/algorithms/enclosing.md", blocks)
        print("\n".join(blocks.values()))
    else:
        text = FIGURES[name]()
        write_blocks(PAGE, {f"figure {name}": text})
        print(text)


def main(names):
    known = [*FIGURES, "enclosing"]
    for name in names:
        if name not in known:
            print(f"paper: there is no figure '{name}'; there are {', '.join(known)}", file=sys.stderr)
            return 2
    figures.OUT.mkdir(parents=True, exist_ok=True)
    left_out = []
    for name in names or known:
        try:
            make(name)
        except figures.Missing as missing:
            left_out.append(f"{name}: {missing}")
    for line in left_out:
        print(f"left as it was: {line}", file=sys.stderr)
    return 3 if left_out else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (ProgramError, OSError, ValueError) as error:
        sys.exit(f"paper: {error}")
