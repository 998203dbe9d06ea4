"""The examples in C and Python render the same picture, say what is wrong, and are what the README shows.

GLINT_LIBRARY names libglint.so, GLINT_HELLO_C the program made of examples/c/hello.c.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PYTHON_EXAMPLE = SOURCE / "examples/python/hello.py"
HELLO = {"C": [os.environ["GLINT_HELLO_C"]], "Python": [sys.executable, "-B", PYTHON_EXAMPLE]}
CORNELL = SOURCE / "scenes/sdl/cornell.sdl"
# What ctypes finds it by; a package's library lies where the system looks.
ENVIRONMENT = {**os.environ, "LD_LIBRARY_PATH": str(Path(os.environ["GLINT_LIBRARY"]).parent)}


def run(language, *arguments):
    return subprocess.run([*HELLO[language], *arguments], env=ENVIRONMENT, text=True, capture_output=True, timeout=120)


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-hello-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_they_write_the_same_picture(self):
        pictures = {}
        for language in HELLO:
            file = self.folder / f"{language}.ppm"
            done = run(language, CORNELL, file)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""), language)
            pictures[language] = file.read_bytes()
        head, pixels = pictures["C"][:15], pictures["C"][15:]
        self.assertEqual(head, b"P6 256 256 255\n")
        self.assertEqual(len(pixels), 3 * 256 * 256)
        self.assertGreater(len(set(pixels[i:i + 3] for i in range(0, len(pixels), 3))), 1000)
        self.assertEqual(pictures["Python"], pictures["C"])

    def test_they_say_what_is_wrong(self):
        for language in HELLO:
            done = run(language, self.folder / "none.sdl", self.folder / "none.ppm")
            self.assertEqual(done.returncode, 1, language)
            self.assertIn("none.sdl", done.stderr)
            self.assertFalse((self.folder / "none.ppm").exists())

    def test_they_are_short(self):
        for file in (SOURCE / "examples/c/hello.c", PYTHON_EXAMPLE):
            self.assertLessEqual(len(file.read_text().splitlines()), 30, file)

    def test_the_readme_shows_them(self):
        readme = (SOURCE / "README.md").read_text()
        for language, file in (("c", SOURCE / "examples/c/hello.c"), ("python", PYTHON_EXAMPLE)):
            shown = re.findall(rf"^```{language}\n(.*?)^```", readme, re.MULTILINE | re.DOTALL)
            self.assertIn(file.read_text(), shown, f"the README does not show {file.name} as it is")


if __name__ == "__main__":
    unittest.main()
