"""The C++ examples, each built as a project of its own with an installed Glint, and run: their pictures are glint's."""

import re
import shlex
import subprocess
import unittest

from package import BUILD, BUILD_TYPE, CMAKE, CXX, HERE, SOURCE, PackageTest, run_in

EXAMPLES = SOURCE / "examples"


def colours(file):
    """Width, height and the red, green and blue bytes of a PPM or PAM file."""
    data = file.read_bytes()
    if data.startswith(b"P7"):
        header, _, pixels = data.partition(b"ENDHDR\n")
        width, height = (int(number) for number in re.findall(rb"(?:WIDTH|HEIGHT) (\d+)", header))
        rows = [pixels[channel::4] for channel in range(3)]
    else:
        width, height, pixels = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s(.*)", data, re.S).groups()
        width, height = int(width), int(height)
        rows = [pixels[channel::3] for channel in range(3)]
    return width, height, rows


@unittest.skipUnless((BUILD / "glint").exists() and (BUILD / "glint_imageio_oiio.so").exists(),
                     "a build without the command line or image files")
class Examples(PackageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.install()
        cls.scene = cls.prefix / "share/glint/scenes/cornell.sdl"
        cls.build = cls.folder / "build"
        run_in(cls.folder, CMAKE, "-S", EXAMPLES, "-B", cls.build, f"-DCMAKE_PREFIX_PATH={cls.prefix}",
               f"-DCMAKE_CXX_COMPILER={CXX}", f"-DCMAKE_BUILD_TYPE={BUILD_TYPE}", "-DCMAKE_CXX_FLAGS=-Wall -Wextra")
        said = run_in(cls.folder, CMAKE, "--build", cls.build, "--parallel", "2")
        if "warning:" in said:
            raise AssertionError(said)

    def run_example(self, name, *arguments, **environment):
        return run_in(self.folder, self.build / name / name, *arguments, **environment)

    def reference(self, name, *options):
        """What `glint render` makes of the scene."""
        run_in(self.folder, self.prefix / "bin/glint", "render", self.scene, "-o", name, *options)
        return self.folder / name

    def assert_is_a_picture(self, rows):
        self.assertGreater(len(set(zip(*rows))), 100, "too few colours to be a picture")

    def test_hello(self):
        self.assertLessEqual(len((EXAMPLES / "hello/hello.cpp").read_text().splitlines()), 15)
        self.run_example("hello", self.scene, "hello.png")
        self.assertEqual((self.folder / "hello.png").read_bytes(),
                         self.reference("reference.png", "--size", "512x512").read_bytes())

    def test_hello_says_what_is_wrong(self):
        done = subprocess.run([self.build / "hello/hello", "missing.sdl", "a.png"], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("missing.sdl", done.stdout)

    def test_present(self):
        self.assertLessEqual(len((EXAMPLES / "present/present.cpp").read_text().splitlines()), 40)
        spy = self.folder / "window_spy.so"
        flags = shlex.split(run_in(self.folder, "pkg-config", "--cflags", "sdl2"))
        run_in(self.folder, CXX, "-shared", "-fPIC", HERE / "window_spy.cpp", "-o", spy, *flags)
        self.run_example("present", self.scene, LD_PRELOAD=str(spy), SDL_VIDEODRIVER="offscreen")
        first, dragged = colours(self.folder / "shown.0.pam"), colours(self.folder / "shown.1.pam")
        self.assertEqual(first, colours(self.reference("present.ppm", "--size", "512x512")))
        self.assert_is_a_picture(dragged[2])
        self.assertNotEqual(first, dragged)

    def test_texture(self):
        self.run_example("texture", self.scene, "texture.pam")
        self.assertEqual(colours(self.folder / "texture.pam"),
                         colours(self.reference("texture.ppm", "--size", "320x240")))

    def test_edit(self):
        self.run_example("edit", 5)
        pictures = [(self.folder / f"edit.{frame}.png").read_bytes() for frame in range(5)]
        self.assertEqual(len(set(pictures)), 5)
        self.assertEqual({picture[:4] for picture in pictures}, {b"\x89PNG"})

    def test_threads(self):
        self.run_example("threads", self.scene, "threads.png")
        self.assertEqual((self.folder / "threads.png").read_bytes(),
                         self.reference("reference.png", "--size", "512x512").read_bytes())

    def test_every_example_is_tested(self):
        examples = {folder.parent.name for folder in EXAMPLES.glob("*/CMakeLists.txt")
                    if list(folder.parent.glob("*.cpp"))}
        self.assertEqual({f"test_{name}" for name in examples} - set(dir(self)), set())


if __name__ == "__main__":
    unittest.main()
