"""What `cmake --install` puts down is enough: for another project's find_package(glint), and for the program itself."""

import subprocess
import unittest

from package import BUILD, BUILD_TYPE, CMAKE, CONSUMER, SOURCE, PackageTest, run_in


class FindPackage(PackageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.install()

    def configure(self, build, components):
        return [CMAKE, "-S", CONSUMER, "-B", build, "-DWAY=find_package", f"-DCOMPONENTS={components}",
                f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_BUILD_TYPE={BUILD_TYPE}"]

    def test_another_project_finds_links_and_uses_it(self):
        build = self.folder / "consumer"
        configured = run_in(self.folder, *self.configure(build, "core;shared;imageio;gles;egl;osmesa"))
        run_in(self.folder, CMAKE, "--build", build, "--parallel", "2")

        version = self.assert_renders_alike([build / "render_with_core", build / "render_with_shared"])
        self.assertIn(f"package version: {version}\n", configured) # the header's version and the project's are one
        for name, owns in [("render_with_core", True), ("render_with_shared", False), ("show", True),
                           ("show_with_shared", False)]:
            self.assert_owns(build / name, owns)
        self.assert_shows(build / "show")
        self.assert_shows(build / "show_with_shared")

    def test_a_component_that_is_not_there_is_named_beside_those_that_are(self):
        command = self.configure(self.folder / "refused", "core;vulkan")
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("installed without vulkan; it has: core, shared, imageio, gles, egl, osmesa",
                      " ".join(done.stderr.split()))

    def test_every_public_header_is_installed_and_no_other(self):
        public = [SOURCE / "core/include", *SOURCE.glob("platform/*/include")]
        wanted = {path.relative_to(top) for top in public for path in top.rglob("*.h*")}
        installed = {path.relative_to(self.prefix / "include") for path in (self.prefix / "include").rglob("*")
                     if path.is_file()}
        self.assertEqual(installed, wanted)

    def test_the_package_names_neither_the_build_folder_nor_the_sources(self):
        files = [*self.prefix.rglob("*.cmake"), *self.prefix.rglob("*.pc")]
        self.assertGreaterEqual(len(files), 9)
        for file in files:
            for folder in (str(BUILD), str(SOURCE)):
                self.assertNotIn(folder, file.read_text(), file)

    def test_the_installed_program_finds_its_image_module_and_every_mesh_of_its_scenes(self):
        glint = self.prefix / "bin" / "glint"
        if not glint.exists():
            self.skipTest("a build without the command line")
        scenes = sorted((self.prefix / "share/glint/scenes").glob("*.sdl"))
        self.assertIn("cornell.sdl", [scene.name for scene in scenes])
        for scene in scenes:
            run_in(self.folder, glint, "info", scene)
        if list(self.prefix.rglob("glint_imageio_oiio.so")):
            run_in(self.folder, glint, "render", scenes[0], "--size", "32x32", "-o", "room.png")
            self.assertEqual((self.folder / "room.png").read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
