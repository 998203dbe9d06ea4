"""glint view without a window: scripts, screenshots, recordings, reports, and what it refuses."""

import json
import signal
import subprocess
import time
import unittest

from glint_process import GlintTest, needs_images, read_ppm

OFFSCREEN = ("--surface", "offscreen", "--no-figures")


class View(GlintTest):
    def setUp(self):
        super().setUp()
        found = subprocess.run(self.command("view", "room.sdl", *OFFSCREEN, "--frames", "1"), cwd=self.folder,
                               stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if found.returncode == 1 and "install" in found.stderr:
            self.skipTest(f"this machine has no off-screen surface: {found.stderr}")

    def picture(self, name, *arguments):
        self.glint("render", "room.sdl", "-o", name, *arguments)
        return read_ppm(self.folder / name)

    @needs_images
    def test_the_first_frame_is_the_picture_that_render_makes(self):
        for options in ([], ["--depth", "0"], ["--size", "33x20"], ["--transfer", "srgb"], ["--threads", "1"],
                        ["--isa", "scalar"], ["--accel", "brute"]):
            with self.subTest(options=options):
                self.glint("view", "room.sdl", *OFFSCREEN, "--frames", "1", "--screenshot", "shown.ppm", *options)
                if "--size" in options:
                    # A window of another shape shows more at the sides; render stretches.
                    self.assertEqual(read_ppm(self.folder / "shown.ppm")[:2], (33, 20))
                else:
                    self.assertEqual(read_ppm(self.folder / "shown.ppm"), self.picture("rendered.ppm", *options))

    @needs_images
    def test_at_rest_the_picture_gets_as_smooth_as_sixteen_samples(self):
        self.glint("view", "room.sdl", *OFFSCREEN, "--screenshot", "shown.ppm")
        self.assertEqual(read_ppm(self.folder / "shown.ppm"), self.picture("rendered.ppm", "--spp", "16"))

    @needs_images
    def test_a_script_moves_and_a_recording_repeats(self):
        self.write("walk.txt", "0 drag left 10 10 30 12 0.1\n0.1 key w down\n0.15 key w up\n0.2 close\n")
        pictures = []
        for folder in ("one", "two"):
            self.glint("view", "room.sdl", *OFFSCREEN, "--script", "walk.txt", "--record", folder, "--fps", "50")
            names = sorted(path.name for path in (self.folder / folder).iterdir())
            self.assertEqual(names[0], "frame.0000.png")
            self.assertEqual(len(names), 11)  # a fifth of a second, and the frame it begins with
            pictures.append([(self.folder / folder / name).read_bytes() for name in names])
        self.assertEqual(pictures[0], pictures[1])
        self.assertGreater(len(set(pictures[0])), 5)

    def test_a_lost_context_is_no_loss(self):
        self.write("walk.txt", "".join(f"{i / 100} lose-context\n" for i in range(20)))
        self.glint("view", "room.sdl", *OFFSCREEN, "--script", "walk.txt")

    def test_reports_every_frame(self):
        self.write("walk.txt", "0 key d down\n0.3 close\n")
        said = self.glint("view", "room.sdl", *OFFSCREEN, "--script", "walk.txt", "--stats", "--json", "times.json")
        self.assertIn("input to picture", said.stdout)
        report = json.loads((self.folder / "times.json").read_text())
        self.assertEqual(report["scene"], "room.sdl")
        self.assertGreater(len(report["frames"]), 0)
        for frame in report["frames"]:
            self.assertGreater(frame["render_ms"], 0)
            self.assertLessEqual(frame["scale"], 1)
            self.assertGreaterEqual(frame["scale"], 0.25)
        times = [frame["shown_ms"] for frame in report["frames"]]
        self.assertEqual(times, sorted(times))

    def test_ends_when_it_is_interrupted(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                self.write("walk.txt", "600 close\n")
                running = subprocess.Popen(self.command("view", "room.sdl", *OFFSCREEN, "--script", "walk.txt"),
                                           cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                           stderr=subprocess.PIPE)
                time.sleep(0.5)
                running.send_signal(number)
                running.communicate(timeout=60)
                self.assertEqual(running.returncode, 130)

    def test_refuses_what_makes_no_sense(self):
        self.write("bad.txt", "0 key w\nsoon close\n")
        view = ("view", "room.sdl", *OFFSCREEN)
        self.refused(*view, "--fps", "0", expect=2, saying=["--fps", "1 to 1000"])
        self.refused(*view, "--fps", "fast", expect=2, saying=["--fps"])
        self.refused(*view, "--frames", "0", expect=2, saying=["--frames"])
        self.refused("view", "room.sdl", "--surface", "moon", expect=2, saying=["window|offscreen"])
        self.refused(*view, "--script", "bad.txt", expect=3,
                     saying=["bad.txt:2:1", "'soon' is not a time in seconds"])
        self.refused(*view, "--script", "none.txt", expect=3, saying=["none.txt", "no such file"])
        self.refused(*view, "--record", "room.sdl", expect=1, saying=["--record", "room.sdl"])
        self.refused(*view, "--size", "20000x20000", expect=2, saying=["--max-pixels"])
        self.refused("view", "none.sdl", *OFFSCREEN, expect=3, saying=["none.sdl"])

    @needs_images
    def test_refuses_a_screenshot_before_the_work(self):
        self.refused("view", "room.sdl", *OFFSCREEN, "--screenshot", "shot.xyz", expect=2, saying=["xyz"])
        self.refused("view", "room.sdl", *OFFSCREEN, "--screenshot", "no/such/shot.png", expect=1, saying=["no/such"])

    def test_without_a_display_says_how_to_go_on(self):
        done = subprocess.run(self.command("view", "room.sdl", "--frames", "1"), cwd=self.folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60,
                              env={"PATH": "/nowhere", "SDL_VIDEODRIVER": "x11"})
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("--surface offscreen", done.stderr)


if __name__ == "__main__":
    unittest.main()
