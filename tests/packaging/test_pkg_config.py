"""A compiler and pkg-config build programs with an installed Glint, wherever it was put: shared, static, with its parts."""

import shlex
import shutil
import unittest

from package import CONSUMER, CXX, PackageTest, run_in


@unittest.skipUnless(shutil.which("pkg-config"), "pkg-config is not installed")
class PkgConfig(PackageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.install()
        cls.found = {"PKG_CONFIG_PATH": str(next(cls.prefix.rglob("glint.pc")).parent)}
        cls.loaded = {"LD_LIBRARY_PATH": str(next(cls.prefix.rglob("libglint.so")).parent)}

    def build(self, source, program, *arguments, flags=()):
        asked = run_in(self.folder, "pkg-config", "--cflags", "--libs", *arguments, **self.found)
        run_in(self.folder, CXX, "-std=c++20", CONSUMER / source, "-o", program, *flags, *shlex.split(asked))
        return self.folder / program

    def test_programs_are_built_with_each_form_of_the_library(self):
        shared = self.build("render.cpp", "shared", "glint")
        core = self.build("render.cpp", "core", "glint-core")
        all_static = self.build("render.cpp", "static", "--static", "glint", flags=["-static"])
        self.assert_renders_alike([shared, core, all_static], **self.loaded)
        for program, owns in [(shared, False), (core, True), (all_static, True)]:
            self.assert_owns(program, owns)
        self.assert_renders_alike([core, all_static]) # which look for no library of Glint's

    def test_what_shows_and_writes_pictures_brings_the_library_along(self):
        show = self.build("show.cpp", "show", "glint-egl", "glint-osmesa", "glint-imageio")
        self.assert_shows(show, **self.loaded)

    def test_every_package_names_the_version(self):
        packages = sorted(path.stem for path in self.prefix.rglob("*.pc"))
        self.assertEqual(packages, ["glint", "glint-core", "glint-egl", "glint-gles", "glint-imageio", "glint-osmesa"])
        versions = {run_in(self.folder, "pkg-config", "--modversion", package, **self.found) for package in packages}
        self.assertEqual(len(versions), 1, versions)


if __name__ == "__main__":
    unittest.main()
