"""Tools of Java, Kotlin and Android that the tests use: what is missing, where jars are, how to compile.

GLINT_JAVAC names the compiler of the JDK whose jni.h the native library was built with; GLINT_BUILD a folder to work in.
"""

import functools
import hashlib
import os
import shutil
import subprocess
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
ANDROID = SOURCE / "platform" / "android"
BUILD = Path(os.environ["GLINT_BUILD"])
JDK = Path(os.environ["GLINT_JAVAC"] or "/usr/bin/javac").resolve().parents[1]

PROGRAMS = {"mvn": "maven", "aapt2": "aapt", "zipalign": "zipalign", "apksigner": "apksigner"}
FRAMEWORK = Path("/usr/share/android-framework-res/framework-res.apk")


def missing_packages():
    """Debian's packages that the tests lack."""
    missing = [package for program, package in PROGRAMS.items() if not shutil.which(program)]
    if not FRAMEWORK.exists():
        missing.append("android-framework-res")
    if not (JDK / "include" / "jni.h").exists():
        missing.append("openjdk-17-jdk-headless")
    return missing


def run(*command, cwd=None, timeout=600):
    """What the command prints; AssertionError with that where it fails."""
    done = subprocess.run(list(map(str, command)), cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", timeout=timeout,
                          env={**os.environ, "JAVA_HOME": str(JDK), "PATH": f"{JDK / 'bin'}:{os.environ['PATH']}"})
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(done.args)[:2000]}\nended with {done.returncode}:\n{done.stdout[-20000:]}")
    return done.stdout


@functools.cache
def jars():
    """Every jar that pom.xml asks for, fetched where it is not there yet; without a way to fetch them tests are skipped."""
    pom, listing = HERE / "pom.xml", BUILD / "jars.txt"
    if is_made_of(listing, pom) and all(path.exists() for path in listed(listing)):
        return listed(listing)
    for mode in (["--offline"], []):
        try:
            run("mvn", "--batch-mode", "--quiet", *mode, "--file", pom, "dependency:build-classpath",
                f"-Dmdep.outputFile={listing}", cwd=BUILD)
            return listed(listing)
        except AssertionError as error:
            reason = str(error)
    raise unittest.SkipTest(f"Maven Central is out of reach: {reason.splitlines()[-1]}")


def listed(listing):
    return [Path(path) for path in listing.read_text().strip().split(":")]


def jars_of(*parts):
    """Those in whose path one of the parts is, as a class path."""
    found = [str(jar) for jar in jars() if any(part in str(jar) for part in parts)]
    assert len(found) >= len(parts), (parts, found)
    return ":".join(found)


def android_jar():
    return jars_of("/org/robolectric/android-all/")


def java(*arguments, cwd=None):
    # What is started for seconds need not be compiled as if it ran for hours.
    return run(JDK / "bin/java", "-Xshare:auto", "-XX:+UseSerialGC", *arguments, cwd=cwd)


def is_made_of(target, *sources):
    """Whether the target was made of exactly these files' contents and arguments; remembers them otherwise."""
    digest = hashlib.sha256()
    for source in sources:
        digest.update(source.read_bytes() if isinstance(source, Path) else str(source).encode())
    stamp = target.with_name(target.name + ".made-of")
    if target.exists() and stamp.exists() and stamp.read_text() == digest.hexdigest():
        return True
    stamp.write_text(digest.hexdigest())
    target.unlink(missing_ok=True)
    return False


def compile_kotlin(jar, sources, classpath, *options):
    """Kotlin sources to a jar; warnings are errors."""
    if is_made_of(jar, *sources, *(Path(path) for path in classpath if path.startswith(str(BUILD))), *options):
        return
    java("-Xmx1g", "-XX:TieredStopAtLevel=1", "-cp", jars_of("/org/jetbrains/"),
         "org.jetbrains.kotlin.cli.jvm.K2JVMCompiler", "-no-stdlib", "-no-reflect", "-jvm-target", "11", "-Werror",
         *options, "-classpath", ":".join(classpath), "-d", jar, *sources)


def compile_java(jar, sources, classpath):
    """Java sources to a jar; warnings are errors."""
    classes = jar.with_suffix(".classes")
    shutil.rmtree(classes, ignore_errors=True)
    run(JDK / "bin/javac", "--release", "11", "-Xlint:all,-options,-classfile,-path", "-Werror", "-proc:none",
        "-classpath", ":".join(classpath), "-d", classes, *sources)
    run(JDK / "bin/jar", "--create", "--file", jar, "-C", classes, ".")
