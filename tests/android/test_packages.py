"""What an app is made of: the AAR, with Prefab's modules for C++, and a signed APK of the sample.

The native code in them is for 64-bit ARM, but for Debian, not for Android: a placeholder of the right shape.
GLINT_AARCH64 names the folder it is built in, CMAKE the program; jvm.py has the rest.
"""

import json
import os
import shutil
import struct
import tempfile
import unittest
import zipfile
from pathlib import Path

import app
import jvm
import packages

MISSING = jvm.missing_packages()
if not shutil.which("aarch64-linux-gnu-g++"):
    MISSING.append("g++-aarch64-linux-gnu")

PAGE_BYTES = 16 * 1024
NATIVE = Path(os.environ["GLINT_AARCH64"])

CPP_CONSUMER = r"""
#include <glint/gles/presenter.hpp>
#include <glint/glint.hpp>
int main() {
    glint::SceneBuilder builder;
    const auto presenter = glint::gles::Presenter::create([](const char *) -> void * { return nullptr; });
    return builder.build().ok() || presenter.ok();
}
"""

JAVA_CONSUMER = """
import glint.android.*;
final class Consumer {
    static double seconds(java.io.File file, java.nio.ByteBuffer target) {
        try (GlintScene scene = GlintScene.fromFile(file); GlintRenderer renderer = new GlintRenderer(scene)) {
            return renderer.render(target, scene.getWidthPx(), scene.getHeightPx()).getSeconds();
        }
    }
}
"""


def load_segments(elf):
    """Alignment, address and place in the file of everything that a 64-bit ELF file has loaded."""
    assert elf[:6] == b"\x7fELF\x02\x01", elf[:6]
    (start,) = struct.unpack_from("<Q", elf, 32)
    size, count = struct.unpack_from("<HH", elf, 54)
    for number in range(count):
        kind, _, offset, address, _, _, _, alignment = struct.unpack_from("<IIQQQQQQ", elf, start + number * size)
        if kind == 1:
            yield alignment, address, offset


