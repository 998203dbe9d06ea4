"""glint surfaces: what there is, and why the rest is missing; glint bench upscale and present, which draw on them."""

import json
import unittest

from glint_process import GlintTest

LIBRARIES = ("libEGL.so.1", "libEGL.so", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so")
PLATFORMS = {"surfaceless", "x11", "wayland", "default"}
CONTEXT_KEYS = ["gl_version", "vendor", "renderer", "max_texture", "max_viewport", "bgra", "tells_loss"]


class WithoutLibraries(GlintTest):
    def setUp(self):
        super().setUp()
        # Found first, and no libraries: as good as absent.
        for name in LIBRARIES:
            self.write(name, "not a library")
        self.env = {"LD_LIBRARY_PATH": str(self.folder)}


class Surfaces(GlintTest):
    def survey(self, env=None):
        return json.loads(self.glint("surfaces", "--json", env=env).stdout)

    def check_context(self, context):
        for key in CONTEXT_KEYS:
            self.assertIn(key, context)
        self.assertGreaterEqual(context["max_texture"], 64)
        self.assertTrue(context["gl_version"])

    def test_whatever_is_missing_has_a_reason(self):
        survey = self.survey()
        if not survey["egl"]["available"]:
            self.assertIn("libEGL", survey["egl"]["missing"])
            self.assertIn("install", survey["egl"]["hint"])
        for display in survey["egl"]["displays"]:
            if not display["available"]:
                self.assertTrue(display["missing"], display)
                self.assertTrue(display["hint"], display)
                continue
            self.assertEqual([context["gles"] for context in display["contexts"]], [3, 2])
            for context in display["contexts"]:
                if context["available"]:
                    self.check_context(context)
                else:
                    self.assertTrue(context["missing"], context)
        if survey["osmesa"]["available"]:
            self.check_context(survey["osmesa"])
        else:
            self.assertIn("libosmesa6", survey["osmesa"]["hint"])

    def test_every_platform_is_named(self):
        survey = self.survey()
        if not survey["egl"]["available"]:
            self.skipTest("this machine has no EGL")
        names = {display["platform"] for display in survey["egl"]["displays"]}
        self.assertLessEqual(PLATFORMS, names)
        self.assertTrue(any(name.startswith("device") for name in names), names)
        text = self.glint("surfaces").stdout
        for name in names | {"OSMesa"}:
            self.assertIn(name, text)

    def test_a_display_server_that_does_not_answer_is_named(self):
        text = self.glint("surfaces", env={"DISPLAY": ":987"}).stdout
        if "EGL x11" in text:
            self.assertIn("DISPLAY is ':987'", text)

    def test_without_a_driver_egl_offers_nothing(self):
        survey = self.survey(env={"__EGL_VENDOR_LIBRARY_DIRS": str(self.folder)})
        if not survey["egl"]["available"]:
            self.skipTest("this machine has no EGL")
        self.assertEqual([d for d in survey["egl"]["displays"] if d["available"]], [])
        default = survey["egl"]["displays"][-1]
        self.assertEqual(default["platform"], "default")
        self.assertRegex(default["missing"], "^egl[A-Z][A-Za-z]+ (failed with EGL_[A-Z_]+|found none)$")


class NothingAtAll(WithoutLibraries):
    def test_it_is_an_answer_and_says_what_to_install(self):
        done = self.glint("surfaces", env=self.env)
        for words in ("libEGL.so.1", "libegl1", "libosmesa6", "There is nothing to show pictures on"):
            self.assertIn(words, done.stdout)
        survey = json.loads(self.glint("surfaces", "--json", env=self.env).stdout)
        self.assertFalse(survey["egl"]["available"])
        self.assertFalse(survey["osmesa"]["available"])
        self.assertEqual(survey["egl"]["displays"], [])

    def test_benchmarks_that_need_a_surface_say_that_there_is_none(self):
        for command in (("upscale", "--scenes", "room.sdl"), ("present",)):
            with self.subTest(command):
                done = self.glint("bench", *command, env=self.env, expect=1)
                self.assertIn("there is no surface", done.stderr)
                self.assertIn("glint surfaces", done.stderr)


class Benchmarks(GlintTest):
    def measured(self, *arguments):
        survey = json.loads(self.glint("surfaces", "--json").stdout)
        contexts = [c for d in survey["egl"]["displays"] for c in d.get("contexts", [])]
        if not any(c["available"] for c in [*contexts, survey["osmesa"]]):
            self.skipTest("this machine has neither EGL nor OSMesa")
        done = self.glint("bench", *arguments, "--seconds", 0, "--json", "report.json")
        return done.stdout, json.loads((self.folder / "report.json").read_text())

    def test_upscale_compares_the_filters_at_each_scale(self):
        text, report = self.measured("upscale", "--scenes", "room.sdl,room.sdl", "--scales", "0.5,1", "--size", "60x40")
        self.assertEqual([(r["scene"], r["scale"], r["traced_width"], r["traced_height"]) for r in report["rows"]],
                         2 * [("room.sdl", 0.5, 30, 20), ("room.sdl", 1, 60, 40)])
        for row in report["rows"]:
            self.assertEqual([cell["filter"] for cell in row["filters"]], ["nearest", "bilinear", "sharp"])
            for cell in row["filters"]:
                self.assertIn(f"{cell['psnr_db']:.2f}", text)
                self.assertGreater(cell["draw_ms"]["min"], 0)
                if row["scale"] == 1:
                    self.assertEqual((cell["psnr_db"], cell["ssim"]), (99, 1))
                else:
                    self.assertTrue(10 < cell["psnr_db"] < 60, cell)
                    self.assertTrue(0.3 < cell["ssim"] < 1, cell)

    def test_upscale_refuses_scales_that_are_none(self):
        for scales in ("0", "-1", "1.5", "half"):
            with self.subTest(scales):
                self.refused("bench", "upscale", "--scales", scales, expect=2, saying=["--scales"])

    def test_present_times_the_presenter_and_every_other_way(self):
        text, report = self.measured("present", "--size", "65x33")
        self.assertEqual(report["rows"][0]["upload"], "presenter")
        self.assertEqual(len(report["rows"]), 17)
        self.assertEqual((report["width"], report["height"]), (65, 33))
        for row in report["rows"]:
            self.assertIn(row["upload"], text)
            if not row["missing"]:
                self.assertGreaterEqual(row["frames"], 10)
                self.assertGreater(row["draw_ms"]["min"], 0)


if __name__ == "__main__":
    unittest.main()
