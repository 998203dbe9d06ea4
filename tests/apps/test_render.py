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


if __name__ == "__main__":
    unittest.main()
