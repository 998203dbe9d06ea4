"""glint bench frame and glint bench kernels: Glint beside another ray tracer, as JSON and as text."""

import json
import unittest

from glint_process import HAS_EMBREE, GlintTest

needs_embree = unittest.skipUnless(HAS_EMBREE, "built without Embree")

SPREAD_KEYS = ["median", "min", "p95"]
CELL_KEYS = ["scene", "width", "height", "depth", "threads", "isa", "glint_ms", "peer_ms", "ratio", "differing_pixels"]
CELL_KEYS += ["same_picture", "peer_kernel", "frames", "glint_spread_ms", "peer_spread_ms"]
CLASS_KEYS = ["mesh", "triangles", "class", "threads", "isa", "glint_mrays", "peer_mrays", "peer_kernel", "ratio"]
CLASS_KEYS += ["hits_equal", "rays", "glint_hits", "peer_hits", "same_share", "passes", "glint_ms", "peer_ms"]
BUILD_KEYS = ["mesh", "triangles", "threads", "glint_ms", "glint_bytes_per_triangle", "peer_ms", "peer_high_ms"]
BUILD_KEYS += ["peer_bytes_per_triangle", "peer_high_bytes_per_triangle"]
BUILD_KEYS += ["glint_spread_ms", "peer_spread_ms", "peer_high_spread_ms"]

FRAME = ("bench", "frame", "--scene", "room.sdl", "--sizes", "16,33", "--depths", "0,2", "--seconds", 0)
KERNELS = ("bench", "kernels", "--scene", "room.sdl", "--size", 33, "--seconds", 0)


class Comparison(GlintTest):
    def report(self, *arguments):
        """What was printed, and the JSON."""
        done = self.glint(*arguments, "--json", "report.json")
        report = json.loads((self.folder / "report.json").read_text())
        self.assertTrue(report["machine"]["cpu"])
        self.assertIn("Embree", report["peer"])
        return done.stdout, report

    def check_spread(self, spread):
        self.assertEqual(list(spread), SPREAD_KEYS)
        self.assertLessEqual(0, spread["min"])
        self.assertLessEqual(spread["min"], spread["median"])
        self.assertLessEqual(spread["median"], spread["p95"])

    def check_rows(self, rows, keys):
        for row in rows:
            self.assertEqual(list(row), keys)
            for key in keys:
                if isinstance(row[key], dict):
                    self.check_spread(row[key])


@needs_embree
class BenchFrame(Comparison):
    def test_there_is_a_cell_for_each_number_of_threads_size_and_depth(self):
        out, report = self.report(*FRAME, "--threads", "1,2", "--isa", "scalar")
        cells = report["cells"]
        self.check_rows(cells, CELL_KEYS)
        self.assertEqual([(c["threads"], c["width"], c["height"], c["depth"]) for c in cells],
                         [(t, s, s, d) for t in (1, 2) for s in (16, 33) for d in (0, 2)])
        for cell in cells:
            self.assertEqual((cell["scene"], cell["isa"]), ("room.sdl", "scalar"))
            self.assertGreaterEqual(cell["frames"], 20)
            self.assertAlmostEqual(cell["ratio"], cell["peer_ms"] / cell["glint_ms"], places=6)
            self.assertEqual(cell["glint_ms"], cell["glint_spread_ms"]["median"])
            self.assertTrue(cell["same_picture"])
            self.assertLessEqual(cell["differing_pixels"], cell["width"] * cell["height"] / 1000)
        self.assertIn("33x33", out)

    def test_without_a_scene_it_is_the_papers(self):
        _, report = self.report("bench", "frame", "--sizes", 16, "--depths", 1, "--threads", 1, "--seconds", 0)
        self.assertEqual([cell["scene"] for cell in report["cells"]], ["cornell.sdl"])


