"""glint view in a real window of an X server that shows nothing (Xvfb): keys and the mouse, and what is on the screen.

Needs Xvfb, xdotool and ImageMagick's import; skipped by name without them.
"""

import os
import shutil
import subprocess
import time
import unittest

from glint_process import GlintTest, needs_images, read_ppm

TOOLS = ("Xvfb", "xdotool", "import")
PATIENCE_S = 60


def first_line(pipe):
    return pipe.readline().decode().strip()


@unittest.skipUnless(all(map(shutil.which, TOOLS)), f"one of {', '.join(TOOLS)} is not installed")
@needs_images
class Window(GlintTest):
    def setUp(self):
        super().setUp()
        server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp"],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        self.environment = {**os.environ, "DISPLAY": ":" + first_line(server.stdout), "SDL_VIDEODRIVER": "x11"}
        self.environment.pop("WAYLAND_DISPLAY", None)

    def view(self, *arguments):
        """Starts glint view without figures; waits for its window."""
        self.viewer = subprocess.Popen(self.command("view", "room.sdl", "--no-figures", *arguments), cwd=self.folder,
                                       env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.viewer.kill)
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Glint"], env=self.environment,
                                   capture_output=True, text=True)
            if found.stdout.strip():
                self.window = found.stdout.split()[0]
                return
            if self.viewer.poll() is not None:
                self.skipTest(f"no window could be opened: {self.viewer.communicate()[1]}")
            time.sleep(0.05)
        self.fail("no window came up")

    def do(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True, capture_output=True)

    def key(self, name):
        self.do("key", "--window", self.window, name)

    def on_screen(self):
        shot = subprocess.run(["import", "-window", self.window, "-depth", "8", "ppm:" + str(self.folder / "screen.ppm")],
                              env=self.environment, capture_output=True)
        return read_ppm(self.folder / "screen.ppm") if shot.returncode == 0 else None

    def wait_for(self, wanted, what):
        """Until the screen shows what `wanted` says of it."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            picture = self.on_screen()
            if picture and wanted(picture):
                return picture
            time.sleep(0.05)
        self.fail(f"the screen never showed {what}")

    def rendered(self, *arguments):
        self.glint("render", "room.sdl", "-o", "rendered.ppm", *arguments)
        return read_ppm(self.folder / "rendered.ppm")

    def end(self):
        # The window is gone before the key comes up again, about which xdotool complains.
        subprocess.run(["xdotool", "key", "--window", self.window, "Escape"], env=self.environment, capture_output=True)
        said = self.viewer.communicate(timeout=PATIENCE_S)
        self.assertEqual(self.viewer.returncode, 0, said)

    def test_shows_the_picture_to_the_byte(self):
        self.view("--size", "240x160")
        smooth = self.rendered("--size", "240x160", "--spp", "16")
        self.wait_for(lambda shown: shown == smooth, "the picture at rest")
        self.end()

    def test_answers_keys_and_the_mouse(self):
        self.view("--size", "240x160")
        smooth = self.rendered("--size", "240x160", "--spp", "16")
        self.wait_for(lambda shown: shown == smooth, "the picture at rest")

        self.key("0")
        flat = self.rendered("--size", "240x160", "--spp", "16", "--depth", "0")
        self.assertNotEqual(flat, smooth)
        self.wait_for(lambda shown: shown == flat, "depth 0")
        self.key("2")
        self.wait_for(lambda shown: shown == smooth, "depth 2 again")

        self.key("Tab")
        self.wait_for(lambda shown: shown != smooth, "the figures")
        self.key("Tab")
        self.wait_for(lambda shown: shown == smooth, "the picture without them")

        for drag in (("1", 60, 80, 100, 90), ("3", 60, 80, 80, 100)):
            button, x0, y0, x1, y1 = drag
            self.do("mousemove", "--window", self.window, x0, y0, "mousedown", button)
            self.do("mousemove", "--window", self.window, x1, y1, "mouseup", button)
            self.wait_for(lambda shown: shown != smooth, f"another place after dragging with button {button}")
            self.key("r")
            self.wait_for(lambda shown: shown == smooth, "the first place again")
        self.do("mousemove", "--window", self.window, 50, 50, "click", "4")
        self.wait_for(lambda shown: shown != smooth, "the room from nearby after a turn of the wheel")
        self.key("r")
        self.wait_for(lambda shown: shown == smooth, "the first place again")

        self.key("p")
        end = time.monotonic() + PATIENCE_S
        while not (self.folder / "glint-0001.png").exists() and time.monotonic() < end:
            time.sleep(0.05)
        self.end()
        self.assertTrue((self.folder / "glint-0001.png").exists())

    def test_takes_another_size(self):
        self.view("--size", "240x160")
        self.do("windowsize", self.window, 300, 200)
        larger = self.rendered("--size", "300x200", "--spp", "16")
        self.wait_for(lambda shown: shown == larger, "the picture in the window's new size")
        self.end()


if __name__ == "__main__":
    unittest.main()
