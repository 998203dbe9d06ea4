"""Kernels of other machines, cross-compiled and run here: the pictures and hits of all others, to the last bit.

GLINT_BUILD names the folder to build in, CMAKE the program; CMAKE_GENERATOR is CMake's own variable.
"""

import os
import shutil
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["GLINT_BUILD"])
CMAKE = os.environ["CMAKE"]

# On a machine that is imitated, a picture takes twenty to fifty times as long.
MOST_PIXELS = 20_000
SCENES = ("cornell", "mirrors")
RAYS = 30_000


def missing_packages(needed):
    """Of packages by a program of theirs, those that are not there."""
    return [package for program, package in needed.items() if not shutil.which(program)]


class CrossTest:
    """To be mixed into a unittest.TestCase."""

    preset = None  # of CMakePresets.json
    isa = None  # the best that the other machine has, beside scalar
    runner = []  # what runs its programs
    suffix = ""  # of its programs
    targets = []  # beside the programs that every machine runs
    scenes = SCENES

    @classmethod
    def setUpClass(cls):
        cls.run_program(CMAKE, "--preset", cls.preset, "-B", BUILD)
        cls.run_program(CMAKE, "--build", BUILD, "--parallel", os.cpu_count(),
                        "--target", "glint_check_pictures", "glint_compare_rays", *cls.targets)

    @staticmethod
    def run_program(*command):
        """What it prints; fails with that where it fails."""
        done = subprocess.run(list(map(str, command)), cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True)
        if done.returncode != 0:
            raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
        return done.stdout

    def command(self, program, *arguments):
        return [*self.runner, f"{BUILD / 'tests' / program}{self.suffix}", *arguments]

    def test_every_kernel_renders_the_golden_pictures(self):
        for isa in sorted({"scalar", self.isa}):
            with self.subTest(isa=isa):
                out = self.run_program(*self.command("golden/glint_check_pictures", isa, MOST_PIXELS, *self.scenes))
                self.assertIn(f"as they were, with {isa}", out)

    def test_no_other_instruction_set_is_offered(self):
        done = subprocess.run(self.command("golden/glint_check_pictures", "avx2", "1", "cornell"),
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"there is: {', '.join(dict.fromkeys(('scalar', self.isa)))}\n", done.stderr)

    def test_its_rays_hit_what_the_scalar_kernels_hit(self):
        out = self.run_program(*self.command("kernel/glint_compare_rays", RAYS))
        self.assertRegex(out, r"(?m)^all .* [1-9]\d* hits +0 differences")
