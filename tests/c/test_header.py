"""<glint/glint.h> compiles as C11 and as C++, strictly, with every compiler that is here."""

import shutil
import subprocess
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wundef", "-Werror"]
C = ["-xc", "-std=c11", "-Wstrict-prototypes", "-Wmissing-prototypes", "-Wc++-compat"]
# -Wpadded: bytes between members would become members of a later version, and hold what happened to be there.
PADDED = ["-Wpadded"]
LANGUAGES = {
    "C11": [*C, *PADDED],
    "C17": ["-xc", "-std=c17", "-Wstrict-prototypes"],
    "C++11": ["-xc++", "-std=c++11", *PADDED],
    "C++20": ["-xc++", "-std=c++20"],
}
COMPILERS = [name for name in ("gcc", "clang", "clang-16", "aarch64-linux-gnu-gcc") if shutil.which(name)]


class Header(unittest.TestCase):
    def test_it_compiles_alone_and_twice(self):
        if not COMPILERS:
            self.skipTest("neither gcc nor clang is installed")
        for compiler in COMPILERS:
            for language, flags in LANGUAGES.items():
                with self.subTest(compiler=compiler, language=language):
                    done = subprocess.run(
                        [compiler, *flags, *WARNINGS, "-fsyntax-only", f"-I{SOURCE / 'core/include'}", "-"],
                        input="#include <glint/glint.h>\n#include <glint/glint.h>\n",
                        text=True, capture_output=True)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
