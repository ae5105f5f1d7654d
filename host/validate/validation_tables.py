#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/validation.md out of reports of `cagewright validate`: validation_tables.py REPORT.json..."""
import json
import pathlib
import sys


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def figure(value):
    return f"{value:.3g}"


def worst(cage, words):
    return max(check["worst"] for check in cage["checks"] if words in check["claim"])


def gap(tighter):
    return [f"{tighter['volume_ratio']:.3f}", f"{tighter['gap_percent']:.2f} %" + ("" if tighter["settled"] else " *")]


def main(paths):
    cages = [(pathlib.Path(path).stem, json.loads(pathlib.Path(path).read_text())["cages"][0]) for path in paths]
    table(["model", "(1) at the linear solution", "sections as turned", "best found", "linear above best",
           "sections above best", "starts that reach it"],
          [[name, f"{e['linear']:.4f}", f"{e['sections']:.4f}", f"{e['best']:.4f}",
            f"{e['linear_percent_above_best']:.3f} %", f"{max(0, e['sections_percent_above_best']):.3f} %",
            f"{e['starts_that_reach_best']} of {e['starts']}"]
           for name, cage in cages for e in [cage["equation_1"]]])
    table(["model", "iterations", "vertices compared", "(8), worst, over the diagonal", "(6), (7), worst",
           "checks that hold"],
          [[name, str(cage["iterations"]),
            str(next(c["comparisons"] for c in cage["checks"] if "Ceres finds the least" in c["claim"])),
            figure(worst(cage, "Ceres finds the least")),
            figure(max(worst(cage, "signed distances"), worst(cage, "anchors"))),
            f"{sum(c['holds'] for c in cage['checks'])} of {len(cage['checks'])}"] for name, cage in cages])
    table(["model", "cage triangles", "volume ratio", "in shape: ratio", "gap", "free: ratio", "gap"],
          [[name, str(cage["cage_triangles"]), f"{cage['volume_ratio']:.3f}"] +
           gap(cage["optimality"]["shaped"]) + gap(cage["optimality"]["free"])
           for name, cage in cages if cage["optimality"]])
    print("`*`: ended by the clock.")


main(sys.argv[1:])
