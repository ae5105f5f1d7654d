# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the scripts that need no program: tables, blocks, plots, pictures, turns of sections, the verdict."""
import math
import struct
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import baselines  # noqa: E402
import models  # noqa: E402
import plot  # noqa: E402
import png  # noqa: E402
import program  # noqa: E402
import sections  # noqa: E402
import table  # noqa: E402


class Tables(unittest.TestCase):
    def test_numbers_have_three_decimals_and_what_is_unknown_is_a_dash(self):
        self.assertEqual(table.markdown(["a", "b", "c"], [[1.23456, None, True]]),
                         "| a | b | c |\n|---|---|---|\n| 1.235 | - | yes |\n")

    def test_a_row_that_is_too_short_is_refused(self):
        with self.assertRaisesRegex(ValueError, "1 cells, the head 2"):
            table.markdown(["a", "b"], [["x"]])

    def test_a_block_is_replaced_and_nothing_else(self):
        text = "top\n<!-- t -->\nold\n<!-- end of t -->\nbottom\n"
        self.assertEqual(table.replace_block(text, "t", "new\n"),
                         "top\n<!-- t -->\nnew\n<!-- end of t -->\nbottom\n")
        self.assertEqual(table.replace_block(table.replace_block(text, "t", "a"), "t", "old"), text)

    def test_a_document_without_the_block_is_refused(self):
        for text in ("", "<!-- end of t -->\n<!-- t -->\n", "<!-- t -->\n"):
            with self.assertRaisesRegex(ValueError, "no block 't'"):
                table.replace_block(text, "t", "new")

    def test_every_block_of_the_scripts_is_in_its_document(self):
        page = (models.ROOT / "docs/paper-figures.md").read_text(encoding="utf-8")
        for name in ("5", "10", "11", "12", "15", "17", "18"):
            table.replace_block(page, f"figure {name}", "")
        enclosing = (models.ROOT / "docs/algorithms/enclosing.md").read_text(encoding="utf-8")
        table.replace_block(table.replace_block(enclosing, "roads", ""), "angles", "")
        text = (models.ROOT / "docs/baselines.md").read_text(encoding="utf-8")
        table.replace_block(table.replace_block(text, "table", ""), "verdict", "")


class Plots(unittest.TestCase):
    def test_ticks_are_round_and_within_the_axis(self):
        self.assertEqual(plot.ticks(0, 10), [0, 2, 4, 6, 8, 10])
        for low, high in ((0, 0.0137), (92.3, 100), (-3, 7)):
            found = plot.ticks(low, high)
            self.assertTrue(2 <= len(found) <= 6 and low <= found[0] and found[-1] <= high, found)

    def test_an_axis_without_length_is_refused(self):
        with self.assertRaises(ValueError):
            plot.ticks(1, 1)

    def test_a_larger_value_is_higher_up_and_names_are_escaped(self):
        svg = plot.curves_svg("a < b", "x", "y", {"c & d": [(0, 1.0), (1, 3.0)]}, level=(2.0, "two"))
        texts = [node.text for node in xml.fromstring(svg).iter() if node.tag.endswith("text")]
        self.assertTrue({"a < b", "c & d", "two"} <= set(texts))
        paths = [node.get("d") for node in xml.fromstring(svg).iter() if node.tag.endswith("path")]
        curve = next(path for path in paths if "L" in path)
        (x0, y0), (x1, y1) = (map(float, point.split()) for point in curve[1:].split("L"))
        self.assertTrue(x0 < x1 and y0 > y1, curve)

    def test_no_points_are_refused(self):
        with self.assertRaisesRegex(ValueError, "'empty' has no points"):
            plot.curves_svg("empty", "x", "y", {"a": []})


