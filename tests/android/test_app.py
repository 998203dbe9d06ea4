"""Kotlin and Java, compiled, and run on this machine with the native library: scenes, pictures and views.

GLINT_LIBRARIES names the folders of the native libraries; jvm.py has the rest.
"""

import os
import unittest

import app
import jvm

MISSING = jvm.missing_packages()


class Readme(unittest.TestCase):
    def test_its_first_snippet_is_the_example(self):
        snippet = (jvm.ANDROID / "README.md").read_text().split("```kotlin\n")[1].split("```")[0]
        example = (jvm.SOURCE / "examples/android/RoomActivity.kt").read_text()
        self.assertTrue(snippet.startswith("class RoomActivity"))
        self.assertTrue(example.endswith(snippet))


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class App(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        jvm.jars()
        app.compile_library()
        app.compile_sample()
        app.compile_tests()
        app.link_resources()

    def test_scenes_pictures_and_views_in_kotlin_and_java(self):
        out = app.run_tests(os.environ["GLINT_LIBRARIES"], "glint.test.SceneTest", "glint.test.RendererTest",
                            "glint.test.ViewTest", "glint.test.ConsumerTest")
        self.assertRegex(out, r"(?m)^OK \(\d+ tests\)$")
        self.assertNotRegex(out, r"(?m)^(WARNING|FATAL ERROR)\b.*(native method|JNI)")  # of -Xcheck:jni


if __name__ == "__main__":
    unittest.main()
