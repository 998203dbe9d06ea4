"""The WebAssembly kernel in Node."""

import unittest

from cross_test import CrossTest, missing_packages

MISSING = missing_packages({"em++": "emscripten", "node": "nodejs"})


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class WebAssembly(CrossTest, unittest.TestCase):
    preset = "wasm"
    isa = "wasm"
    runner = ["node", "--no-experimental-fetch"]  # which Emscripten 3.1 would use to load files, in vain
    suffix = ".js"


if __name__ == "__main__":
    unittest.main()
