"""glint info, --version and --help say what there is."""

import json
import unittest

from glint_process import GlintTest, needs_images


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


class MaterialsFromMtl(GlintTest):
    def setUp(self):
        super().setUp()
        floor = (self.folder / "floor.obj").read_text()
        start = "mtllib floor.mtl\nusemtl wood\nvt 0 0\nvn 0 0 0\n"
        self.write("floor.obj", start + floor.replace(" 2 3", "/1/1 2/1 3/1"))
        self.write("room.sdl", (self.folder / "room.sdl").read_text() + "object floor.obj mtl\n")

    @needs_images
    def test_a_texture_is_read_from_its_image_file(self):
        self.write("floor.mtl", "newmtl wood\nKd 0.5 0.25 0.125\nmap_Kd wood.png\n")
        self.assertIn("there is no file 'wood.png'", self.glint("info", "room.sdl", expect=3).stderr)
        (self.folder / "wood.png").write_text("no picture")
        self.assertIn("wood.png': ", self.glint("info", "room.sdl", expect=3).stderr)
        (self.folder / "wood.png").unlink()
        plain = "\n".join(line for line in (self.folder / "room.sdl").read_text().splitlines() if "mtl" not in line)
        self.glint("render", self.write("plain.sdl", plain), "-o", "wood.png")
        info = json.loads(self.glint("info", "room.sdl", "--json").stdout)
        self.assertEqual([item["name"] for item in info["objects"]][-1], "floor.obj:wood")
        self.assertIn("zero", info["warnings"][0])

    def test_flat_leaves_normals_aside(self):
        self.write("floor.mtl", "newmtl wood\n")
        self.assertEqual(json.loads(self.glint("info", "room.sdl", "--flat", "--json").stdout)["warnings"], [])

ALL_KINDS = """\
dialect glint
eye 0 0 3
size 48 32
samples 4 jittered
seed 7
tonemapping 0.5
npaths 9
fresnel on
shadows_through_glass on
nshadowrays 5
light lamp.obj 1 1 1 1
light lamp.obj 1 1 1 1 0 0.75 -3
light_quadric 1 1 1 0 0 0 0 -2 0 3 1 1 1 0.5
light_point 1 2 3 1 0.5 1 0.7 falloff on
light_directional 0 -1 0.5 1 1 1 1
light_spot 0 3 0 0 -1 0 10 22.5 1 1 1 1
object floor.obj 0 0 0 0.9 0.5 0.2 0.3 0.7 0 0 0.5 0 1
objectquadric 1 1 1 0 0 0 -1 0 22 484 1 1 1 0.1 0.2 0.3 5 0 1 1.33
objectquadric 1 0 1 0 0 0 -3 0 0 5 1 1 1 0.1 0.2 0.3 5 0 0 1
objectquadric 3 3 -1 0 0 0 0 0 0 0 1 1 1 0.1 0.2 0.3 5 0 0 1
"""


