"""glint bench table: a row for each size and depth, in every form."""

import csv
import json
import unittest

from glint_process import GlintTest

SPREADS = ("render_ms", "upload_ms", "gl_ms", "time_to_image_ms")
ROW_KEYS = ["width", "height", "depth", "threads", "isa", "surface", "frames", *SPREADS]
ROW_KEYS += ["fps", "loop_fps", "rays", "mrays_per_s"]


class BenchTable(GlintTest):
    def table(self, *arguments, env=None):
        """Measures two sizes and depths; what was printed, and the JSON."""
        done = self.glint(
            *("bench", "table", "--scene", "room.sdl", "--sizes", "16,33", "--depths", "0,2"),
            *("--seconds", 0, "--threads", 2, "--json", "table.json", *arguments),
            env=env,
        )
        return done, json.loads((self.folder / "table.json").read_text())

    def check_rows(self, table):
        self.assertEqual([(r["width"], r["height"], r["depth"]) for r in table["rows"]],
                         [(16, 16, 0), (16, 16, 2), (33, 33, 0), (33, 33, 2)])
        for row in table["rows"]:
            self.assertEqual(list(row), ROW_KEYS)
            self.assertEqual(row["threads"], 2)
            self.assertGreaterEqual(row["frames"], 50)
            self.assertGreaterEqual(row["rays"], row["width"] * row["height"])
            for key in SPREADS:
                self.assertEqual(list(row[key]), ["median", "min", "p95"])
                self.assertLessEqual(row[key]["min"], row[key]["median"])
                self.assertLessEqual(row[key]["median"], row[key]["p95"])
            self.assertGreater(row["render_ms"]["min"], 0)
            self.assertAlmostEqual(row["fps"], 1000 / row["time_to_image_ms"]["median"], delta=1e-6 * row["fps"])
            self.assertGreater(row["loop_fps"], 0)
            self.assertAlmostEqual(row["mrays_per_s"], 1e-3 * row["rays"] / row["render_ms"]["median"], places=6)

    def test_without_a_surface_only_rendering_is_timed(self):
        done, table = self.table("--surface", "none")
        self.check_rows(table)
        self.assertEqual(list(table), ["machine", "scene", "rows"])
        self.assertEqual(table["scene"], "room.sdl")
        self.assertTrue(table["machine"]["cpu"])
        self.assertGreater(table["machine"]["processors"], 0)
        self.assertEqual({row["surface"] for row in table["rows"]}, {"none"})
        self.assertEqual({row["upload_ms"]["p95"] for row in table["rows"]}, {0})
        self.assertIn("Render, ms", done.stdout)
        self.assertNotIn("paper", done.stdout)

    def test_on_a_surface_every_step_is_timed(self):
        done, table = self.table()
        self.check_rows(table)
        if table["rows"][0]["surface"] == "none":
            self.assertIn("surface", done.stderr)
            self.skipTest("this machine has neither EGL nor OSMesa")
        for row in table["rows"]:
            self.assertGreater(row["upload_ms"]["min"], 0)
            self.assertGreater(row["gl_ms"]["min"], 0)
        self.assertTrue(table["machine"]["gl"])

    def test_without_egl_it_falls_back_and_says_so(self):
        # libglvnd finds no driver there.
        done, table = self.table(env={"__EGL_VENDOR_LIBRARY_DIRS": str(self.folder)})
        self.check_rows(table)
        self.assertIn(table["rows"][0]["surface"], ("osmesa", "none"))
        self.assertIn("EGL", done.stderr)

    def test_the_other_forms_have_a_line_for_each_row(self):
        self.table("--surface", "none", "--csv", "table.csv", "--md", "table.md")
        with open(self.folder / "table.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["width"], row["depth"]) for row in rows],
                         [("16", "0"), ("16", "2"), ("33", "0"), ("33", "2")])
        self.assertGreater(float(rows[0]["render_ms_median"]), 0)
        markdown = (self.folder / "table.md").read_text()
        self.assertIn("| Render, ms |", markdown)

    def test_the_papers_scene_is_measured_beside_the_paper(self):
        (self.folder / "room.sdl").rename(self.folder / "cornell.sdl")
        flags = ["--sizes", 128, "--depths", 1, "--seconds", 0, "--surface", "none"]
        done = self.glint("bench", "table", "--scene", "cornell.sdl", *flags)
        for words in ("paper", "41.86", "20.01", "ratio"):
            self.assertIn(words, done.stdout)


if __name__ == "__main__":
    unittest.main()
