"""What glint cannot do it says, and ends with the exit code for it: 1 failure, 2 usage, 3 bad input."""

import os
import shutil
import unittest
import unittest.mock

import glint_process
from glint_process import GlintTest, needs_images


class Usage(GlintTest):
    def test_the_command_line_must_make_sense(self):
        for arguments, word in (
            ([], "subcommand"),
            (["paint"], "Not understood: paint"),
            (["bench", "tabel"], "Not understood: tabel"),
            (["render"], "SCENE"),
            (["render", "room.sdl", "--colour"], "--colour"),
            (["render", "room.sdl", "--accel", "octree"], "octree"),
            (["render", "room.sdl", "--pattern", "random"], "centre|stratified|jittered"),
            (["render", "room.sdl", "--transfer", "gamma"], "linear|srgb"),
            (["convert"], "SCENE"),
            (["bench"], "subcommand"),
            (["bench", "table", "--surface", "paper"], "paper"),
        ):
            with self.subTest(arguments):
                self.refused(*arguments, expect=2, saying=[word])

    def test_numbers_must_be_whole_and_within_bounds(self):
        for flag, values in {
            "--threads": ("0", "-1", "1025", "99999999999999999999", "two", "2x", "1.5", "", " 2", "0x2"),
            "--depth": ("-1", "1001", "deep", "1e2"),
            "--size": ("0x0", "0x10", "10x0", "10", "10x", "x10", "-1x10", "10x10x10", "10X10", "1e3x1e3"),
            "--max-pixels": ("0", "-5", "many"),
            "--spp": ("0", "-1", "4097", "4.0", "many"),
        }.items():
            for value in values:
                with self.subTest(flag=flag, value=value):
                    self.refused("render", "room.sdl", "--hash", flag, value, expect=2, saying=[flag, value])

    def test_bench_table_checks_its_lists(self):
        for flag, values in {
            "--sizes": ("", "0", "128,", ",128", "128;256", "1000000"),
            "--depths": ("-1", "1,1001"),
            "--seconds": ("-1", "nan", "inf", "1s", "10000"),
        }.items():
            for value in values:
                with self.subTest(flag=flag, value=value):
                    self.refused("bench", "table", "--scene", "room.sdl", flag, value, expect=2, saying=[flag])

    def test_a_size_over_the_pixel_limit_names_the_flag_that_raises_it(self):
        self.refused("render", "room.sdl", "--hash", "--size", "9000x9000", expect=2, saying=["--max-pixels"])
        self.refused("render", "room.sdl", "--hash", "--size", "20x20", "--max-pixels", 399, expect=3, saying=["399"])

    def test_an_unknown_image_format_is_refused_with_the_known_ones(self):
        for name in ("picture.xyz", "picture"):
            with self.subTest(name):
                self.refused("render", "room.sdl", "-o", name, expect=2, saying=["extension", "png", "exr"])
                self.assertFalse((self.folder / name).exists())


class BadInput(GlintTest):
    def test_a_missing_scene_is_bad_input(self):
        for command in (["render"], ["info"], ["convert"], ["bench", "table", "--scene"]):
            self.refused(*command, "missing.sdl", expect=3, saying=["missing.sdl"])

    def test_a_folder_is_not_a_scene(self):
        self.refused("info", ".", expect=3, saying=["folder"])

    def test_a_mistake_is_shown_where_it_is(self):
        self.write("bad.sdl", "eye 0 0 3\nlihgt lamp.obj 1 1 1 1\n")
        self.refused("render", "bad.sdl", "--hash", expect=3, saying=["bad.sdl:2:1: error:", "lihgt lamp.obj", "^"])

    def test_limits_of_scenes_are_stated(self):
        scene = (self.folder / "room.sdl").read_text()
        self.write("large.sdl", scene.replace("size 48 32", "size 200000 200000"))
        self.refused("render", "large.sdl", "--hash", expect=3, saying=["large.sdl"])
        self.write("deep.sdl", scene.replace("max_depth 2", "max_depth 1001"))
        self.refused("render", "deep.sdl", "--hash", expect=3, saying=["deep.sdl"])

    def test_an_unreadable_mesh_is_bad_input(self):
        (self.folder / "floor.obj").unlink()
        self.refused("render", "room.sdl", "--hash", expect=3, saying=["floor.obj"])

    def test_a_scene_that_asks_for_an_unknown_format_is_bad_input(self):
        self.write("room.sdl", (self.folder / "room.sdl").read_text() + "output picture.xyz\n")
        self.refused("render", "room.sdl", expect=3, saying=["xyz", "png"])


class Failure(GlintTest):
    @needs_images
    def test_a_full_disk_is_reported_in_the_systems_words(self):
        (self.folder / "full.png").symlink_to("/dev/full")
        for target in ("full.png", "/dev/full"):
            with self.subTest(target):
                self.refused("render", "room.sdl", "-o", target, expect=1, saying=[target, "No space left on device"])
        self.assertTrue((self.folder / "full.png").is_symlink())

    def test_a_full_disk_under_standard_output_is_noticed(self):
        for arguments in (
            ["info", "room.sdl"],
            ["info", "room.sdl", "--json"],
            ["convert", "room.sdl"],
            ["render", "room.sdl", "--hash"],
            ["--version"],
            ["--help"],
        ):
            with self.subTest(arguments), open("/dev/full", "w") as full:
                done = self.glint(*arguments, expect=1, stdout=full)
                self.assertIn("standard output: No space left on device", done.stderr)

    def test_a_missing_folder_is_reported_before_rendering(self):
        self.refused(
            "render", "room.sdl", "-o", "missing/a.png", expect=1, saying=["missing/a.png", "No such file or directory"]
        )

    def test_a_folder_is_not_a_picture(self):
        (self.folder / "a.png").mkdir()
        self.refused("render", "room.sdl", "-o", "a.png", expect=1, saying=["a.png", "folder"])

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_that_cannot_be_written_is_reported(self):
        locked = self.folder / "locked"
        locked.mkdir(mode=0o500)
        self.refused("render", "room.sdl", "-o", "locked/a.png", expect=1, saying=["Permission denied"])

    def test_without_the_image_module_everything_else_works(self):
        alone = self.folder / "glint"
        shutil.copy(glint_process.GLINT, alone)
        with unittest.mock.patch("glint_process.GLINT", str(alone)):
            self.refused("render", "room.sdl", expect=1, saying=["glint_imageio_oiio.so", "libopenimageio-dev"])
            self.assertFalse((self.folder / "room.png").exists())
            self.assertIn("pixels ", self.glint("render", "room.sdl", "--hash").stdout)
            self.assertIn("OpenImageIO not available", self.glint("--version").stdout)

    def test_reports_of_bench_table_that_cannot_be_written_fail(self):
        table = ["bench", "table", "--scene", "room.sdl", "--sizes", 16, "--depths", 0, "--seconds", 0]
        table += ["--surface", "none"]
        for flag in ("--json", "--csv", "--md"):
            with self.subTest(flag):
                self.refused(*table, flag, "missing/report", expect=1, saying=["missing/report"])
                self.refused(*table, flag, "/dev/full", expect=1, saying=["/dev/full", "No space left on device"])


if __name__ == "__main__":
    unittest.main()
