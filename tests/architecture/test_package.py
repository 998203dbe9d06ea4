"""What `cmake --install` puts down is enough: for another project's find_package(glint), and for the program itself.

GLINT_BUILD names the build folder and GLINT_BUILD_TYPE its build type; CMAKE, CXX and CMAKE_GENERATOR are what it uses.
"""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

CMAKE = os.environ["CMAKE"]
CONSUMER = Path(__file__).resolve().parent / "consumer"
SOURCE = CONSUMER.parents[2]
TIMEOUT_S = 300


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="glint-package-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        # Not where the build was told to install: the package must work wherever it is put.
        cls.prefix = cls.folder / "somewhere else"
        cls.run_in(cls.folder, CMAKE, "--install", os.environ["GLINT_BUILD"], "--prefix", cls.prefix)

    @classmethod
    def run_in(cls, folder, *command):
        """What the command printed; it must succeed."""
        done = subprocess.run(list(map(str, command)), cwd=folder, stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT_S)
        if done.returncode != 0:
            raise AssertionError(f"{done.args} ended with {done.returncode}\n{done.stdout}")
        return done.stdout

    def test_another_project_finds_links_and_uses_it(self):
        build = self.folder / "consumer"
        configured = self.run_in(self.folder, CMAKE, "-S", CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
                                 f"-DCMAKE_BUILD_TYPE={os.environ['GLINT_BUILD_TYPE']}",
                                 f"-DGLINT_README={SOURCE / 'README.md'}")
        self.run_in(self.folder, CMAKE, "--build", build, "--parallel", "2")

        with_core = self.run_in(self.folder, build / "render_with_core")
        self.assertRegex(with_core, r"^\d+\.\d+\.\d+ [0-9a-f]{16}\n$")
        self.assertEqual(self.run_in(self.folder, build / "render_with_shared"), with_core)
        self.run_in(self.folder, build / "show")
        # The README's program renders a scene of ours, named from the top of the source tree.
        self.assertRegex(self.run_in(SOURCE, build / "readme"), r"^[0-9a-f]{16}\n$")
        # The header's version and the project's are one.
        self.assertIn(f"package version: {with_core.split()[0]}\n", configured)

    def test_every_public_header_is_installed_and_no_other(self):
        public = [SOURCE / "core/include", *SOURCE.glob("platform/*/include")]
        wanted = {path.relative_to(top) for top in public for path in top.rglob("*.h*")}
        installed = {path.relative_to(self.prefix / "include") for path in (self.prefix / "include").rglob("*")
                     if path.is_file()}
        self.assertEqual(installed, wanted)

    def test_the_package_names_neither_the_build_folder_nor_the_sources(self):
        files = list(self.prefix.rglob("*.cmake"))
        self.assertGreaterEqual(len(files), 3)
        for file in files:
            for folder in (os.environ["GLINT_BUILD"], str(SOURCE)):
                self.assertNotIn(folder, file.read_text(), file)

    def test_the_installed_program_finds_its_image_module_and_every_mesh_of_its_scenes(self):
        glint = self.prefix / "bin" / "glint"
        if not glint.exists():
            self.skipTest("a build without the command line")
        scenes = sorted((self.prefix / "share/glint/scenes").glob("*.sdl"))
        self.assertIn("cornell.sdl", [scene.name for scene in scenes])
        for scene in scenes:
            self.run_in(self.folder, glint, "info", scene)
        if list(self.prefix.rglob("glint_imageio_oiio.so")):
            self.run_in(self.folder, glint, "render", scenes[0], "--size", "32x32", "-o", "room.png")
            self.assertEqual((self.folder / "room.png").read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
