"""SIGINT and SIGTERM stop a render, leave no file behind, and end with exit code 130."""

import os
import pty
import select
import signal
import subprocess
import time
import unittest

from glint_process import TIMEOUT_S, WRITES_IMAGES, GlintTest


def rippled_square(rows):
    """2 * rows * rows triangles: enough for brute force to take longer than any test waits."""
    lines = [
        f"v {2 * x / rows - 1} {2 * y / rows - 1} {-3 - 0.1 * ((x * y) % 3)}"
        for y in range(rows + 1)
        for x in range(rows + 1)
    ]
    for y in range(rows):
        for x in range(rows):
            a = y * (rows + 1) + x + 1
            lines.append(f"f {a} {a + 1} {a + rows + 2} {a + rows + 1}")
    return "\n".join(lines) + "\n"


class Interrupt(GlintTest):
    def setUp(self):
        super().setUp()
        self.write("floor.obj", rippled_square(64))

    def start(self, *arguments, stderr=subprocess.PIPE):
        process = subprocess.Popen(
            self.command(*arguments),
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=stderr,
            text=True,
        )
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        if process.stderr:
            self.addCleanup(process.stderr.close)
        return process

    def long_render(self, **options):
        slow = ["--size", "4096x4096", "--accel", "brute"]
        return self.start("render", "room.sdl", *slow, *(["-o", "a.png"] if WRITES_IMAGES else ["--hash"]), **options)

    def test_a_signal_ends_a_render_with_130_and_no_file(self):
        before = self.names()
        for stop in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(stop):
                process = self.long_render()
                time.sleep(1.5)
                self.assertIsNone(process.poll(), "the render was over before it could be interrupted")
                process.send_signal(stop)
                out, err = process.communicate(timeout=TIMEOUT_S)
                self.assertEqual(process.returncode, 130, err)
                self.assertEqual(out, "")
                self.assertEqual(self.names(), before)

    def test_a_signal_ends_a_measurement_with_130(self):
        process = self.start("bench", "table", "--scene", "room.sdl", "--surface", "none", "--seconds", 3600)
        time.sleep(1.5)
        self.assertIsNone(process.poll(), "the measurement was over before it could be interrupted")
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=TIMEOUT_S)
        self.assertEqual(process.returncode, 130, err)

    def test_progress_is_shown_on_a_terminal(self):
        terminal, end = pty.openpty()
        process = self.long_render(stderr=end)
        os.close(end)
        shown, deadline = "", time.monotonic() + TIMEOUT_S
        while " %" not in shown and time.monotonic() < deadline:
            if select.select([terminal], [], [], 1)[0]:
                shown += os.read(terminal, 4096).decode()
        process.send_signal(signal.SIGINT)
        process.wait(timeout=TIMEOUT_S)
        os.close(terminal)
        self.assertRegex(shown, r"\r\[#*\.*\] +\d+ %")

    def test_progress_is_not_shown_in_a_pipe(self):
        process = self.long_render()
        time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=TIMEOUT_S)
        self.assertNotIn("%", err)


if __name__ == "__main__":
    unittest.main()
