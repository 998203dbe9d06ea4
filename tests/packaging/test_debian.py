"""Debian's packages, made by cpack: what is in them, what they depend on, and that the program runs from them.

They are unpacked, not installed. GLINT_BUILD may be that of the preset "deb", whose packages are the ones to publish.
"""

import os
import re
import shutil
import unittest

from package import BUILD, CMAKE, SOURCE, PackageTest, run_in

# dpkg-shlibdeps is of dpkg-dev; cpack asks file(1) what is a library.
MISSING = [tool for tool in ("dpkg-deb", "dpkg-shlibdeps", "file") if not shutil.which(tool)]


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class Debian(PackageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run_in(BUILD, CMAKE.replace("cmake", "cpack"), "-G", "DEB", "-B", cls.folder / "packages")
        cls.root = cls.folder / "root"
        (cls.folder / "control").mkdir()
        cls.fields, cls.contents = {}, {}
        for package in (cls.folder / "packages").glob("*.deb"):
            name = package.name.split("_")[0]
            fields = run_in(cls.folder, "dpkg-deb", "--field", package)
            cls.fields[name] = dict(re.findall(r"^([\w-]+): (.*)", fields, re.M))
            run_in(cls.folder, "dpkg-deb", "--control", package, cls.folder / "control" / name)
            run_in(cls.folder, "dpkg-deb", "--extract", package, cls.root)
            cls.contents[name] = run_in(cls.folder, "dpkg-deb", "--contents", package)

    def test_there_is_a_package_for_each_use(self):
        wanted = {"libglint0", "libglint-dev", "glint-tools", "glint-imageio"}
        if not (BUILD / "glint_imageio_oiio.so").exists():
            wanted.remove("glint-imageio")
        self.assertEqual(set(self.fields), wanted)
        for name, fields in self.fields.items():
            with self.subTest(name):
                self.assertTrue((self.root / "usr/share/doc" / name / "copyright").is_file())
                self.assertTrue((self.root / "usr/share/doc" / name / "changelog.Debian.gz").is_file())
                self.assertNotIn(str(SOURCE), self.contents[name])

    def test_each_depends_on_the_libraries_that_it_links_and_on_no_more(self):
        runtime = r"libc6 \(>= [\d.]+\)|libgcc-s1 \(>= [\d.]+\)|libstdc\+\+6 \(>= [\d.]+\)"
        expected = {
            "libglint0": runtime,
            "libglint-dev": r"libglint0 \(= [\d.-]+\)|libglm-dev",
            "glint-tools": runtime + r"|libfmt\d+ \(.*\)|libembree3-3 \(.*\)",
            "glint-imageio": runtime + r"|libopenimageio[\d.]+(t64)? \(.*\)",
        }
        for name, fields in self.fields.items():
            with self.subTest(name):
                for dependency in fields["Depends"].split(", "):
                    self.assertRegex(dependency, rf"^({expected[name]})$")
        self.assertIn("glint-imageio", self.fields["glint-tools"]["Recommends"])

    def test_the_library_has_the_name_that_programs_look_for(self):
        library = next(self.root.rglob("libglint.so.0"))
        self.assertIn("Library soname: [libglint.so.0]", run_in(self.folder, "readelf", "--dynamic", library))
        self.assertIn(f"{library.name} ->", self.contents["libglint0"])
        self.assertIn("libglint.so -> libglint.so.0", self.contents["libglint-dev"])
        control = self.folder / "control/libglint0"
        self.assertRegex((control / "shlibs").read_text(), r"^libglint 0 libglint0 \(>= [\d.-]+\)\n?$")
        self.assertEqual((control / "triggers").read_text(), "activate-noawait ldconfig\n")

    def test_the_version_is_that_of_the_changelog(self):
        changelog = (SOURCE / "packaging/debian/changelog").read_text()
        version = re.match(r"glint \((\S+)\)", changelog)[1]
        self.assertEqual({fields["Version"] for fields in self.fields.values()}, {version})

    def test_the_program_runs_from_where_it_was_unpacked(self):
        glint = self.root / "usr/bin/glint"
        scene = self.root / "usr/share/glint/scenes/cornell.sdl"
        self.assertTrue(os.access(glint, os.X_OK))
        self.assertRegex(run_in(self.folder, glint, "render", scene, "--size", "32x32", "--hash"), r"pixels [0-9a-f]{16}")
        if "glint-imageio" in self.fields:
            run_in(self.folder, glint, "render", scene, "--size", "32x32", "-o", "room.png")
            self.assertEqual((self.folder / "room.png").read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
