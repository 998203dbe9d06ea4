"""The shared library: what it links, how large it is, what it shows, what it asks of the system, what it keeps.

GLINT_LIBRARY names libglint.so, GLINT_STRIP the strip program of its compiler.
"""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

LIBRARY = os.environ["GLINT_LIBRARY"]
STRIP = os.environ["GLINT_STRIP"]

# The C++ runtime, libm and threads; where libc has no threads of its own they are libpthread's.
MAY_LINK = re.compile(r"(libstdc\+\+|libc\+\+|libm|libgcc_s|libc|libpthread|ld-linux[-\w]*)\.so(\.\d+)?")
# By machine, as readelf names it; the first has four instruction sets.
MAX_STRIPPED_BYTES = {"Advanced Micro Devices X86-64": 1_500_000, "AArch64": 900_000}

# C's functions in one version, C++'s in another, and the versions themselves.
MAY_SHOW = re.compile(r"((typeinfo|typeinfo name|vtable) for )?glint::.*@GLINT_CXX_0|glint_\w+@@GLINT_0|GLINT_(CXX_)?0")

# printf() and its like, and what ends a process or catches its signals; a guest's library does not even import them.
NOT_FOR_GUESTS = re.compile(
    r"_*(v?f?w?printf|dprintf|puts|fputs|putchar|putc|fputc|fwrite|perror|stdout|stderr)(_chk)?"
    r"|_?_?exit|_Exit|quick_exit|abort|atexit|signal|sigaction|raise|kill|setlocale|setenv|putenv"
    r"|_ZSt4c(out|err|log)|_ZNSt8ios_base4Init.*"
)

# Where variables live that may change, and what the compiler and the C++ library put there.
WRITABLE = {".data", ".bss"}
# __cpu_model and its like are what its runtime knows of the processor, written once when the library is loaded. fast_float has a number
# there that nothing writes: it is volatile, so that rounding is found out at run time.
NOT_OURS = re.compile(r"DW\.ref\..*|_ZZN10fast_float6detail17rounds_to_nearestEvE4fmin|__cpu_model|__cpu_features2?|__aarch64_have_lse_atomics|__dso_handle|__TMC_END__|completed\.\d+|_ZZ?NK?St.*|_ZZ?N9__gnu_cxx.*")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(*options):
    """The rows of nm in its System V form: name, value, class, type, size, line and section."""
    rows = (line.split("|") for line in output("nm", "--format=sysv", *options, LIBRARY).splitlines())
    return [[field.strip() for field in row] for row in rows if len(row) == 7 and row[0].strip() != "Name"]


class Library(unittest.TestCase):
    def test_it_links_nothing_beyond_the_runtime_libm_and_threads(self):
        needed = re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "--wide", "--dynamic", LIBRARY))
        self.assertIn("libc.so.6", needed)
        self.assertEqual([name for name in needed if not MAY_LINK.fullmatch(name)], [])

    def test_stripped_it_is_small(self):
        with tempfile.TemporaryDirectory(prefix="glint-strip-") as folder:
            copy = Path(folder) / "libglint.so"
            shutil.copyfile(LIBRARY, copy)
            subprocess.run([STRIP, copy], check=True)
            machine = re.search(r"Machine: +(.*)", output("readelf", "--file-header", LIBRARY))[1]
            self.assertLessEqual(copy.stat().st_size, MAX_STRIPPED_BYTES[machine])

    def test_it_shows_the_names_of_glint_and_no_others(self):
        shown = [row[0] for row in symbols("--dynamic", "--defined-only", "--demangle")]
        self.assertTrue(any(name.startswith("glint::Renderer::render(") for name in shown), shown)
        self.assertEqual([name for name in shown if not MAY_SHOW.fullmatch(name)], [])

    def test_it_imports_nothing_that_prints_ends_the_process_or_catches_signals(self):
        imported = [row[0].split("@")[0] for row in symbols("--dynamic", "--undefined-only")]
        self.assertIn("memcpy", imported)
        self.assertEqual([name for name in imported if NOT_FOR_GUESTS.fullmatch(name)], [])

    def test_it_owns_no_global_variables(self):
        kept = [row[0] for row in symbols() if row[3] in ("OBJECT", "UNIQUE") and row[6] in WRITABLE]
        self.assertIn("__dso_handle", kept) # the compiler's, in every library: .data was read
        self.assertEqual([name for name in kept if not NOT_OURS.fullmatch(name)], [])


if __name__ == "__main__":
    unittest.main()
