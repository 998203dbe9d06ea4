"""What the tests of packaging share: an installed Glint in an empty prefix, and commands that must succeed.

GLINT_BUILD names the build folder and GLINT_BUILD_TYPE its build type; CMAKE, CXX and CMAKE_GENERATOR are what it uses.
"""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

BUILD = Path(os.environ["GLINT_BUILD"])
BUILD_TYPE = os.environ["GLINT_BUILD_TYPE"]
CMAKE = os.environ["CMAKE"]
CXX = os.environ["CXX"]
HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
CONSUMER = HERE / "consumer"
TIMEOUT_S = 300


def run_in(folder, *command, **environment):
    """What the command printed; it must succeed."""
    done = subprocess.run(list(map(str, command)), cwd=folder, env=os.environ | environment, text=True,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT_S)
    if done.returncode != 0:
        raise AssertionError(f"{done.args} ended with {done.returncode}\n{done.stdout}")
    return done.stdout


def cached(name):
    """What the build's cache says of a variable; None where it says nothing."""
    for line in (BUILD / "CMakeCache.txt").read_text().splitlines():
        key, equals, value = line.partition("=")
        if equals and key.split(":")[0] == name:
            return value
    return None


class PackageTest(unittest.TestCase):
    """Has a folder of its own, self.folder, for all of its tests."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="glint-package-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)

    @classmethod
    def install(cls):
        """The prefix that Glint was installed into: not where the build was told to; a package works wherever it is."""
        prefix = cls.folder / "somewhere else"
        run_in(cls.folder, CMAKE, "--install", BUILD, "--prefix", prefix)
        return prefix

    def assert_renders_alike(self, programs, **environment):
        """Each prints Glint's version and the hash of the same picture. Returns the version."""
        said = {program: run_in(self.folder, program, **environment) for program in programs}
        first = said[programs[0]]
        self.assertRegex(first, r"^\d+\.\d+\.\d+ [0-9a-f]{16}\n$")
        self.assertEqual(said, dict.fromkeys(programs, first))
        return first.split()[0]

    def assert_shows(self, program, **environment):
        """The program shows a picture where it can, and finds the image module if that was built."""
        said = run_in(self.folder, program, **environment)
        if (BUILD / "glint_imageio_oiio.so").exists():
            self.assertRegex(said, r"^OpenImageIO \d")
        else:
            self.assertIn("glint_imageio_oiio.so", said)

    def assert_owns(self, program, owns):
        """Whether the core's code is in the program itself: there once, or not at all beside the shared library."""
        defined = run_in(self.folder, "nm", "--defined-only", "--demangle", program)
        self.assertEqual("glint::Framebuffer::create(" in defined, owns, program)
