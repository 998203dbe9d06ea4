"""Glint as a part of another project, by add_subdirectory and by FetchContent: its libraries, and nothing else of it."""

import json
import re
import sys
import unittest

from package import BUILD, BUILD_TYPE, CMAKE, CONSUMER, CXX, HERE, SOURCE, PackageTest, cached, run_in

# What a project that has Glint as a part finds in its cache, beside what CMake and its own packages put there.
OURS = re.compile(r"GLINT_\w+|pkgcfg_lib_GLINT_\w+|glm_DIR|PKG_CONFIG_\w+|FETCHCONTENT_\w+|CMAKE_\w+")


@unittest.skipUnless((BUILD / "compile_commands.json").exists(), "this build keeps no compile_commands.json")
class Part(PackageTest):
    def host(self, way):
        """The consumer, configured and built with Glint as its part. Returns its folder."""
        build = self.folder / way
        own = [f"-D{name}={cached(name)}" for name in ("GLINT_WERROR", "GLINT_ISAS")]
        launcher = f"{sys.executable};-BES;{HERE / 'compiled_already.py'}"
        run_in(self.folder, CMAKE, "-S", CONSUMER, "-B", build, f"-DWAY={way}", f"-DGLINT_SOURCE={SOURCE}",
               f"-DCMAKE_BUILD_TYPE={BUILD_TYPE}", f"-DCMAKE_CXX_COMPILER={CXX}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
               f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}", *own)
        self.compiled = self.folder / f"{way}.compiled"
        run_in(self.folder, CMAKE, "--build", build, "--parallel", "2", GLINT_COMPILED=str(self.compiled),
               GLINT_COMMANDS=str(BUILD / "compile_commands.json"))
        return build

    def assert_works(self, build):
        self.assert_renders_alike([build / "render_with_core", build / "render_with_shared"])
        self.assert_shows(build / "show")
        self.assert_owns(build / "show_with_shared", False)

    def test_by_add_subdirectory(self):
        build = self.host("add_subdirectory")
        self.assert_works(build)
        with self.subTest("its sources are compiled as they are by themselves"):
            compiled = self.compiled.read_text().splitlines()
            self.assertEqual({line for line in compiled if "/tests/packaging/consumer/" not in line}, set())
        with self.subTest("the host's are compiled as the host says"):
            for entry in json.loads((build / "compile_commands.json").read_text()):
                if "/consumer/" in entry["file"]:
                    self.assertNotRegex(entry["command"], r" -(W|f|Werror|DGLINT)")
        with self.subTest("no programs, no tests, nothing installed, nothing that the host does not link"):
            prefix = self.folder / "prefix"
            run_in(self.folder, CMAKE, "--install", build, "--prefix", prefix)
            self.assertEqual([path.name for path in prefix.rglob("*") if path.is_file()], ["show"])
            self.assertIn("Total Tests: 0", run_in(build, CMAKE.replace("cmake", "ctest"), "-N"))
            self.assertEqual(list(build.rglob("libglint_hud*")), [])
        with self.subTest("options have Glint's name before them"):
            entries = re.findall(r"^([\w-]+):(?!INTERNAL|STATIC)\w+=", (build / "CMakeCache.txt").read_text(), re.M)
            asked = {"WAY"}
            self.assertEqual([name for name in entries if not OURS.fullmatch(name) and name not in asked], [])

    def test_by_fetch_content_from_a_local_path(self):
        self.assert_works(self.host("FetchContent"))


if __name__ == "__main__":
    unittest.main()
