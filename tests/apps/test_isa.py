"""--isa and GLINT_ISA: which vector instructions trace, and that the picture does not depend on it."""

import json
import re
import unittest

from glint_process import GlintTest


class InstructionSet(GlintTest):
    def available(self):
        """Those that --version names, slowest first."""
        out = self.glint("--version").stdout
        return re.search(r"^instruction sets +(.*) \(in use", out, re.MULTILINE)[1].split(", ")

    def used(self, *arguments, env=None):
        """The one that a render says it was traced with."""
        out = self.glint("render", "room.sdl", "--stats", *arguments, env=env).stdout
        return re.search(r"^isa +(\w+)$", out, re.MULTILINE)[1]

    def test_every_available_one_can_be_asked_for_and_makes_the_same_picture(self):
        names = self.available()
        self.assertIn("scalar", names)
        for name in names:
            self.assertEqual(self.used("--isa", name), name)
        pictures = {self.glint("render", "room.sdl", "--hash", "--isa", name).stdout for name in names}
        self.assertEqual(len(pictures), 1)

    def test_without_asking_it_is_the_best_one(self):
        self.assertEqual(self.used(), self.available()[-1])

    def test_the_environment_asks_too_and_the_flag_wins(self):
        self.assertEqual(self.used(env={"GLINT_ISA": "scalar"}), "scalar")
        best = self.available()[-1]
        self.assertEqual(self.used("--isa", best, env={"GLINT_ISA": "scalar"}), best)
        self.assertEqual(self.used("--isa", "scalar", env={"GLINT_ISA": "sse9"}), "scalar")

    def test_the_table_names_the_one_it_was_measured_with(self):
        self.glint("bench", "table", "--scene", "room.sdl", "--sizes", 16, "--depths", 0, "--seconds", 0,
                   "--surface", "none", "--isa", "scalar", "--json", "table.json")
        (row,) = json.loads((self.folder / "table.json").read_text())["rows"]
        self.assertEqual(row["isa"], "scalar")

    def test_an_unknown_one_is_refused_with_those_there_are(self):
        for command in (["render", "room.sdl", "--hash"], ["bench", "table"], ["bench", "frame"], ["bench", "kernels"]):
            for name in ("sse9", "", "AVX2", "wasm"):
                with self.subTest(command=command, name=name):
                    self.refused(*command, "--isa", name, expect=2, saying=["--isa", f"'{name}'", "scalar"])

    def test_an_unknown_one_in_the_environment_is_refused_where_it_matters(self):
        done = self.glint("render", "room.sdl", "--hash", expect=2, env={"GLINT_ISA": "sse9"})
        self.assertIn("'sse9'", done.stderr)
        self.glint("info", "room.sdl", env={"GLINT_ISA": "sse9"})
        self.glint("--version", env={"GLINT_ISA": "sse9"})


if __name__ == "__main__":
    unittest.main()
