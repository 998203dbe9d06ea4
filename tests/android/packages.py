"""An AAR and an APK, put together from what was built, as Gradle's plugin would do it."""

import json
import shutil
import zipfile

import app
import jvm
from jvm import ANDROID, BUILD, SOURCE

AAR = BUILD / "glint.aar"
APK = BUILD / "sample.apk"
ABI = "arm64-v8a"
# Module of the Prefab package -> its headers and its library in the build folder of another processor.
MODULES = {
    "glint_core": (SOURCE / "core/include", "core/libglint.a"),
    "glint_gles": (SOURCE / "platform/gles/include", "platform/gles/libglint_gles.a"),
}


def as_json(value):
    return json.dumps(value, indent=2) + "\n"


def assemble_aar(native):
    """`native` is the folder where the libraries were built for 64-bit ARM."""
    manifest = BUILD / "library-manifest.xml"
    app.with_package(ANDROID / "library/src/main/AndroidManifest.xml", "glint.android", manifest)
    symbols = BUILD / "R.txt"
    jvm.run("aapt2", "link", "-I", jvm.FRAMEWORK, "--manifest", manifest, "-o", BUILD / "library.apk",
            "--min-sdk-version", "24", "--non-final-ids", "--output-text-symbols", symbols)
    with zipfile.ZipFile(AAR, "w", zipfile.ZIP_DEFLATED) as aar:
        aar.write(manifest, "AndroidManifest.xml")
        aar.write(app.LIBRARY_JAR, "classes.jar")
        aar.write(symbols, "R.txt")
        aar.write(ANDROID / "library/consumer-rules.pro", "proguard.txt")
        aar.write(native / "platform/android/jni/libglint_android.so", f"jni/{ABI}/libglint_android.so")
        aar.writestr("prefab/prefab.json", as_json(
            {"schema_version": 2, "name": "glint", "version": "0.1.0", "dependencies": []}))
        for name, (headers, library) in MODULES.items():
            module = f"prefab/modules/{name}"
            library_name = library.rpartition("/")[2].removesuffix(".a")
            aar.writestr(f"{module}/module.json", as_json(
                {"export_libraries": [], "library_name": library_name, "android": {"library_name": library_name}}))
            for header in sorted(headers.rglob("*.h*")):
                aar.write(header, f"{module}/include/{header.relative_to(headers)}")
            libraries = f"{module}/libs/android.{ABI}"
            aar.writestr(f"{libraries}/abi.json", as_json(
                {"abi": ABI, "api": 24, "ndk": 27, "stl": "c++_shared", "static": True}))
            aar.write(native / library, f"{libraries}/{library_name}.a")


def make_key():
    """A key that signs for tests, made once."""
    store = BUILD / "test.keystore"
    if not store.exists():
        jvm.run(jvm.JDK / "bin/keytool", "-genkeypair", "-keystore", store, "-storepass", "glint-tests", "-alias",
                "tests", "-keyalg", "RSA", "-keysize", "2048", "-validity", "10000", "-dname", "CN=tests")
    return store


def shrink(folder):
    """Dex files of the sample and all it uses, shrunk as a release is: by the rules of the library and of aapt2."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    jvm.java("-Xmx1g", "-XX:TieredStopAtLevel=1", "-cp", jvm.jars_of("/com/android/tools/r8/"),
             "com.android.tools.r8.R8", "--release", "--min-api", "24", "--lib", jvm.android_jar(), "--lib", jvm.JDK,
             "--pg-conf", ANDROID / "library/consumer-rules.pro", "--pg-conf", app.KEEP_RULES, "--output", folder,
             app.LIBRARY_JAR, app.SAMPLE_JAR, *jvm.jars_of("/kotlin-stdlib/", "/jetbrains/annotations/").split(":"))


def assemble_apk(native):
    """Linked, dexed, aligned and signed."""
    dex = BUILD / "dex"
    shrink(dex)
    raw = BUILD / "raw.apk"
    shutil.copy(app.RESOURCES, raw)
    with zipfile.ZipFile(raw, "a", zipfile.ZIP_DEFLATED) as apk:
        for file in sorted(dex.glob("*.dex")):
            apk.write(file, file.name)
        # Loaded from within the APK: neither compressed nor unaligned.
        apk.write(native / "platform/android/jni/libglint_android.so", f"lib/{ABI}/libglint_android.so",
                  zipfile.ZIP_STORED)
    aligned = BUILD / "aligned.apk"
    jvm.run("zipalign", "-f", "-p", "4", raw, aligned)
    jvm.run("apksigner", "sign", "--ks", make_key(), "--ks-pass", "pass:glint-tests", "--min-sdk-version", "24",
            "--v2-signing-enabled", "true", "--v3-signing-enabled", "true", "--out", APK, aligned)
