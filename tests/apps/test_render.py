"""glint render: the same picture on every path, in every format."""

import re
import unittest

from glint_process import GlintTest, needs_images, read_png, read_ppm

HASHES = re.compile(r"pixels [0-9a-f]{16}\nradiance [0-9a-f]{16}\n")


class Render(GlintTest):
    def hashes(self, *arguments):
        out = self.glint("render", "room.sdl", "--hash", *arguments).stdout
        self.assertRegex(out, HASHES)
        return out

    def test_hash_prints_two_lines_and_writes_no_file(self):
        before = self.names()
        self.assertIsNotNone(HASHES.fullmatch(self.hashes()))
        self.assertEqual(self.names(), before)

    def test_the_hash_does_not_depend_on_the_number_of_threads(self):
        one = self.hashes("--threads", 1)
        for threads in (2, 3, 8):
            self.assertEqual(self.hashes("--threads", threads), one)

    def test_brute_force_and_kdtree_make_the_same_picture(self):
        self.assertEqual(self.hashes("--accel", "brute"), self.hashes("--accel", "kdtree"))

    def test_depth_and_size_make_another_picture(self):
        pictures = {self.hashes(*flags) for flags in ([], ["--depth", 0], ["--depth", 1], ["--size", "32x48"])}
        self.assertGreaterEqual(len(pictures), 3)
        self.assertEqual(self.hashes("--depth", 2), self.hashes())
        self.assertEqual(self.hashes("--size", "48x32"), self.hashes())

    @needs_images
    def test_without_output_the_picture_has_the_scenes_name(self):
        done = self.glint("render", "room.sdl")
        self.assertEqual(done.stdout, "wrote room.png (48x32)\n")
        self.assertEqual(done.stderr, "")
        self.assertEqual(read_png(self.folder / "room.png")[:2], (48, 32))

    @needs_images
    def test_the_png_is_opaque_and_not_one_colour(self):
        self.glint("render", "room.sdl", "-o", "a.png")
        _, _, rgba = read_png(self.folder / "a.png")
        self.assertEqual(set(rgba[3::4]), {255})
        self.assertGreater(len({rgba[i : i + 3] for i in range(0, len(rgba), 4)}), 20)

    @needs_images
    def test_png_and_ppm_hold_the_same_pixels(self):
        self.glint("render", "room.sdl", "-o", "a.png")
        self.glint("render", "room.sdl", "-o", "a.ppm")
        width, height, rgba = read_png(self.folder / "a.png")
        rgb = bytes(byte for i, byte in enumerate(rgba) if i % 4 != 3)
        self.assertEqual(read_ppm(self.folder / "a.ppm"), (width, height, rgb))

    @needs_images
    def test_every_format_starts_with_its_own_signature(self):
        signatures = {
            "a.png": b"\x89PNG",
            "a.jpg": b"\xff\xd8\xff",
            "a.exr": b"\x76\x2f\x31\x01",
            "a.hdr": b"#?RADIANCE",
            "a.bmp": b"BM",
            "a.PPM": b"P6",
        }
        for name, signature in signatures.items():
            with self.subTest(name):
                done = self.glint("render", "room.sdl", "-o", name, "--size", "16x16")
                self.assertEqual(done.stdout, f"wrote {name} (16x16)\n")
                self.assertTrue((self.folder / name).read_bytes().startswith(signature))

    @needs_images
    def test_writing_leaves_nothing_but_the_picture(self):
        before = self.names()
        self.glint("render", "room.sdl", "-o", "a.png")
        self.assertEqual(self.names(), sorted(before + ["a.png"]))

    @needs_images
    def test_the_scenes_output_is_beside_the_scene(self):
        (self.folder / "elsewhere").mkdir()
        self.write("room.sdl", (self.folder / "room.sdl").read_text() + "output picture.ppm\n")
        done = self.glint("render", self.folder / "room.sdl")
        self.assertIn("picture.ppm (48x32)", done.stdout)
        self.assertEqual(read_ppm(self.folder / "picture.ppm")[:2], (48, 32))

    @needs_images
    def test_a_scenes_output_may_not_leave_the_scene_root(self):
        (self.folder / "inner").mkdir()
        for name in ("floor.obj", "ceiling.obj", "lamp.obj"):
            (self.folder / name).rename(self.folder / "inner" / name)
        scene = (self.folder / "room.sdl").read_text()
        for output in ("../escaped.png", str(self.folder / "escaped.png")):
            with self.subTest(output):
                self.write("inner/room.sdl", f"{scene}output {output}\n")
                # From inside the scene's folder and from somewhere else: then that folder is the root.
                for cwd in (self.folder / "inner", "/", "/usr"):
                    path = self.folder / "inner/room.sdl"
                    self.refused("render", path, expect=3, saying=[output], cwd=cwd)
                    self.assertFalse((self.folder / "escaped.png").exists())
                self.glint("render", "inner/room.sdl", "--allow-outside-root", cwd=self.folder)
                (self.folder / "escaped.png").unlink()

    def test_the_current_folder_is_the_root_where_the_scene_lies_inside_it(self):
        inner = self.folder / "Input/config"
        inner.mkdir(parents=True)
        (self.folder / "floor.obj").rename(self.folder / "Input/floor.obj")
        scene = (self.folder / "room.sdl").read_text().replace("floor.obj", "Input/floor.obj")
        self.write("Input/config/room.sdl", scene)
        above = self.glint("render", "Input/config/room.sdl", "--hash").stdout
        self.assertEqual(self.glint("render", inner / "room.sdl", "--hash").stdout, above)
        self.assertEqual(self.glint("render", "room.sdl", "--hash", "--scene-root", "../..", cwd=inner).stdout, above)
        for cwd in (inner, self.folder / "Input", "/usr", "/"):
            hint = f"--scene-root {self.folder.resolve()} would find {self.folder.resolve()}/Input/floor.obj"
            self.refused("render", inner / "room.sdl", "--hash", expect=3, saying=[hint], cwd=cwd)

    def test_samples_pattern_and_transfer_are_taken(self):
        for flags in (["--spp", 1], ["--spp", 4096, "--size", "2x2"], ["--transfer", "srgb"], ["--pattern", "jittered"]):
            self.hashes(*flags)
        self.assertEqual(self.hashes("--spp", 1, "--pattern", "centre", "--transfer", "linear"), self.hashes())

    def test_stats_name_times_rays_threads_and_tree(self):
        done = self.glint("render", "room.sdl", "--stats", "--threads", 2, "--depth", 0)
        for line in (r"read +\d", r"build +\d", r"render +\d", r"threads +2\n", r"isa +\w", r"tree +kdtree, 6 triangles"):
            self.assertRegex(done.stdout, line)
        rays = re.search(r"rays +(\d+) \((\d+) primary, (\d+) shadow, (\d+) secondary\)", done.stdout)
        total, primary, shadow, secondary = map(int, rays.groups())
        self.assertEqual(primary, 48 * 32)
        self.assertEqual(secondary, 0)
        self.assertGreater(shadow, 0)
        self.assertEqual(total, primary + shadow + secondary)