@needs_embree
class BenchKernels(Comparison):
    def check_report(self, report, threads, triangles):
        self.check_rows(report["classes"], CLASS_KEYS)
        self.check_rows(report["builds"], BUILD_KEYS)
        self.assertEqual([(row["threads"], row["class"]) for row in report["classes"]],
                         [(t, c) for t in threads for c in ("primary", "shadow", "mirror", "diffuse")])
        self.assertEqual([row["threads"] for row in report["builds"]], list(threads))
        for row in report["classes"]:
            self.assertEqual(row["triangles"], triangles)
            self.assertTrue(row["hits_equal"], row)
            self.assertGreaterEqual(row["passes"], 3)
            self.assertAlmostEqual(row["ratio"], row["glint_mrays"] / row["peer_mrays"], places=6)
            self.assertAlmostEqual(row["glint_mrays"], 1e-3 * row["rays"] / row["glint_ms"]["median"], places=6)
        for row in report["builds"]:
            self.assertGreater(row["glint_ms"], 0)
            self.assertGreater(row["peer_ms"], 0)
            self.assertGreater(row["glint_bytes_per_triangle"], 0)
            self.assertGreater(row["peer_bytes_per_triangle"], 0)

    def test_a_scene_is_traced_without_its_lights_meshes(self):
        out, report = self.report(*KERNELS, "--threads", "1,2", "--isa", "scalar")
        self.check_report(report, threads=(1, 2), triangles=4)
        self.assertEqual(report["classes"][0]["rays"], 33 * 33)
        self.assertEqual({row["isa"] for row in report["classes"]}, {"scalar"})
        self.assertIn("primary", out)

    def test_a_mesh_is_looked_at_so_that_it_is_seen(self):
        _, report = self.report("bench", "kernels", "--mesh", "lamp.obj", "--size", 40, "--seconds", 0)
        self.check_report(report, threads=(1,), triangles=2)
        self.assertEqual(report["classes"][0]["mesh"], "lamp.obj")
        self.assertGreater(report["classes"][0]["glint_hits"], 100)


class Refusals(GlintTest):
    def test_wrong_options_are_refused(self):
        for arguments, word in (
            ([*FRAME, "--peer", "povray"], "embree"),
            ([*FRAME, "--threads", "0"], "--threads"),
            ([*FRAME, "--isa", "sse9"], "scalar"),
            ([*KERNELS, "--peer", "povray"], "embree"),
            ([*KERNELS, "--size", "0"], "--size"),
            ([*KERNELS, "--mesh", "lamp.obj"], "--scene"),
            ([*KERNELS, "--seconds", "soon"], "--seconds"),
        ):
            with self.subTest(arguments):
                self.refused(*arguments, expect=2, saying=[word])

    @needs_embree
    def test_what_cannot_be_read_is_bad_input(self):
        for command in ("frame", "kernels"):
            self.refused("bench", command, "--scene", "missing.sdl", expect=3, saying=["missing.sdl"])
            self.refused("bench", command, "--scene", "nowhere", expect=3, saying=["nowhere.sdl"])
        self.refused("bench", "kernels", "--mesh", "missing.obj", expect=3, saying=["missing.obj"])

    @needs_embree
    def test_scenes_that_a_peer_cannot_draw_are_not_compared(self):
        scene = "dialect glint\n" + (self.folder / "room.sdl").read_text().split("object ")[0]
        material = " 0.9 0.5 0.2 0.3 0.7 0 1 0 0.5 "
        floor = f"object floor.obj 0 0 0{material}"
        ball = f"objectquadric 1 1 1 0 0 0 0 0 3 8{material}1\n"
        for text, words in (
            (floor + "1.5\n", "refraction (object 'floor.obj')"),
            (floor + "1\nreflection_adds on\n", "reflection that adds"),
            (floor + "1\nlight_point 0 0 0 1 1 1 1\n", "lights without a mesh (light 'point')"),
            (floor + "1\nnshadowrays 4\n", "soft shadows"),
            (floor + "1\nsamples 4\n", "several samples"),
            (floor + "1\ntonemapping 1\n", "tone curve"),
            (floor + "1\n" + ball, "quadrics (object 'quadric')"),
        ):
            with self.subTest(words):
                self.write("new.sdl", scene + text)
                self.refused("bench", "frame", "--scene", "new.sdl", expect=3, saying=["peer cannot draw", words])
        self.refused("bench", "kernels", "--scene", "new.sdl", expect=3, saying=["cannot trace quadrics"])

    @needs_embree
    def test_a_report_that_cannot_be_written_fails(self):
        for command in (FRAME, KERNELS):
            self.refused(*command, "--threads", 1, "--json", "missing/a.json", expect=1, saying=["missing/a.json"])

    @unittest.skipIf(HAS_EMBREE, "built with Embree")
    def test_without_embree_it_says_what_to_install(self):
        for command in (FRAME, KERNELS):
            self.refused(*command, expect=1, saying=["built without Embree: install libembree-dev"])


if __name__ == "__main__":
    unittest.main()