def filtered_png(file, kind, rows, step):
    """A picture whose every row has that filter, made by the definition in the PNG specification."""
    def paeth(a, b, c):
        p = a + b - c
        return min((a, b, c), key=lambda value: abs(p - value))

    packed, above = bytearray(), bytes(len(rows[0]))
    for row in rows:
        packed.append(kind)
        for i, value in enumerate(row):
            left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
            guess = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind]
            packed.append((value - guess) & 255)
        above = row
    parts = [png.SIGNATURE]
    header = struct.pack(">IIBBBBB", len(rows[0]) // step, len(rows), 8, 2 if step == 3 else 6, 0, 0, 0)
    for name, content in ((b"IHDR", header), (b"IDAT", zlib.compress(bytes(packed))), (b"IEND", b"")):
        parts += [struct.pack(">I", len(content)), name, content, struct.pack(">I", zlib.crc32(name + content))]
    file.write_bytes(b"".join(parts))


class Pictures(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def test_every_filter_is_undone(self):
        for step in (3, 4):
            rows = [bytes((17 * x * x + 31 * y + x * y) % 256 for x in range(5 * step)) for y in range(4)]
            rgb = [b"".join(row[i:i + 3] for i in range(0, len(row), step)) for row in rows]
            for kind in range(5):
                filtered_png(self.folder / "a.png", kind, rows, step)
                self.assertEqual(png.read(self.folder / "a.png"), (5, rgb), f"filter {kind}, {step} bytes")

    def test_side_by_side_keeps_the_order_and_no_colour_moves_by_more_than_seven(self):
        png.write(self.folder / "a.png", 1, [b"\x08\x00\xff", b"\x18\x29\x08"])
        png.write(self.folder / "b.png", 2, [b"\x10" * 6, b"\x39" * 6])
        png.side_by_side([self.folder / "a.png", self.folder / "b.png"], self.folder / "c.png")
        self.assertEqual(png.read(self.folder / "c.png"),
                         (3, [b"\x08\x00\xff" + b"\x10" * 6, b"\x18\x29\x08" + b"\x39" * 6]))

        self.assertLess(max(abs(value - coarse) for value, coarse in enumerate(png.COARSE)), 8)

    def test_pictures_of_different_heights_and_other_files_are_refused(self):
        png.write(self.folder / "a.png", 1, [b"\x01\x02\x03"])
        png.write(self.folder / "b.png", 1, [b"\x01\x02\x03"] * 2)
        with self.assertRaisesRegex(ValueError, "not of one height"):
            png.side_by_side([self.folder / "a.png", self.folder / "b.png"], self.folder / "c.png")
        (self.folder / "d.png").write_text("text")
        with self.assertRaisesRegex(ValueError, "is no PNG picture"):
            png.read(self.folder / "d.png")


class Turns(unittest.TestCase):
    def turned(self, degrees):
        return (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), 0.0)

    def test_twist_of_parallel_sections_is_the_angle_to_the_nearest_axis_whichever_way_they_face(self):
        for degrees, expected in ((0, 0), (30, 30), (60, 30), (90, 0), (135, 45), (-100, 10)):
            for normal in ((0, 0, 1), (0, 0, -1)):
                self.assertAlmostEqual(sections.twist((0, 0, 1), (1, 0, 0), normal, self.turned(degrees)), expected)

    def test_a_section_carried_round_a_bend_has_no_twist(self):
        bend = math.radians(40)
        normal, axis = (math.sin(bend), 0, math.cos(bend)), (math.cos(bend), 0, -math.sin(bend))
        self.assertAlmostEqual(sections.twist((0, 0, 1), (1, 0, 0), normal, axis), 0)
        self.assertAlmostEqual(sections.twist((0, 0, 1), (1, 0, 0), normal, (0, 1, 0)), 0)

    def test_a_slanting_section_carried_round_a_bend_has_no_twist(self):
        c, s = math.cos(math.radians(40)), math.sin(math.radians(40))
        for degrees in (25, 70):
            x, y, _ = self.turned(degrees)
            self.assertAlmostEqual(sections.twist((0, 0, 1), (x, y, 0), (0, -s, c), (x, c * y, s * y)), 0)

    def test_twist_at_a_right_angle_is_against_the_other_normal(self):
        self.assertAlmostEqual(sections.twist((0, 0, 1), (1, 0, 0), (1, 0, 0), (0, 0, 1)), 0)
        self.assertAlmostEqual(sections.twist((0, 0, 1), self.turned(20), (1, 0, 0), (0, 0, 1)), 20)

    def test_sections_are_neighbours_within_a_part_and_not_beyond_the_next_section(self):
        # Three bars of two vertices each in a row: 0 and 1 bound one part, 1 and 2 the next one.
        triangles = [(0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4)]
        self.assertEqual(sections.neighbours(triangles, [0, 0, 1, 1, 2, 2]), {(0, 1), (1, 2)})


class Baselines(unittest.TestCase):
    def row(self, ratio, encloses=True):
        return {"model": "m", "volume_ratio": ratio, "mean_gap": ratio, "encloses": encloses}

    def test_ours_is_first_only_before_all_others_that_enclose(self):
        ours = [self.row(1.5), self.row(1.4)]
        self.assertTrue(baselines.is_first([*ours, self.row(1.2, encloses=False), self.row(1.6)], "volume_ratio"))
        self.assertFalse(baselines.is_first([*ours, self.row(1.45)], "volume_ratio"))
        self.assertIsNone(baselines.is_first([self.row(1.5, encloses=False), self.row(1.4), self.row(2.0)], "mean_gap"))

    def test_the_verdict_names_the_models_where_ours_is_not_first(self):
        good, bad = [self.row(1.5), self.row(1.4), self.row(2.0)], [self.row(1.5), self.row(1.4), self.row(1.2)]
        bad[0]["model"] = "worse"
        said = baselines.verdict([good, bad]).splitlines()
        self.assertEqual(said[0], "- ours: smallest volume ratio of all that enclose on 1 of 2 models; not on worse.")
        bad[1]["volume_ratio"] = 1.1  # the free one is first on both now
        self.assertIn("- ours, free: smallest volume ratio of all that enclose on 2 of 2 models.",
                      baselines.verdict([good, bad]).splitlines())

    def test_parameters_are_named_with_a_dot(self):
        self.assertEqual(program.settings(enclose_in_plane="false", refine_push="1"),
                         ["--set", "enclose.in_plane=false", "--set", "refine.push=1"])

    def test_a_program_that_fails_says_so_with_its_last_line(self):
        with self.assertRaisesRegex(program.ProgramError, "ended with 3: last"):
            program.run([sys.executable, "-c", "import sys; sys.exit(print('first\\nlast', file=sys.stderr) or 3)"])

    def test_a_model_is_found_in_the_folders_or_not_at_all(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIsNone(models.find("blob", [Path(folder)]))
            (Path(folder) / "blob.off").write_text("OFF\n")
            self.assertEqual(models.find("blob", [Path(folder)]).file, Path(folder) / "blob.off")


if __name__ == "__main__":
    unittest.main()
