"""tobj as the second opinion: what it reads of an OBJ file is what Glint's reader keeps, or both refuse the file.

GLINT_DUMP names our program, CARGO_TARGET_DIR the folder to build the Rust one in. README.md says how the two are
compared; differences.txt lists where they are known to differ, and why.
"""

import os
import re
import shutil
import struct
import subprocess
import unittest
from collections import defaultdict
from pathlib import Path

from outlines import first_difference

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
SHARED = SOURCE.parent / "shared" / "data"
NONE = "no difference"
OLDEST_CARGO = (1, 65)  # that builds tobj


def cargo():
    """The program, from where rustup puts it too; None where there is none."""
    return shutil.which("cargo") or shutil.which("cargo", path=Path.home() / ".cargo" / "bin")


def missing():
    """Why tobj cannot be built here; None where it can."""
    if not cargo():
        return "cargo is not installed"
    version = subprocess.run([cargo(), "--version"], capture_output=True, text=True).stdout
    found = re.match(r"cargo (\d+)\.(\d+)", version)
    if not found or tuple(map(int, found.groups())) < OLDEST_CARGO:
        return f"{version.strip() or 'cargo'} is too old for tobj, which takes {'.'.join(map(str, OLDEST_CARGO))}"
    fetched = subprocess.run([cargo(), "fetch", "--locked"], cwd=HERE, capture_output=True, text=True)
    return None if fetched.returncode == 0 else f"crates.io cannot be reached: {fetched.stderr.strip()}"


MISSING = missing()


def files():
    """Every OBJ file there is to compare, by the name that differences.txt calls it."""
    found = {}
    places = [(SOURCE, "scenes/sdl"), (SOURCE, "tests/sdl"), (HERE, "corpus"), (SHARED, "models"), (SHARED, "sdl-wild")]
    for folder, name in places:
        for path in sorted((folder / name).rglob("*.obj")):
            found[path.relative_to(folder).as_posix()] = path
    return found


