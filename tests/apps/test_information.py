"""glint info, --version and --help say what there is."""

import json
import unittest

from glint_process import GlintTest


class Info(GlintTest):
    def test_the_text_names_objects_lights_dialect_and_tree(self):
        out = self.glint("info", "room.sdl").stdout
        for words in ("mobile2013", "max_depth", "48x32", "floor", "ceiling", "lamp", "kdtree, 6 triangles", "SAH cost"):
            self.assertIn(words, out)

    def test_the_json_holds_what_the_scene_says(self):
        info = json.loads(self.glint("info", "room.sdl", "--json").stdout)
        self.assertEqual(info["dialect"]["name"], "mobile2013")
        self.assertTrue(info["dialect"]["reason"])
        self.assertEqual((info["width"], info["height"], info["depth"]), (48, 32, 2))
        self.assertEqual(info["camera"]["eye"], [0, 0, 3])
        self.assertEqual(info["triangles"], 6)
        self.assertEqual([item["triangles"] for item in info["objects"]], [2, 2])
        self.assertEqual(info["objects"][1]["ke"], 10)
        self.assertEqual(len(info["lights"]), 1)
        self.assertEqual(len(info["mesh_files"]), 3)
        self.assertIsNone(info["output"])
        self.assertEqual(info["warnings"], [])
        tree = info["tree"]
        self.assertEqual(tree["kind"], "kdtree")
        self.assertEqual(tree["triangles"], 6)
        self.assertGreaterEqual(tree["references"], 6)
        self.assertGreater(tree["bytes"], 0)

    def test_triangles_without_area_are_counted_and_warned_about(self):
        self.write("floor.obj", (self.folder / "floor.obj").read_text() + "f 1 1 2\nf 2 2 2\n")
        (warning,) = json.loads(self.glint("info", "room.sdl", "--json").stdout)["warnings"]
        self.assertIn("floor.obj", warning)
        self.assertIn("2 ", warning)
        self.assertIn(warning, self.glint("info", "room.sdl").stdout)
        self.assertIn(warning, self.glint("render", "room.sdl", "--hash").stderr)

    def test_a_file_name_that_is_not_utf8_does_not_break_the_json(self):
        name = b"r\xffm.sdl".decode(errors="surrogateescape")
        (self.folder / "room.sdl").rename(self.folder / name)
        self.assertEqual(json.loads(self.glint("info", name, "--json").stdout)["triangles"], 6)


class Version(GlintTest):
    def test_the_version_names_compiler_instruction_sets_and_libraries(self):
        out = self.glint("--version").stdout
        self.assertRegex(out, r"^glint \d+\.\d+\.\d+\n")
        for words in ("compiler", "instruction sets", "in use", "GLM", "OpenImageIO"):
            self.assertIn(words, out)
        self.assertRegex(out, r"Highway \d+\.\d+\.\d+")


class Help(GlintTest):
    def test_every_command_helps_with_examples(self):
        for command in ([], ["render"], ["info"], ["convert"], ["bench", "table"], ["bench", "frame"], ["bench", "kernels"]):
            with self.subTest(command):
                done = self.glint(*command, "--help")
                self.assertIn("Examples:", done.stdout)
                self.assertEqual(done.stderr, "")

    def test_the_help_of_render_names_its_flags(self):
        out = self.glint("render", "--help").stdout
        for flag in ("-o", "--size", "--depth", "--threads", "--accel", "--isa", "--hash", "--stats", "--max-pixels", "--spp", "--pattern", "--transfer"):
            self.assertIn(flag, out)


if __name__ == "__main__":
    unittest.main()
