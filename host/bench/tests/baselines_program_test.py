# SPDX-License-Identifier: BSD-3-Clause
"""baselines_program_test.py BASELINES CAGEWRIGHT: every way makes a cage of a small model that `cagewright check`
certifies, and wrong usage is answered. Says so and ends with 77 where the program is not built."""
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BASELINES, CAGEWRIGHT = map(Path, sys.argv[1:3])
MOST_TRIANGLES = 60


def write_dumbbell(file, around=12, along=16):
    """A body of revolution, thin in its middle, as an .off file."""
    rings = []
    for i in range(1, along):
        t = math.pi * i / along
        radius = math.sin(t) * (0.35 + 0.4 * math.cos(t) ** 2)
        rings.append([(radius * math.cos(2 * math.pi * k / around), radius * math.sin(2 * math.pi * k / around),
                       -1.5 * math.cos(t)) for k in range(around)])
    points = [point for ring in rings for point in ring] + [(0, 0, -1.5), (0, 0, 1.5)]
    bottom, top = len(points) - 2, len(points) - 1
    triangles = []
    for k in range(around):
        after = (k + 1) % around
        triangles += [(bottom, after, k), (top, (along - 2) * around + k, (along - 2) * around + after)]
        for ring in range(along - 2):
            a, b = ring * around + k, ring * around + after
            triangles += [(a, b, b + around), (a, b + around, a + around)]
    lines = ["OFF", f"{len(points)} {len(triangles)} 0", *(" ".join(map(repr, p)) for p in points),
             *(f"3 {a} {b} {c}" for a, b, c in triangles)]
    file.write_text("\n".join(lines) + "\n")


class BaselinesProgram(unittest.TestCase):
    def run_program(self, *words):
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)

    def test_every_way_encloses_within_the_number_of_triangles(self):
        with tempfile.TemporaryDirectory() as name:
            model, cage = Path(name) / "model.off", Path(name) / "cage.off"
            write_dumbbell(model)
            for method in ("wrap", "offset", "voxels"):
                done = self.run_program(BASELINES, method, model, MOST_TRIANGLES, cage)
                self.assertEqual(done.returncode, 0, done.stderr)
                found = json.loads(done.stdout)
                self.assertTrue(found["encloses"], f"{method}: {found}")
                self.assertLessEqual(found["triangles"], MOST_TRIANGLES)
                checked = self.run_program(CAGEWRIGHT, "check", model, cage, "--report", Path(name) / "report.json")
                self.assertEqual(checked.returncode, 0, checked.stdout)
                report = json.loads((Path(name) / "report.json").read_text())
                self.assertEqual(report["cage"]["triangles"], found["triangles"])
                self.assertAlmostEqual(report["tightness"]["volume_ratio"], found["volume_ratio"], places=6)

    def test_wrong_usage_and_files_are_answered_with_a_sentence(self):
        for words in ((), ("spheres", "m.off", "10", "c.off"), ("wrap", "m.off", "ten", "c.off")):
            done = self.run_program(BASELINES, *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("usage: cagewright_baselines wrap|offset|voxels", done.stderr)
        done = self.run_program(BASELINES, "wrap", "nowhere.off", "10", "c.off")
        self.assertEqual(done.returncode, 3)
        self.assertIn("nowhere.off: is not a mesh of a surface that CGAL can read", done.stderr)


if __name__ == "__main__":
    if not BASELINES.is_file():
        print("skipped: cagewright_baselines is not built; ./dev baselines builds it")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
