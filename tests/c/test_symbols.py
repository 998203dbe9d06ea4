"""The functions of abi.c are those that the library shows, in the version that programs ask for.

GLINT_LIBRARY names libglint.so.
"""

import os
import re
import subprocess
import unittest
from pathlib import Path

NODE = "GLINT_0"


def promised():
    """The functions that abi.c names."""
    return set(re.findall(r"^FUNCTION\((\w+),", (Path(__file__).parent / "abi.c").read_text(), re.MULTILINE))


def shown():
    """C function -> node of the version script, of what the library defines for others."""
    rows = subprocess.run(["nm", "--dynamic", "--defined-only", "--format=posix", os.environ["GLINT_LIBRARY"]],
                          check=True, capture_output=True, text=True).stdout.split("\n")
    names = (row.split()[0].partition("@") for row in rows if row.startswith("glint_"))
    return {name: node.lstrip("@") for name, _, node in names}


class Symbols(unittest.TestCase):
    def test_no_function_is_gone(self):
        self.assertGreater(len(promised()), 70)
        self.assertEqual(promised() - set(shown()), set(), "programs call them: they must stay")

    def test_no_function_is_new_without_a_promise(self):
        self.assertEqual(set(shown()) - promised(), set(), "write their types into abi.c: from then on they stay")

    def test_every_function_has_its_version(self):
        self.assertEqual({name for name, node in shown().items() if node != NODE}, set())


if __name__ == "__main__":
    unittest.main()
