"""glint bench read: Glint beside tinyobjloader, as text and as JSON."""

import json
import unittest

from glint_process import GlintTest


class BenchRead(GlintTest):
    def test_reads_with_both(self):
        said = self.glint("bench", "read", "floor.obj", "--seconds", "0", "--json", "read.json").stdout
        self.assertIn("tinyobjloader", said)
        report = json.loads((self.folder / "read.json").read_text())
        self.assertEqual(report["glint_triangles"], 2)
        self.assertEqual(report["peer_triangles"], 2)
        self.assertEqual(report["rounds"], 3)
        self.assertEqual(report["bytes"], (self.folder / "floor.obj").stat().st_size)
        for who in ("glint_ms", "peer_ms"):
            self.assertGreater(report[who]["median"], 0)
            self.assertLessEqual(report[who]["min"], report[who]["median"])
        self.assertAlmostEqual(report["ratio"], report["glint_ms"]["median"] / report["peer_ms"]["median"])

    def test_refuses_what_cannot_be_read(self):
        self.write("bad.obj", "v 0 0 0\nf 1 2 3\n")
        self.refused("bench", "read", "bad.obj", expect=3, saying=["bad.obj:2"])
        self.refused("bench", "read", "none.obj", expect=3, saying=["none.obj"])
        self.refused("bench", "read", expect=2, saying=["MESH"])


if __name__ == "__main__":
    unittest.main()