class Frames(GlintTest):
    """A lamp's worth of motion: a box that goes from side to side in four frames."""

    def setUp(self):
        super().setUp()
        room = (self.folder / "room.sdl").read_text()
        self.object = re.search(r"^object (\S+)", room, re.MULTILINE)[1]
        moving = room + "animate_object 1 0 translate 0 0 0\nanimate_object 1 1 translate 0.5 0.25 0\n"
        (self.folder / "moving.sdl").write_text(moving)

    def frames(self, *arguments):
        out = self.glint("render", "moving.sdl", "--hash", *arguments).stdout
        return dict(re.findall(r"^frame (\d+) (pixels [0-9a-f]{16} radiance [0-9a-f]{16})$", out, re.MULTILINE))

    def test_each_shows_the_scene_at_its_time(self):
        frames = self.frames("--frames", "0..5", "--fps", 4)
        self.assertEqual(list(frames), ["0", "1", "2", "3", "4", "5"])
        self.assertEqual(len({frames[n] for n in "01234"}), 5)
        self.assertEqual(frames["4"], frames["5"])
        still = self.glint("render", "room.sdl", "--hash").stdout
        self.assertEqual(frames["0"], " ".join(still.split("\n")[:2]))
        self.assertEqual(self.frames("--frames", "2..2", "--fps", 4)["2"], frames["2"])
        self.assertEqual(self.frames("--frames", "0..5", "--fps", 4, "--threads", 3, "--isa", "scalar"), frames)

    @needs_images
    def test_go_to_numbered_files(self):
        self.glint("render", "moving.sdl", "--frames", "9..11", "-o", "f.%03d.png")
        self.glint("render", "moving.sdl", "--frames", "0..0", "-o", "g%d.png")
        names = {name for name in self.names() if name.endswith(".png")}
        self.assertEqual(names, {"f.009.png", "f.010.png", "f.011.png", "g0.png"})

    def test_bad_patterns_and_ranges_are_refused(self):
        for arguments in (["-o", "f.png"], ["-o", "f.%d.%d.png"], ["-o", "f.%s.png"], ["-o", "f.%4d.png"], ["-o", "f%"], []):
            done = self.glint("render", "moving.sdl", "--frames", "0..1", *arguments, expect=2)
            self.assertIn("frame.%04d.png", done.stderr)
        for text in ("1..0", "5", "a..b", "0...3", "-1..2", "0..1000001"):
            done = self.glint("render", "moving.sdl", "--hash", f"--frames={text}", expect=2)
            self.assertIn("is not a range of frames like 0..99", done.stderr)
        self.glint("render", "moving.sdl", "--hash", "--fps", 5, expect=2)

    def test_of_a_scene_that_does_not_move_are_warned_of(self):
        done = self.glint("render", "room.sdl", "--frames", "0..1", "--hash")
        self.assertIn("nothing moves in this scene", done.stderr)

    def test_updates_are_measured(self):
        done = self.glint("bench", "moving", "--scene", "moving.sdl", "--frames", 3)
        self.assertRegex(done.stdout, r"moving objects +1\b")
        self.assertRegex(done.stdout, r"update, ms +median +\d+\.\d+")
        self.assertIn("nothing moves", self.glint("bench", "moving", "--scene", "room.sdl", expect=3).stderr)


if __name__ == "__main__":
    unittest.main()