class InfoOnAllKinds(GlintTest):
    def setUp(self):
        super().setUp()
        self.write("all.sdl", ALL_KINDS)

    def test_the_text_tells_shapes_lights_and_samples(self):
        out = self.glint("info", "all.sdl").stdout
        for line in (
            r"dialect +glint \('dialect' on line 1\)",
            r"line 6 +'tonemapping' +is path2005 or cg-path-tracer or raycife",
            r"samples +4 a pixel, jittered",
            r"seed +7",
            r"tone curve c / \(c \+ 0\.5\)",
            r"paths +9 a pixel, for path tracers only",
            r"fresnel +on",
            r"shadows +go through glass",
            r"quadrics +4",
            r"quadric +sphere .* kt 1 ior 1\.33  centre 1 0 -22  radius 1",
            r"quadric +cylinder .*  centre 3 0 0  axis 0 1 0  radius 2",
            r"quadric +cone .*  centre 0 0 0  axis 0 0 1  half angle 30",
            r"lamp\.obj +2 triangles .*  5 shadow rays at random",
            r"lamp\.obj +2 triangles .*  1 shadow ray to 0 0\.75 -3",
            r"quadric +sphere .*intensity 0\.5  centre 0 2 0  radius 1  1 shadow ray to 0 2 0",
            r"point +not seen  color 1 0\.5 1  intensity 0\.7  at 1 2 3  falloff on",
            r"directional +not seen .*  along 0 -1 0\.5",
            r"spot +not seen .*  at 0 3 0  along 0 -1 0  angles 10 to 22\.5",
        ):
            self.assertRegex(out, rf"(?m)^ *{line}$")

    def test_what_is_as_in_most_scenes_is_not_told(self):
        out = self.glint("info", "room.sdl").stdout
        for word in ("samples", "seed", "tone curve", "paths", "fresnel", "glass", "added"):
            self.assertNotIn(word, out)

    def test_the_json_has_it_all(self):
        info = json.loads(self.glint("info", "all.sdl", "--json").stdout)
        self.assertEqual(info["dialect"]["evidence"][0]["line"], 5)
        self.assertEqual(info["dialect"]["evidence"][0]["what"], "'seed'")
        self.assertIn("path2005", info["dialect"]["evidence"][0]["dialects"])
        self.assertEqual((info["samples_per_pixel"], info["pattern"], info["seed"]), (4, "jittered", 7))
        self.assertEqual((info["tone_scale"], info["paths_per_pixel"]), (0.5, 9))
        self.assertTrue(info["fresnel"] and info["shadows_through_glass"])
        self.assertEqual(info["quadrics"], 4)
        floor, sphere, cylinder, cone = (item["quadric"] for item in info["objects"])
        self.assertIsNone(floor)
        self.assertEqual(sphere["coefficients"], [1, 1, 1, 0, 0, 0, -1, 0, 22, 484])
        self.assertEqual((sphere["name"], sphere["centre"], sphere["radii"]), ("sphere", [1, 0, -22], [1]))
        self.assertIsNone(sphere["axis"])
        self.assertEqual((cylinder["name"], cylinder["axis"], cylinder["radii"]), ("cylinder", [0, 1, 0], [2]))
        self.assertAlmostEqual(cone["half_angle_degrees"], 30, places=4)
        lamp, aimed, ball, point, sun, spot = info["lights"]
        self.assertEqual([light["kind"] for light in info["lights"]], ["surface"] * 3 + ["point", "directional", "spot"])
        self.assertEqual((lamp["shadow_rays"], lamp["shadow_grid"], aimed["shadow_rays"]), (5, None, 1))
        self.assertEqual((aimed["position"], ball["quadric"]["name"]), ([0, 0.75, -3], "sphere"))
        self.assertEqual((point["position"], point["falloff"], point["direction"]), ([1, 2, 3], True, None))
        self.assertEqual((sun["position"], sun["direction"]), (None, [0, -1, 0.5]))
        self.assertAlmostEqual(spot["outer_degrees"], 22.5, places=4)
        self.assertEqual(spot["falloff"], False)

    def test_a_grid_of_shadow_rays_is_told(self):
        self.write("grid.sdl", ALL_KINDS.replace("nshadowrays 5", "lightresolution 3 4"))
        self.assertIn("  3x4 shadow rays in a grid\n", self.glint("info", "grid.sdl").stdout)
        lamp = json.loads(self.glint("info", "grid.sdl", "--json").stdout)["lights"][0]
        self.assertEqual((lamp["shadow_rays"], lamp["shadow_grid"]), (12, [3, 4]))

    def test_every_kind_of_line_that_speaks_for_dialects_is_told(self):
        scene = "eye 0 0 3\nnpaths 4\nlight lamp.obj 1 1 1 1\nobject floor.obj 1 1 1 0 1 0 0 5\n"
        self.write("path.sdl", scene + "object floor.obj 1 1 1 0 1 0 0 5 1\nobject floor.obj 1 1 1 0 1 0 0 5\n")
        evidence = json.loads(self.glint("info", "path.sdl", "--json").stdout)["dialect"]["evidence"]
        self.assertEqual(
            [(one["line"], one["what"], one["dialects"]) for one in evidence],
            [
                (2, "'npaths'", ["path2005", "cg-path-tracer", "raycife"]),
                (4, "'object' with 8 numbers", ["path2005", "raycife"]),
                (5, "'object' with 9 numbers", ["mobile2013", "path2005", "raycife"]),
            ],
        )


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
