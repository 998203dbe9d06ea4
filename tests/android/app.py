"""The library, the sample, the example and the tests, compiled; and the sample's resources."""

import shutil

import jvm
from jvm import ANDROID, BUILD, HERE, JDK, SOURCE

LIBRARY_JAR = BUILD / "library.jar"
SAMPLE_JAR = BUILD / "sample.jar"
TESTS_JAR = BUILD / "tests.jar"
JAVA_TESTS_JAR = BUILD / "java_tests.jar"
ASSETS = BUILD / "assets"
MANIFEST = BUILD / "AndroidManifest.xml"
RESOURCES = BUILD / "resources.apk"
KEEP_RULES = BUILD / "keep.pro"


def kotlin_in(folder):
    return sorted(folder.rglob("*.kt"))


def compile_library():
    jvm.compile_kotlin(LIBRARY_JAR, kotlin_in(ANDROID / "library/src/main"),
                       [jvm.android_jar(), jvm.jars_of("/kotlin-stdlib/")], "-Xexplicit-api=strict")


def compile_sample():
    jvm.compile_kotlin(SAMPLE_JAR, kotlin_in(ANDROID / "sample/src/main") + kotlin_in(SOURCE / "examples/android"),
                       [jvm.android_jar(), str(LIBRARY_JAR), jvm.jars_of("/kotlin-stdlib/")])


def classpath_of_tests():
    """With what tests are compiled and run, but Android itself."""
    return [str(LIBRARY_JAR), str(SAMPLE_JAR), monitor(),
            jvm.jars_of("/kotlin-stdlib/", "/robolectric/", "/junit/", "/hamcrest", "/guava/", "/asm", "/icu4j/",
                        "/javax", "/conscrypt", "/bcprov", "/failureaccess/", "/snakeyaml/", "/auto/value",
                        "/test-parameter-injector/", "/sqlite4java/", "/errorprone/", "/jspecify/")]


def monitor():
    """The classes of androidx.test:monitor, an AAR, which Maven does not take classes from."""
    folder = BUILD / "monitor"
    aar = next(jar for jar in jvm.jars() if jar.suffix == ".aar" and "monitor" in jar.name)
    if not (folder / "classes.jar").exists():
        shutil.unpack_archive(aar, folder, "zip")
    return str(folder / "classes.jar")


def compile_tests():
    classpath = [jvm.android_jar(), *classpath_of_tests()]
    jvm.compile_kotlin(TESTS_JAR, kotlin_in(HERE / "kotlin"), classpath)
    jvm.compile_java(JAVA_TESTS_JAR, sorted((HERE / "java").glob("*.java")), [str(TESTS_JAR), *classpath])


def with_package(manifest, package, target):
    """A manifest as Gradle's plugin hands it on: with the name of the package, which build.gradle.kts has."""
    text = manifest.read_text()
    assert "package=" not in text
    target.write_text(text.replace("<manifest ", f'<manifest package="{package}" ', 1))


def link_resources():
    """The sample's resources, manifest and assets, as aapt2 makes them for an APK."""
    shutil.rmtree(ASSETS, ignore_errors=True)
    ASSETS.mkdir()
    scene = SOURCE / "scenes/sdl/cornell.sdl"
    for file in [scene, *scene.parent.glob("*.obj")]:  # as the sample's build.gradle.kts does
        shutil.copy(file, ASSETS)
    with_package(ANDROID / "sample/src/main/AndroidManifest.xml", "glint.sample", MANIFEST)
    jvm.run("aapt2", "compile", "--dir", ANDROID / "sample/src/main/res", "-o", BUILD / "resources.zip")
    jvm.run("aapt2", "link", "-I", jvm.FRAMEWORK, "--manifest", MANIFEST, "-A", ASSETS, "-o", RESOURCES,
            "--min-sdk-version", "24", "--target-sdk-version", "35", "--version-code", "1", "--version-name", "0.1.0",
            "--proguard", KEEP_RULES, BUILD / "resources.zip")


def run_tests(libraries, *classes):
    """JUnit's report; AssertionError where a test fails."""
    config = BUILD / "config"
    (config / "com/android/tools").mkdir(parents=True, exist_ok=True)
    (config / "com/android/tools/test_config.properties").write_text(
        f"android_merged_manifest={MANIFEST}\nandroid_merged_assets={ASSETS}\n"
        f"android_resource_apk={RESOURCES}\nandroid_custom_package=glint.sample\n")
    (config / "robolectric.properties").write_text("sdk=34\ngraphicsMode=LEGACY\nsqliteMode=LEGACY\n")
    properties = {
        "java.library.path": libraries, "java.io.tmpdir": BUILD / "tmp", "glint.scenes": SOURCE / "scenes/sdl",
        "glint.golden": SOURCE / "tests/golden/pictures.txt", "robolectric.offline": "true",
        "robolectric.dependency.dir": jvm.android_jar().rpartition("/")[0],
        "robolectric.usePreinstrumentedJars": "false", "robolectric.logging": "stderr",
    }
    (BUILD / "tmp").mkdir(exist_ok=True)
    classpath = [config, TESTS_JAR, JAVA_TESTS_JAR, *classpath_of_tests()]
    return jvm.java("-Xmx1g", "-Xcheck:jni", "-XX:TieredStopAtLevel=1",
                    "--add-opens=java.base/java.lang=ALL-UNNAMED", "--add-opens=java.base/java.util=ALL-UNNAMED",
                    *(f"-D{name}={value}" for name, value in properties.items()),
                    "-cp", ":".join(map(str, classpath)), "org.junit.runner.JUnitCore", *classes, cwd=BUILD)