def listed_differences():
    """What differences.txt says of each file: the kind of difference."""
    listed = {}
    for line in (HERE / "differences.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, kind, reason = (part.strip() for part in line.split(":", 2))
            assert name not in listed and reason, line
            listed[name] = kind
    return listed


class Part:
    """The faces of one material, each a tuple of corners "position/texture coordinate/normal"."""

    def __init__(self):
        self.looks = None
        self.faces = []


class Reading:
    """What one program made of one file: why it refused it, or its parts by material, and what it keeps."""

    def __init__(self, *command):
        done = subprocess.run(command, capture_output=True, text=True, errors="replace")
        assert done.returncode == 0, f"{command} ended with {done.returncode}:\n{done.stderr}"
        keeps, _file, *lines = done.stdout.splitlines()
        self.keeps = keeps.removeprefix("keeps ").split()
        self.refusal = None
        self.whole = Part()  # all faces, in the file's order
        self.parts = defaultdict(Part)
        part = Part()
        for line in lines:
            kind, _, rest = line.partition(" ")
            if kind == "refused:":
                self.refusal = rest
            elif kind == "material":
                part = self.parts[rest]
            elif kind == "looks":
                part.looks = rest
            else:
                face = tuple(rest.split())
                part.faces.append(face)
                self.whole.faces.append(face)


def with_attributes(faces, attributes):
    """The faces with some attributes of their corners only: positions, texcoords, normals."""
    places = [("positions", "texcoords", "normals").index(attribute) for attribute in attributes]
    cut = {}

    def cut_corner(corner):
        if corner not in cut:
            pieces = corner.split("/")
            cut[corner] = "/".join(pieces[place] for place in places)
        return cut[corner]

    return [tuple(map(cut_corner, face)) for face in faces]


def place_of(corner):
    """The coordinates of a corner, whose position comes first."""
    return struct.unpack(">3f", bytes.fromhex(corner[:24]))


def difference_of_faces(ours, theirs, attributes):
    """The kind of the first difference between two parts' faces, and where; None where there is none."""
    for count in range(1, len(attributes) + 1):
        polygons = with_attributes(theirs.faces, attributes[:count])
        triangles = with_attributes(ours.faces, attributes[:count])
        if polygons == triangles:
            continue
        number = first_difference(polygons, triangles, place_of)
        if number is not None:
            return f"{attributes[count - 1]} differ", f"first in face {number + 1}"
    return None


def difference(ours, theirs):
    """The kind of the first difference between two readings, and where."""
    if ours.refusal and theirs.refusal:
        return NONE, "both refuse"
    if ours.refusal:
        return "only Glint refuses", ours.refusal
    if theirs.refusal:
        return "only tobj refuses", theirs.refusal
    attributes = [attribute for attribute in ours.keeps if attribute in theirs.keeps]
    if "materials" not in attributes:
        return difference_of_faces(ours.whole, theirs.whole, attributes) or (NONE, "both read")
    attributes.remove("materials")
    ours_by_name, theirs_by_name = ({name: part for name, part in reading.parts.items() if part.faces}
                                    for reading in (ours, theirs))
    if list(ours_by_name) != list(theirs_by_name):
        return "materials differ", f"{list(ours_by_name)} and {list(theirs_by_name)}"
    for name, part in ours_by_name.items():
        if part.looks != theirs_by_name[name].looks:
            return "materials differ", f"{name}: {part.looks} and {theirs_by_name[name].looks}"
        if found := difference_of_faces(part, theirs_by_name[name], attributes):
            return found
    return NONE, "both read"


@unittest.skipIf(MISSING, MISSING)
class Tobj(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Path(os.environ["CARGO_TARGET_DIR"])
        built = subprocess.run([cargo(), "build", "--release", "--locked", "--offline"], cwd=HERE,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert built.returncode == 0, built.stdout
        cls.found = {"mesh": {}, "model": {}}
        for name, path in files().items():
            theirs = Reading(folder / "release" / "dump_tobj", path)
            for reader, found in cls.found.items():
                found[name] = difference(Reading(os.environ["GLINT_DUMP"], reader, path), theirs)

    def test_files_are_read_alike_but_for_what_is_listed(self):
        listed = listed_differences()
        for reader, found in self.found.items():
            for name, (kind, details) in found.items():
                with self.subTest(file=name, reader=reader):
                    expected = listed.get(f"{name} as a {reader}", listed.get(name, NONE))
                    self.assertEqual(kind, expected, details)

    def test_what_is_listed_is_there(self):
        names = {name.removesuffix(f" as a {reader}") for name in listed_differences() for reader in self.found}
        self.assertEqual({name for name in names if " as a " not in name} - set(self.found["mesh"]), set())

    def test_most_of_the_corpus_is_read_by_both(self):
        for reader, found in self.found.items():
            with self.subTest(reader=reader):
                corpus = [how for name, how in found.items() if name.startswith("corpus/")]
                self.assertGreater(len(corpus), 90)
                self.assertGreater(corpus.count((NONE, "both read")), 40)


class Outlines(unittest.TestCase):
    """The judge must be able to find somebody guilty."""

    SQUARE = [("0" * 24, "3f800000" + "0" * 16, "3f8000003f80000000000000", "000000003f80000000000000")]

    def difference(self, *triangles):
        a_to_d = dict(zip("abcd", self.SQUARE[0]))
        cut = [tuple(a_to_d[corner] for corner in triangle) for triangle in triangles]
        return first_difference(self.SQUARE, cut, place_of)

    def test_are_met_by_either_cut(self):
        self.assertIsNone(self.difference("abc", "acd"))
        self.assertIsNone(self.difference("bcd", "dab"))

    def test_are_not_met_by_another_order_winding_or_count(self):
        for triangles in (("abc", "adc"), ("abc",), ("abc", "bcd"), ("acb", "adc"), ("abc", "acd", "abc"), ()):
            with self.subTest(triangles=triangles):
                self.assertIsNotNone(self.difference(*triangles))

    def test_may_lack_triangles_without_area_only(self):
        row = [("0" * 24, "3f800000" + "0" * 16, "40000000" + "0" * 16)]
        a, b, c, d = self.SQUARE[0]
        self.assertIsNone(first_difference(row + self.SQUARE, [(a, b, c), (a, c, d)], place_of))
        self.assertIsNotNone(first_difference(row + self.SQUARE, [(a, b, c)], place_of))


if __name__ == "__main__":
    unittest.main()
