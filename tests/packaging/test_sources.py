"""What the sources say in several places is the same in all of them: the README's programs, and the version."""

import re
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
LANGUAGES = {"c", "cmake", "cpp", "java", "kotlin", "python"}

# Where else the version stands, and how.
VERSIONS = {
    "packaging/debian/changelog": r"glint \((.*)-\d+\)",
    "packaging/vcpkg/ports/glint/vcpkg.json": r'"version": "(.*)"',
    "packaging/conan/conanfile.py": r'version = "(.*)"',
}


class Sources(unittest.TestCase):
    def test_every_program_in_the_readme_is_an_example(self):
        blocks = re.findall(r"^```(\w+)\n(.*?)^```$", (SOURCE / "README.md").read_text(), re.M | re.S)
        programs = [(language, text) for language, text in blocks if language in LANGUAGES]
        self.assertGreaterEqual({language for language, _ in programs}, {"cpp", "cmake"})
        examples = {path.read_text() for path in (SOURCE / "examples").rglob("*")
                    if path.suffix in (".c", ".cpp", ".java", ".kt", ".py", ".txt")}
        for language, text in programs:
            with self.subTest(language):
                self.assertIn(text, examples)

    def test_there_is_one_version(self):
        version = re.search(r"project\(glint VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        for file, pattern in VERSIONS.items():
            with self.subTest(file):
                self.assertEqual(re.search(pattern, (SOURCE / file).read_text())[1], version)


if __name__ == "__main__":
    unittest.main()
