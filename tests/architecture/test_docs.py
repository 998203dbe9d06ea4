"""The site of the public interface is made without a warning, and every public type says what it is for.

GLINT_DOXYFILE is what Doxygen is configured with.
"""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2] # where the README's links begin
DOXYFILE = Path(os.environ["GLINT_DOXYFILE"])
# What speaks for itself needs no words: a function, a field. A type, that is several of them, does.
UNDOCUMENTED_TYPE = re.compile(r".*: Compound .* is not documented\.")


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is not installed")
class Docs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-docs-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def doxygen(self, *settings):
        """Its exit code and its warnings."""
        text = "\n".join([DOXYFILE.read_text(), f'OUTPUT_DIRECTORY = "{self.folder}"', *settings])
        done = subprocess.run(["doxygen", "-"], cwd=SOURCE, input=text, capture_output=True, text=True, timeout=300)
        return done.returncode, done.stderr.splitlines()

    def test_the_site_is_made_without_warnings(self):
        self.assertEqual(self.doxygen(), (0, []))
        pages = {page.name for page in (self.folder / "html").glob("*.html")}
        self.assertLessEqual({"index.html", "classglint_1_1Renderer.html", "classglint_1_1gles_1_1Presenter.html",
                              "structglint_1_1egl_1_1Survey.html"}, pages)

    def test_every_public_type_says_what_it_is_for(self):
        _, warnings = self.doxygen("EXTRACT_ALL = NO", "WARN_IF_UNDOCUMENTED = YES")
        self.assertTrue(any(" is not documented." in line for line in warnings)) # it was asked
        self.assertEqual([line for line in warnings if UNDOCUMENTED_TYPE.fullmatch(line)], [])


if __name__ == "__main__":
    unittest.main()