@unittest.skipIf(MISSING, f"these packages are not installed: {', '.join(MISSING)}")
class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        jvm.jars()
        app.compile_library()
        app.compile_sample()
        app.link_resources()
        cmake = os.environ["CMAKE"]
        jvm.run(cmake, "--preset", "aarch64", "-B", NATIVE, cwd=jvm.SOURCE, timeout=1200)
        jvm.run(cmake, "--build", NATIVE, "--parallel", os.cpu_count(), "--target", "glint_android", "glint_core",
                "glint_gles", timeout=1200)
        packages.assemble_aar(NATIVE)
        packages.assemble_apk(NATIVE)

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-android-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_the_native_library_is_for_pages_of_16_kib_and_shows_java_only(self):
        with zipfile.ZipFile(packages.AAR) as aar:
            elf = aar.read(f"jni/{packages.ABI}/libglint_android.so")
        segments = list(load_segments(elf))
        self.assertGreaterEqual(len(segments), 2)
        for alignment, address, offset in segments:
            self.assertEqual(alignment % PAGE_BYTES, 0, hex(alignment))
            self.assertEqual((address - offset) % PAGE_BYTES, 0)
        library = NATIVE / "platform/android/jni/libglint_android.so"
        shown = jvm.run("aarch64-linux-gnu-nm", "--dynamic", "--defined-only", library).split("\n")
        names = {line.split()[2] for line in shown if line}
        self.assertIn("Java_glint_android_GlintScene_nativeFromAssets", names)
        self.assertEqual({name for name in names if not name.startswith("Java_glint_android_")}, set())

    def test_every_native_method_has_its_function_and_the_other_way_round(self):
        library = NATIVE / "platform/android/jni/libglint_android.so"
        shown = jvm.run("aarch64-linux-gnu-nm", "--dynamic", "--defined-only", library)
        functions = {word[len("Java_"):] for word in shown.split() if word.startswith("Java_")}
        methods = set()
        with zipfile.ZipFile(app.LIBRARY_JAR) as jar:
            classes = [name[:-len(".class")] for name in jar.namelist() if name.endswith(".class")]
        for line in jvm.run(jvm.JDK / "bin/javap", "-p", "-cp", app.LIBRARY_JAR, *classes).split("\n"):
            if line.startswith(("public", "final", "class", "abstract")) and "{" in line:
                name = next(word for word in line.replace("{", " ").split() if word.startswith("glint.android."))
            elif " native " in line:
                methods.add(f"{name}.{line.split('(')[0].split()[-1]}".replace(".", "_"))
        self.assertEqual(methods, functions)

    def test_the_aar_has_what_an_aar_must_have(self):
        with zipfile.ZipFile(packages.AAR) as aar:
            self.assertIsNone(aar.testzip())
            names = set(aar.namelist())
            self.assertLessEqual({"AndroidManifest.xml", "classes.jar", "R.txt", "proguard.txt", "prefab/prefab.json",
                                  "jni/arm64-v8a/libglint_android.so"}, names)
            for module in packages.MODULES:
                folder = f"prefab/modules/{module}"
                library = json.loads(aar.read(f"{folder}/module.json"))["library_name"]
                self.assertLessEqual({f"{folder}/libs/android.arm64-v8a/abi.json",
                                      f"{folder}/libs/android.arm64-v8a/{library}.a"}, names)
            self.assertEqual(json.loads(aar.read("prefab/prefab.json"))["name"], "glint")

    def test_native_code_is_built_with_headers_from_one_folder_and_says_what_is_missing(self):
        headers = self.folder / "dependencies" / "include"
        headers.mkdir(parents=True)

        def configure():
            shutil.rmtree(self.folder / "build", ignore_errors=True)
            return jvm.run(os.environ["CMAKE"], "-S", jvm.SOURCE, "-B", self.folder / "build", "-DGLINT_BUILD_APPS=OFF",
                           "-DGLINT_BUILD_TESTS=OFF", "-DGLINT_BUILD_IMAGEIO=OFF", "-DGLINT_INSTALL=OFF",
                           f"-DGLINT_DEPENDENCIES={headers.parent}")

        for name in ("glm", "hwy", "fast_float", "tiny_obj_loader.h"):
            (headers / name).symlink_to(Path("/usr/include") / name)
        with self.assertRaisesRegex(AssertionError, r"lacks xxhash\.h: set\s+GLINT_DEPENDENCIES"):
            configure()
        (headers / "xxhash.h").symlink_to("/usr/include/xxhash.h")
        configure()
        used = (self.folder / "build/CMakeCache.txt").read_text()
        self.assertIn(f"GLINT_HIGHWAY_INCLUDE:PATH={headers}\n", used)

    def test_java_compiles_against_the_aars_classes(self):
        with zipfile.ZipFile(packages.AAR) as aar:
            aar.extract("classes.jar", self.folder)
        source = self.folder / "Consumer.java"
        source.write_text(JAVA_CONSUMER)
        jvm.compile_java(self.folder / "consumer.jar", [source],
                         [str(self.folder / "classes.jar"), jvm.android_jar(), jvm.jars_of("/kotlin-stdlib/")])

    def test_cpp_compiles_and_links_against_the_aars_modules(self):
        with zipfile.ZipFile(packages.AAR) as aar:
            aar.extractall(self.folder)
        source = self.folder / "consumer.cpp"
        source.write_text(CPP_CONSUMER)
        modules = [self.folder / "prefab/modules" / name for name in packages.MODULES]
        glm = next(folder for folder in (NATIVE / "lent-headers/include", Path("/usr/include"))
                   if (folder / "glm").exists())
        jvm.run("aarch64-linux-gnu-g++", "-std=c++20", source, "-o", self.folder / "consumer", f"-I{glm}",
                *(f"-I{module}/include" for module in modules),
                *(next(module.rglob("*.a")) for module in reversed(modules)), "-pthread")

    def test_the_apk_is_signed_aligned_and_what_the_manifest_says(self):
        said = jvm.run("apksigner", "verify", "--verbose", "--min-sdk-version", "24", packages.APK)
        self.assertIn("Verified using v2 scheme (APK Signature Scheme v2): true", said)
        self.assertIn("Verified using v3 scheme (APK Signature Scheme v3): true", said)
        jvm.run("zipalign", "-c", "-p", "4", packages.APK)
        badging = jvm.run("aapt2", "dump", "badging", packages.APK)
        self.assertIn("package: name='glint.sample' versionCode='1' versionName='0.1.0'", badging)
        self.assertIn("launchable-activity: name='glint.sample.RoomActivity'", badging)
        self.assertIn("native-code: 'arm64-v8a'", badging)
        with zipfile.ZipFile(packages.APK) as apk:
            scene = (jvm.SOURCE / "scenes/sdl/cornell.sdl").read_bytes()
            self.assertEqual(apk.read("assets/cornell.sdl"), scene)
            for word in scene.decode().split():
                if word.endswith(".obj"):
                    self.assertIn(f"assets/{word}", apk.namelist())
            native = apk.getinfo("lib/arm64-v8a/libglint_android.so")
            self.assertEqual(native.compress_type, zipfile.ZIP_STORED)

    def test_a_broken_apk_is_not_verified(self):
        broken = self.folder / "broken.apk"
        data = bytearray(packages.APK.read_bytes())
        data[len(data) // 3] ^= 1
        broken.write_bytes(data)
        with self.assertRaises(AssertionError):
            jvm.run("apksigner", "verify", "--min-sdk-version", "24", broken)

    def test_shrinking_leaves_what_the_native_library_finds_by_name(self):
        with zipfile.ZipFile(packages.APK) as apk:
            dex = b"".join(apk.read(name) for name in apk.namelist() if name.endswith(".dex"))
        for name in (b"Lglint/android/GlintScene;", b"nativeFromAssets", b"Lglint/android/GlintView;", b"nativeDraw",
                     b"Lglint/android/GlintException;", b"Lglint/sample/RoomActivity;"):
            self.assertIn(name, dex)
        # It did shrink: Kotlin's own library is 1.7 MB.
        self.assertLess(len(dex), 400_000)


if __name__ == "__main__":
    unittest.main()
