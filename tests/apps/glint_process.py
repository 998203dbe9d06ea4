"""Runs the glint program on small scenes in a folder of the test's own.

The environment variable GLINT names the program; GLINT_WRITES_IMAGES=0 says that it was built without OpenImageIO,
GLINT_HAS_EMBREE=0 without Embree.
"""

import os
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

GLINT = os.environ["GLINT"]
WRITES_IMAGES = os.environ.get("GLINT_WRITES_IMAGES", "1") != "0"
HAS_EMBREE = os.environ.get("GLINT_HAS_EMBREE", "1") != "0"
needs_images = unittest.skipUnless(WRITES_IMAGES, "built without OpenImageIO")

# Generous: the same tests run under sanitizers and on busy machines.
TIMEOUT_S = 300

SQUARE = "v -1 {y} -4\nv 1 {y} -4\nv 1 {y} -2\nv -1 {y} -2\nf 1 2 3 4\n"

SCENE = """\
eye 0 0 3
size 48 32
ortho -1 -1 1 1
background 0.1 0.2 0.3
ambient 1
max_depth 2
light lamp.obj 1 1 1 1
object floor.obj 0.9 0.5 0.2 0.3 0.7 0 0 0.5 0
object ceiling.obj 0.2 0.5 0.9 0.3 0.4 0.3 10 0 0
"""


class GlintTest(unittest.TestCase):
    """A test with a folder that holds room.sdl and its meshes."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-test-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.write("floor.obj", SQUARE.format(y=-0.8))
        self.write("ceiling.obj", SQUARE.format(y=0.9))
        self.write("lamp.obj", "v -0.2 0.8 -3.2\nv 0.2 0.8 -3.2\nv 0.2 0.8 -2.8\nv -0.2 0.8 -2.8\nf 1 2 3 4\n")
        self.write("room.sdl", SCENE)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def command(self, *arguments):
        return [GLINT, *map(str, arguments)]

    def glint(self, *arguments, expect=0, env=None, stdout=subprocess.PIPE, cwd=None):
        """Runs glint in the test's folder or in `cwd`; its exit code must be `expect`."""
        done = subprocess.run(
            self.command(*arguments),
            cwd=cwd or self.folder,
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=subprocess.PIPE,
            text=True,
            timeout=TIMEOUT_S,
            env={**os.environ, **(env or {})},
        )
        said = f"{' '.join(done.args)}\nstdout: {done.stdout}\nstderr: {done.stderr}"
        self.assertEqual(done.returncode, expect, said)
        return done

    def refused(self, *arguments, expect, saying, cwd=None):
        """Runs glint, which must end with exit code `expect` and say every one of the given words, as an error."""
        done = self.glint(*arguments, expect=expect, cwd=cwd)
        self.assertTrue(done.stderr.startswith("glint: "), done.stderr)
        for words in saying:
            self.assertIn(words, done.stderr)
        return done

    def names(self):
        return sorted(entry.name for entry in self.folder.iterdir())


def read_ppm(path):
    """(width, height, RGB bytes) of a binary PPM."""
    magic, size, depth, pixels = path.read_bytes().split(b"\n", 3)
    assert magic == b"P6" and depth == b"255", (magic, depth)
    width, height = map(int, size.split())
    assert len(pixels) == 3 * width * height
    return width, height, pixels


def read_png(path):
    """(width, height, RGBA bytes) of an 8-bit RGBA PNG that is not interlaced."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", data[:8]
    packed, header, place = b"", None, 8
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place : place + 8])
        body = data[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    width, height, bits, color, _, _, interlace = header
    assert (bits, color, interlace) == (8, 6, 0), header
    return width, height, _unfilter(zlib.decompress(packed), width, height)


def _unfilter(raw, width, height):
    """Undoes PNG's line filters (RFC 2083, section 6) for four bytes a pixel."""
    stride, above, out = 4 * width, bytearray(4 * width), bytearray()
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for x in range(stride):
            left = line[x - 4] if x >= 4 else 0
            corner = above[x - 4] if x >= 4 else 0
            line[x] = (line[x] + _prediction(kind, left, above[x], corner)) & 255
        out += line
        above = line
    return bytes(out)


def _prediction(kind, left, up, corner):
    if kind < 4:
        return (0, left, up, (left + up) // 2)[kind]
    guess = left + up - corner
    return min((left, up, corner), key=lambda candidate: abs(guess - candidate))
