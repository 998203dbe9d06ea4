"""The NEON kernel on an emulated 64-bit ARM, the core's own tests, and the library that a phone would get."""

import os
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from cross_test import BUILD, SOURCE, CrossTest, missing_packages

MISSING = missing_packages({"aarch64-linux-gnu-g++": "g++-aarch64-linux-gnu",
                            "qemu-aarch64-static": "qemu-user-static"})

# Room -> its tests, but for those that would take minutes here: millions of triangles, of mutations, of numbers.
UNIT_TESTS = {
    "math": "*",
    "text": "-*any_number",
    "scene": "-Ellipsoids.*",
    "image": "*",
    "mesh": "-Large*:Mutated*:Polygons.with_a_hundred*",
    "sdl": "-Large*:SceneFiles.beyond*",
    "kernel": "Isas.*:Batches.*:OddScenes.*",
    "render": "Shading.*:Shadows.*:Lights.*:Depth.*:Transmission.*:RayCounts.*:Tiles.*:Cancel.*:Curves.*",
}
HAS_GOOGLETEST_SOURCES = Path("/usr/src/googletest/googletest/src/gtest-all.cc").exists()


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class Neon(CrossTest, unittest.TestCase):
    preset = "aarch64"
    isa = "neon"
    runner = ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu"]
    targets = ["glint_shared", "glint_render_frames"]
    if HAS_GOOGLETEST_SOURCES:
        targets += [f"{room}_tests" for room in UNIT_TESTS]

    @unittest.skipUnless(HAS_GOOGLETEST_SOURCES, "libgtest-dev brings no sources here")
    def test_the_core_passes_its_own_tests(self):
        def out_of(room):
            return self.run_program(*self.command(f"{room}/{room}_tests", f"--gtest_filter={UNIT_TESTS[room]}"))

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for room, out in zip(UNIT_TESTS, pool.map(out_of, UNIT_TESTS)):
                with self.subTest(room=room):
                    self.assertRegex(out, r"(?m)^\[  PASSED  \] [1-9]\d* tests?\.$")

    def test_the_library_is_small_and_links_only_the_runtime(self):
        environment = {**os.environ, "GLINT_LIBRARY": str(BUILD / "core/libglint.so"),
                       "GLINT_STRIP": "aarch64-linux-gnu-strip"}
        done = subprocess.run([sys.executable, "-B", SOURCE / "tests/architecture/test_library.py"], env=environment,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_instructions_can_be_counted(self):
        count = [sys.executable, "-B", SOURCE / "bench/instructions/count.py", BUILD, "--isa", "neon", "--size", "16"]
        said = [self.run_program(*count).splitlines()[-1] for _ in range(2)]
        self.assertEqual(said[0], said[1]) # as often as one likes
        a_ray = float(said[0].split("|")[-2])
        self.assertGreater(a_ray, 50)
        self.assertLess(a_ray, 5000)


if __name__ == "__main__":
    unittest.main()
