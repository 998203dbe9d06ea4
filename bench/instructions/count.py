#!/usr/bin/env python3
"""bench/instructions/count.py BUILD...: the instructions that a ray takes, with each instruction set of some builds.

A count repeats to the last digit where a time does not, and needs no machine of that kind: callgrind counts what a PC
executes, QEMU's log what an ARM would. BUILD is a folder like build/release or build/aarch64, with the target
glint_render_frames built.
"""

import argparse
import re
import shutil
import struct
import subprocess
import sys
from collections import Counter
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = "bench/instructions/glint_render_frames"

X86_64, ARM, AARCH64 = 62, 40, 183  # e_machine of an ELF file
QEMU = {AARCH64: ("qemu-aarch64-static", "/usr/aarch64-linux-gnu"), ARM: ("qemu-arm-static", "/usr/arm-linux-gnueabihf")}
# Valgrind knows no AVX-512.
ISAS = {X86_64: ("scalar", "sse4", "avx2"), AARCH64: ("scalar", "neon"), ARM: ("scalar",)}


class CannotCount(Exception):
    pass


def machine_of(program):
    try:
        with open(program, "rb") as file:
            return struct.unpack_from("<H", file.read(20), 18)[0]
    except OSError as error:
        raise CannotCount(f"{error}; build the target glint_render_frames") from error


def start(*command):
    if not shutil.which(command[0]):
        raise CannotCount(f"there is no {command[0]}")
    return subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def rays_of(process, out, said):
    if process.wait() != 0:
        raise CannotCount(f"{' '.join(process.args)} ended with {process.returncode}:\n{said.decode(errors='replace')}")
    return int(out)


def callgrind(*command):
    """(the rays that the command prints, the instructions between the marks)"""
    process = start("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=glint_count",
                    *command)
    out, said = process.communicate()
    return rays_of(process, out, said), int(re.search(rb"Collected : (\d+)", said)[1])


class QemuLog:
    """QEMU's log has the instructions of each block once, when it is translated, and a line each time it runs:

    IN: main
    0x400010e4:  d2800000  mov      x0, #0
    Trace 0: 0x7f21380000c0 [0000000000000000/00000000400010e4/00000000/00000000] main
    """

    RUN = re.compile(rb"^Trace \S+ (\S+)", re.MULTILINE)
    MARKS = (b"glint_count\n", b"glint_count_ends\n")

    def __init__(self):
        self.length = {}  # of a block, by where its translation is
        self.translated = 0
        self.counts = False
        self.total = 0

    def read(self, stream):
        rest = b""
        while chunk := stream.read(1 << 20):
            text, end, rest = (rest + chunk).rpartition(b"\n")
            self.add(text + end)
        return rest

    def add(self, text):
        """Some lines. In most of a frame nothing is translated any more, and blocks of the same place are the same."""
        if b"IN:" in text or any(mark in text for mark in self.MARKS):
            for line in text.splitlines(keepends=True):
                self.add_line(line)
        elif self.counts:
            runs = Counter(self.RUN.findall(text))
            self.total += sum(self.length[block] * count for block, count in runs.items())

    def add_line(self, line):
        if line.startswith(b"Trace "):
            block = line.split(None, 3)[2]
            if self.translated:
                self.length[block], self.translated = self.translated, 0
            if line.endswith(self.MARKS):
                self.counts = line.endswith(b" " + self.MARKS[0])
            if self.counts:
                self.total += self.length[block]
        elif line.startswith(b"0x"):
            self.translated += 1
        elif line.startswith(b"IN:"):
            self.translated = 0


def qemu(emulator, libraries, *command):
    """The same."""
    process = start(emulator, "-L", libraries, "-d", "in_asm,exec,nochain", *command)
    log = QemuLog()
    said = log.read(process.stderr)
    return rays_of(process, process.stdout.read(), said), log.total


def count_frame(program, isa, scene, size_px, depth):
    """(rays, instructions) of a frame"""
    machine = machine_of(program)
    command = (program, isa, scene, size_px, depth)
    return callgrind(*command) if machine == X86_64 else qemu(*QEMU[machine], *command)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("builds", nargs="+", type=Path, metavar="BUILD")
    parser.add_argument("--scene", default=SOURCE / "scenes/sdl/cornell.sdl", type=Path)
    parser.add_argument("--size", default=128, type=int, metavar="PIXELS")
    parser.add_argument("--depth", default=2, type=int)
    parser.add_argument("--isa", action="append", help="only these; all that can be counted by default")
    options = parser.parse_args()
    print(f"{options.scene.stem}, {options.size} x {options.size}, depth {options.depth}\n")
    print("| build | instruction set | million instructions | rays | a ray |\n|---|---|---|---|---|")
    try:
        for build in options.builds:
            program = build / PROGRAM
            for isa in options.isa or ISAS[machine_of(program)]:
                rays, count = count_frame(program, isa, options.scene, options.size, options.depth)
                print(f"| {build.name} | {isa} | {count / 1e6:.2f} | {rays} | {count / rays:.1f} |", flush=True)
    except CannotCount as error:
        sys.exit(f"count.py: {error}")


if __name__ == "__main__":
    main()
