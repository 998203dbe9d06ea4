"""The scalar kernel on an emulated 32-bit ARM, which has no other: its NEON has neither doubles nor exact division."""

import unittest

from cross_test import CrossTest, missing_packages

MISSING = missing_packages({"arm-linux-gnueabihf-g++": "g++-arm-linux-gnueabihf",
                            "qemu-arm-static": "qemu-user-static"})


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class ArmV7(CrossTest, unittest.TestCase):
    preset = "armv7"
    isa = "scalar"
    runner = ["qemu-arm-static", "-L", "/usr/arm-linux-gnueabihf"]
    scenes = ("cornell", "carousel")


if __name__ == "__main__":
    unittest.main()
