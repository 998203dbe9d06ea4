"""The NEON kernel on an emulated 64-bit ARM."""

import unittest

from cross_test import CrossTest, missing_packages

MISSING = missing_packages({"aarch64-linux-gnu-g++": "g++-aarch64-linux-gnu",
                            "qemu-aarch64-static": "qemu-user-static"})


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class Neon(CrossTest, unittest.TestCase):
    preset = "aarch64"
    isa = "neon"
    runner = ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu"]


if __name__ == "__main__":
    unittest.main()
