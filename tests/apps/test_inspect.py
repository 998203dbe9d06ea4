"""glint inspect says where a pixel's colour comes from, and it is the pixel of the picture that glint render writes."""

import json
import struct
import unittest
from pathlib import Path

from glint_process import GlintTest, needs_images, read_ppm

SOURCE = Path(__file__).resolve().parents[2]


def as_float(number):
    """Rounded to the floats that glint computes with."""
    return struct.unpack("f", struct.pack("f", number))[0]


def sum_of(tree):
    """What the help says the pixel is, in floats as glint adds them."""
    color = [0.0, 0.0, 0.0]
    for ray in tree["rays"]:
        for channel in range(3):
            part = as_float(ray["local_weight"] * ray["local_color"][channel])
            color[channel] = as_float(color[channel] + part)
    share = as_float(1.0 / tree["samples_per_pixel"])
    return [as_float(channel * share) for channel in color]


class Inspect(GlintTest):
    def tree(self, *arguments):
        return json.loads(self.glint("inspect", "room.sdl", "--json", *arguments).stdout)

    def test_the_rays_add_up_to_the_colour(self):
        for pixel in ("24,8", "24,22", "0,0", "47,31"):
            for depth in (0, 1, 5):
                for samples in (1, 3):
                    with self.subTest(pixel=pixel, depth=depth, samples=samples):
                        tree = self.tree("--pixel", pixel, "--depth", depth, "--spp", samples)
                        self.assertEqual(sum_of(tree), tree["color"])

    @needs_images
    def test_the_colour_is_the_pictures(self):
        options = ["--size", "20x14", "--depth", "3", "--spp", "4", "--pattern", "jittered", "--transfer", "srgb"]
        self.glint("render", "room.sdl", "-o", "room.ppm", *options)
        width, height, pixels = read_ppm(self.folder / "room.ppm")
        for x, y in ((0, 0), (10, 4), (10, 9), (5, 7), (width - 1, height - 1)):
            with self.subTest(x=x, y=y):
                tree = self.tree("--pixel", f"{x},{y}", *options)
                place = 3 * (y * width + x)
                self.assertEqual(tree["rgba8"], [*pixels[place : place + 3], 255])

    def test_the_json_has_what_the_help_promises(self):
        tree = self.tree("--pixel", "24,22")
        self.assertEqual(
            list(tree),
            ["scene", "width", "height", "x", "y", "depth", "samples_per_pixel", "color", "rgba8", "rays"],
        )
        self.assertEqual((tree["width"], tree["height"], tree["x"], tree["y"], tree["depth"]), (48, 32, 24, 22, 2))
        self.assertEqual((tree["scene"], tree["samples_per_pixel"]), ("room.sdl", 1))
        primary, shadow, mirror = (
            next(ray for ray in tree["rays"] if ray["kind"] == kind) for kind in ("primary", "shadow", "mirror")
        )
        self.assertEqual(
            list(primary),
            ["kind", "parent", "level", "sample", "origin", "direction", "distance", "target", "weight",
             "local_weight", "local_color", "contribution", "light", "light_name", "light_share"],
        )
        self.assertEqual(primary["parent"], None)
        self.assertEqual(primary["origin"], [0, 0, 3])
        self.assertEqual(primary["target"], {"kind": "object", "index": 0, "name": "floor.obj"})
        self.assertEqual((primary["light"], primary["light_name"], primary["light_share"]), (None, None, None))
        self.assertEqual((shadow["parent"], shadow["level"], shadow["sample"]), (0, 1, 0))
        self.assertEqual((shadow["light"], shadow["light_name"]), (0, "lamp.obj"))
        self.assertEqual(mirror["parent"], 0)
        self.assertEqual(as_float(primary["local_weight"] + mirror["weight"]), 1.0)

        background = self.tree("--pixel", "0,15")["rays"][0]
        self.assertEqual(background["target"], {"kind": "background", "index": None, "name": None})
        self.assertIsNone(background["distance"])

    def test_the_text_has_a_line_for_each_ray_indented_below_the_one_that_sent_it(self):
        tree = self.tree("--pixel", "24,22")
        head, bytes_line, counts, blank, columns, *rows = self.glint(
            "inspect", "room.sdl", "--pixel", "24,22"
        ).stdout.splitlines()
        self.assertEqual(head, "room.sdl: pixel 24,22 of 48x32, depth 2, 1 sample")
        self.assertTrue(bytes_line.endswith("bytes {} {} {}".format(*tree["rgba8"][:3])), bytes_line)
        self.assertTrue(counts.startswith(f"{len(tree['rays'])} rays: 1 primary"), counts)
        self.assertEqual(blank, "")
        self.assertEqual(len(rows), len(tree["rays"]))
        start = columns.index("ray")
        self.assertTrue(rows[0][start:].startswith("primary to floor.obj (0)"), rows[0])
        for row, ray in zip(rows, tree["rays"]):
            self.assertEqual(row[:start].split()[0], f"{ray['weight']:.5f}")
            said = row[start:]
            self.assertEqual(len(said) - len(said.lstrip()), 2 * ray["level"], row)
        self.assertIn("light from lamp.obj (0)", "\n".join(rows))

    def test_the_readme_shows_what_is_printed(self):
        shown = [part for part in (SOURCE / "README.md").read_text().split("```") if "4 rays: 1 primary" in part]
        self.assertEqual(len(shown), 1)
        scene = "scenes/sdl/cornell.sdl"
        out = self.glint("inspect", scene, "--pixel", "3,100", cwd=SOURCE).stdout
        self.assertEqual(out.strip(), shown[0].strip())

    def test_a_file_name_that_is_not_utf8_does_not_break_the_json(self):
        name = b"r\xffm.sdl".decode(errors="surrogateescape")
        (self.folder / "room.sdl").rename(self.folder / name)
        self.assertEqual(json.loads(self.glint("inspect", name, "--pixel", "0,0", "--json").stdout)["width"], 48)

    def test_pixels_that_are_none_are_refused(self):
        for pixel in ("", "1", "1,", ",1", "1,2,3", "-1,0", "0,-1", "1.5,2", "a,b", "1 ,2", "1x2", "99999999999,0"):
            with self.subTest(pixel):
                self.refused("inspect", "room.sdl", f"--pixel={pixel}", expect=2, saying=["--pixel"])
        self.refused("inspect", "room.sdl", expect=2, saying=["--pixel"])

    def test_pixels_outside_of_the_picture_are_refused(self):
        self.refused("inspect", "room.sdl", "--pixel", "48,0", expect=2, saying=["48,0", "48x32", "--size"])
        self.refused("inspect", "room.sdl", "--pixel", "0,32", expect=2, saying=["0,32", "48x32"])
        self.refused("inspect", "room.sdl", "--pixel", "9,9", "--size", "9x10", expect=2, saying=["9x10"])
        self.glint("inspect", "room.sdl", "--pixel", "48,0", "--size", "49x1")

    def test_a_scene_that_is_none_is_refused(self):
        self.refused("inspect", "none.sdl", "--pixel", "0,0", expect=3, saying=["none.sdl"])
        self.write("bad.sdl", "eye 0 0\n")
        self.refused("inspect", "bad.sdl", "--pixel", "0,0", expect=3, saying=["bad.sdl:1"])


if __name__ == "__main__":
    unittest.main()
