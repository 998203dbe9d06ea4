"""The NEON kernel on an emulated 64-bit ARM: the pictures and hits of every other machine, to the last bit.

GLINT_BUILD names the folder to build in, CMAKE the program; CMAKE_GENERATOR is CMake's own variable.
"""

import os
import shutil
import subprocess
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["GLINT_BUILD"])
CMAKE = os.environ["CMAKE"]
EMULATOR = ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu"]

NEEDED = {"aarch64-linux-gnu-g++": "g++-aarch64-linux-gnu", "qemu-aarch64-static": "qemu-user-static"}
MISSING = [package for program, package in NEEDED.items() if not shutil.which(program)]

# Emulated, a picture takes twenty to fifty times as long.
MOST_PIXELS = 20_000
SCENES = ("cornell", "mirrors")
RAYS = 30_000


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class Neon(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_program(CMAKE, "--preset", "aarch64", "-B", BUILD)
        cls.run_program(CMAKE, "--build", BUILD, "--parallel", os.cpu_count(),
                        "--target", "glint_check_pictures", "glint_compare_rays")

    @staticmethod
    def run_program(*command):
        """What it prints; fails with that where it fails."""
        done = subprocess.run(list(map(str, command)), cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True)
        if done.returncode != 0:
            raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
        return done.stdout

    def emulate(self, program, *arguments):
        return self.run_program(*EMULATOR, BUILD / "tests" / program, *arguments)

    def test_every_kernel_renders_the_golden_pictures(self):
        for isa in ("scalar", "neon"):
            with self.subTest(isa=isa):
                out = self.emulate("golden/glint_check_pictures", isa, MOST_PIXELS, *SCENES)
                self.assertIn(f"as they were, with {isa}", out)

    def test_neon_is_the_best_there_is_and_no_other_is_offered(self):
        done = subprocess.run([*EMULATOR, BUILD / "tests/golden/glint_check_pictures", "avx2", "1", "cornell"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is: scalar, neon\n", done.stderr)

    def test_its_rays_hit_what_the_scalar_kernels_hit(self):
        self.assertRegex(self.emulate("kernel/glint_compare_rays", RAYS), r"(?m)^all .* [1-9]\d* hits +0 differences$")


if __name__ == "__main__":
    unittest.main()
