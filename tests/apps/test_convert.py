"""glint convert: any scene file, rewritten in Glint's own dialect."""

import re
import unittest

from glint_process import GlintTest

CONVERTED = """\
dialect glint

# Camera
eye   0 0 3
ortho -1 -1 1 1

# Picture
size       48 32
background 0.1 0.2 0.3
ambient    1
max_depth  2

# Lights
#light file.obj r g b I
light  lamp.obj 1 1 1 1

# Objects
#object file.obj    dx dy dz r   g   b   ka  kd  ks  n  kr  kt ior
object  floor.obj   0  0  0  0.9 0.5 0.2 0.3 0.7 0   0  0.5 0  1
object  ceiling.obj 0  0  0  0.2 0.5 0.9 0.3 0.4 0.3 10 0   0  1
"""


class Convert(GlintTest):
    def hashes(self, *arguments):
        return self.glint("render", *arguments, "--hash").stdout

    def test_without_output_the_new_file_is_printed_and_names_meshes_from_the_old_ones_folder(self):
        before = self.names()
        done = self.glint("convert", "room.sdl")
        self.assertEqual((done.stdout, done.stderr), (CONVERTED, ""))
        self.assertEqual(self.names(), before)
        self.assertEqual(self.glint("convert", self.folder / "room.sdl").stdout, CONVERTED)

    def test_the_new_file_makes_the_same_picture_and_converts_into_itself(self):
        done = self.glint("convert", "room.sdl", "-o", "new.sdl")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertEqual((self.folder / "new.sdl").read_text(), CONVERTED)
        self.assertEqual(self.hashes("new.sdl"), self.hashes("room.sdl"))
        self.assertEqual(self.glint("convert", "new.sdl").stdout, CONVERTED)

    def test_other_dialects_are_converted_too(self):
        scene = "eye 0 0 3\nsize 30 20\nambient 1\nlight lamp.obj 1 1 1 1\nobject floor.obj 1 0.5 0.2 0.3 0.7 0 0 5\n"
        self.write("path.sdl", scene + "npaths 1\nseed 7\n")
        self.glint("convert", "path.sdl", "-o", "new.sdl")
        self.assertIn("reflection_adds on\n", (self.folder / "new.sdl").read_text())
        self.assertEqual(self.hashes("new.sdl"), self.hashes("path.sdl"))

    def test_the_dialect_may_be_named(self):
        scene = "eye 0 0 3\nlight lamp.obj 1 1 1 1\nobject floor.obj 1 0.5 0.2 0.3 0.7 0 0.5 0.25 0.75\n"
        self.write("either.sdl", scene)
        self.refused("convert", "either.sdl", expect=3, saying=["mobile2013", "path2005"])
        as_mobile = self.glint("convert", "either.sdl", "--dialect", "mobile2013").stdout
        as_path = self.glint("convert", "either.sdl", "--dialect", "path2005").stdout
        self.assertIn(" 0.5 0.25 0.75 1\n", as_mobile)
        self.assertIn(" 0.25 0  0.5 0.75\n", as_path)

    def test_meshes_are_named_from_the_new_folder_and_the_root_that_needs_is_told(self):
        (self.folder / "new").mkdir()
        done = self.glint("convert", "room.sdl", "-o", "new/room.sdl")
        self.assertIn("object  ../floor.obj ", (self.folder / "new/room.sdl").read_text())
        self.assertEqual(done.stdout, "")
        root = re.fullmatch(r"glint: note: .* needs --scene-root (.*)\n", done.stderr)[1]
        self.assertEqual(root, str(self.folder.resolve()))
        self.assertEqual(self.hashes("new/room.sdl", "--scene-root", root), self.hashes("room.sdl"))

    def test_warnings_are_told(self):
        self.write("room.sdl", (self.folder / "room.sdl").read_text().replace("max_depth 2", "dialect mobile2013\nnpaths 9"))
        self.assertIn("npaths", self.glint("convert", "room.sdl").stderr)

    def test_the_old_file_and_its_meshes_are_never_overwritten(self):
        (self.folder / "link.sdl").symlink_to("room.sdl")
        before = {name: (self.folder / name).read_bytes() for name in self.names()}
        for output in ("room.sdl", "./room.sdl", self.folder / "room.sdl", "link.sdl", "floor.obj"):
            with self.subTest(output):
                self.refused("convert", "room.sdl", "-o", output, expect=2, saying=[str(output), "made from"])
        self.assertEqual({name: (self.folder / name).read_bytes() for name in self.names()}, before)

    def test_an_output_that_cannot_be_written_fails(self):
        self.refused("convert", "room.sdl", "-o", "missing/a.sdl", expect=1, saying=["missing/a.sdl", "no folder"])
        self.write("abs.sdl", (self.folder / "room.sdl").read_text())
        self.refused("convert", "abs.sdl", "-o", "/dev/full", expect=1, saying=["/dev/full", "No space left on device"])

    def test_bad_input_is_refused_and_writes_nothing(self):
        self.write("bad.sdl", "eye 0 0 3\nlihgt lamp.obj 1 1 1 1\n")
        before = self.names()
        self.refused("convert", "bad.sdl", "-o", "new.sdl", expect=3, saying=["bad.sdl:2:1: error:", "did you mean"])
        self.refused("convert", "missing.sdl", "-o", "new.sdl", expect=3, saying=["missing.sdl"])
        self.assertEqual(self.names(), before)

    def test_a_mesh_that_no_scene_file_can_name_is_bad_input(self):
        inner = self.folder / "with blank"
        inner.mkdir()
        for name in ("room.sdl", "floor.obj", "ceiling.obj", "lamp.obj"):
            (self.folder / name).rename(inner / name)
        self.refused("convert", inner / "room.sdl", "-o", "new.sdl", expect=3, saying=["with blank/floor.obj", "a blank"])
        self.assertFalse((self.folder / "new.sdl").exists())
        self.assertEqual(self.glint("convert", inner / "room.sdl", "-o", inner / "new.sdl").stderr, "")


if __name__ == "__main__":
    unittest.main()
