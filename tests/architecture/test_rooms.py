"""A room uses only rooms to its left, and the check of that sees what breaks it."""

import tempfile
import unittest
from pathlib import Path

import rooms


class TheHouse(unittest.TestCase):
    def test_every_include_keeps_the_rules(self):
        self.assertEqual(rooms.violations(), [])

    def test_the_files_of_every_room_are_read(self):
        read = rooms.sources(rooms.SOURCE)
        for room in rooms.USES:
            self.assertTrue(any(rooms.is_inside(path, room) for path in read), room)

    def test_rooms_use_only_rooms_that_are_listed_before_them(self):
        order = list(rooms.USES)
        for room, used in rooms.USES.items():
            for other in used:
                self.assertLess(order.index(other), order.index(room), f"{room} uses {other}")


class AMadeUpHouse(unittest.TestCase):
    """Small trees of files, each with one #include that is allowed or not."""

    FILES = (
        "core/include/glint/scene.hpp", "core/math/vec.hpp", "core/sdl/lexer.hpp", "core/render/renderer.cpp",
        "core/kernel/kernel.hpp", "platform/gles/gl.hpp", "platform/egl/include/glint/egl/surface.hpp", "bench/table.hpp",
        "bench/peers/peer.hpp",
    )

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-rooms-")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in self.FILES:
            self.write(name, "// nothing\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def check(self, file, include, complaint):
        """`file` with that one #include is complained about in these words, or not at all."""
        with self.subTest(file=file, include=include):
            self.write(file, f"// A file.\n#include {include}\n")
            found = rooms.violations(self.root)
            (self.root / file).unlink()
            if complaint is None:
                self.assertEqual(found, [])
            else:
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith(f"{file}:2: "), found)
                self.assertIn(complaint, found[0])

    def test_a_room_may_use_rooms_to_its_left_and_none_to_its_right(self):
        self.check("core/render/tiling.hpp", '"kernel/kernel.hpp"', None)
        self.check("core/kernel/packet.hpp", '"render/renderer.cpp"', "core/kernel may not use core/render")
        self.check("core/scene/scene.cpp", '"sdl/lexer.hpp"', "core/scene may not use core/sdl")
        self.check("core/math/box.hpp", '"vec.hpp"', None)
        self.check("core/math/box.hpp", '"../sdl/lexer.hpp"', "by name")
        self.check("core/math/box.hpp", '"kernel/gone.hpp"', "no such file")

    def test_platforms_and_programs_use_the_public_headers_only(self):
        self.check("platform/gles/presenter.cpp", "<glint/scene.hpp>", None)
        self.check("platform/gles/presenter.cpp", '"kernel/kernel.hpp"', "platform/gles may not use core/kernel")
        self.check("platform/gles/presenter.cpp", "<glint/egl/surface.hpp>", "platform/gles may not use platform/egl")
        self.check("platform/egl/context.cpp", '"gles/gl.hpp"', None)
        self.check("apps/glint/main.cpp", "<glint/egl/surface.hpp>", None)
        self.check("apps/glint/main.cpp", '"bench/table.hpp"', None)
        self.check("apps/glint/main.cpp", '"math/vec.hpp"', "apps/glint may not use core/math")
        self.check("bench/report.cpp", '"sdl/lexer.hpp"', "bench may not use core/sdl")
        self.check("core/scene/scene.cpp", "<glint/egl/surface.hpp>", "core/scene may not use platform/egl")

    def test_a_peer_is_a_room_inside_a_room(self):
        self.check("bench/peers/embree/device.cpp", "<embree3/rtcore.h>", None)
        self.check("bench/peers/embree/device.cpp", '"bench/peers/peer.hpp"', None)
        self.check("bench/peers/embree/device.cpp", '"bench/table.hpp"', "bench/peers/embree may not use bench")
        self.check("bench/table.cpp", '"bench/peers/peer.hpp"', None)
        self.check("bench/table.cpp", "<embree3/rtcore.h>", "is for bench/peers/embree")

    def test_public_headers_show_no_insides_and_no_other_libraries(self):
        public = "core/include/glint/renderer.hpp"
        self.check(public, "<glm/vec3.hpp>", None)
        self.check(public, "<vector>", None)
        self.check(public, '"math/vec.hpp"', "a public header")
        for library in ("<GLES3/gl3.h>", "<OpenImageIO/imageio.h>", "<immintrin.h>", "<hwy/highway.h>"):
            self.check(public, library, "is for")
        self.check(public, "<zlib.h>", "an unknown library")
        self.check(public, "<unistd.h>", "every system")

    def test_the_core_includes_neither_streams_to_print_on_nor_signals(self):
        self.check("core/text/words.cpp", "<iostream>", "prints nothing")
        self.check("core/text/words.cpp", "<csignal>", "prints nothing")
        self.check("core/text/words.cpp", "<string>", None)
        self.check("apps/glint/console.cpp", "<iostream>", None)

    def test_rooms_and_libraries_must_be_introduced(self):
        self.check("core/attic/box.hpp", "<vector>", "is not a room")
        self.check("core/math/pow.cpp", "<boost/math.hpp>", "an unknown library")


if __name__ == "__main__":
    unittest.main()
