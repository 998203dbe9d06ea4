"""Builds the fuzzers with Clang and lets them run: a minute each as a test, as long as wanted with scripts/fuzz.

What a fuzzer learns stays in BUILD/corpus, what makes it stop in BUILD/crashes. With --keep, each such text is made as
small as can be and put beside this script, into found/, where every build replays it from then on.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
TARGETS = sorted(path.name.removesuffix("_target.cpp") for path in HERE.glob("*_target.cpp"))
TEXTS_OF = {"convert": "sdl", "model": "obj"}  # whose corpus and dictionary they take; all others have their own
COMPILER = "clang++-16"
SKIPPED = 77  # what ctest takes for "not run"

# A text that takes a second is a fault that the targets find by themselves; these are for endless loops, and for what
# nobody thought of. Sanitizers need some memory of their own.
BOUNDS = ["-timeout=20", "-rss_limit_mb=1024"]


def missing():
    """Why there can be no fuzzers here; None where there can."""
    if not shutil.which(COMPILER):
        return "clang-16 is not installed"
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "nothing.cpp")
        source.write_text('extern "C" int LLVMFuzzerTestOneInput(const unsigned char *, unsigned long) { return 0; }\n')
        done = subprocess.run([COMPILER, "-fsanitize=fuzzer,address,undefined", source, "-o", Path(folder, "nothing")],
                              capture_output=True)
    return None if done.returncode == 0 else "libclang-rt-16-dev is not installed"


def build(folder):
    """Configures and builds; says what went wrong, and whether all went well."""
    cmake = os.environ.get("CMAKE", "cmake")
    for command in ([cmake, "--preset", "fuzz", "-B", folder],
                    [cmake, "--build", folder, "--parallel", str(os.cpu_count()), "--target",
                     *(f"glint_fuzz_{target}" for target in TARGETS)]):
        done = subprocess.run(command, cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            print(done.stdout)
            return False
    return True


class Fuzzer:
    """One target, its corpus and what it has found."""

    def __init__(self, folder, target):
        self.target = target
        self.texts = TEXTS_OF.get(target, target)
        self.program = folder / "tests" / "fuzz" / f"glint_fuzz_{target}"
        self.corpus = folder / "corpus" / target
        self.crashes = folder / "crashes" / target
        for path in (self.corpus, self.crashes):
            path.mkdir(parents=True, exist_ok=True)

    def run_program(self, *arguments):
        symbolizer = shutil.which("llvm-symbolizer-16") or shutil.which("llvm-symbolizer") or ""
        return subprocess.run([self.program, *BOUNDS, *map(str, arguments)], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace",
                              env={**os.environ, "ASAN_SYMBOLIZER_PATH": symbolizer})

    def fuzz(self, seconds):
        """Whether it found nothing; prints what it says of its end."""
        known = [folder for folder in (HERE / "corpus" / self.texts, HERE / "found" / self.texts) if folder.exists()]
        done = self.run_program(f"-max_total_time={seconds}", f"-dict={HERE / self.texts}.dict",
                                f"-artifact_prefix={self.crashes}/", "-print_final_stats=1",
                                self.corpus, *known)
        said = done.stdout.splitlines()
        progress = [line for line in said if re.match(r"#\d", line)]
        rest = [line for line in said if not line.startswith("#")]
        print(f"== {self.target}", *(progress[-1:] + (rest[-6:] if done.returncode == 0 else rest)), sep="\n",
              flush=True)
        return done.returncode == 0

    def keep(self, crash):
        """The smallest text that fails as `crash` does, put where every build replays it."""
        smallest = self.crashes / f"{crash.name}.small"
        self.run_program("-minimize_crash=1", "-max_total_time=60", f"-exact_artifact_path={smallest}", crash)
        kept = HERE / "found" / self.texts / crash.name
        kept.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(smallest if smallest.exists() else crash, kept)
        print(f"kept as {kept.relative_to(SOURCE)}")

    def keep_all(self):
        for crash in sorted(self.crashes.iterdir()):
            if crash.suffix != ".small" and not (HERE / "found" / self.texts / crash.name).exists():
                self.keep(crash)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=SOURCE / "build" / "fuzz", help="the folder to build in")
    parser.add_argument("--seconds", type=float, default=60, help="for each target; 0 only builds")
    parser.add_argument("--keep", action="store_true", help="put what is found into tests/fuzz/found")
    parser.add_argument("targets", nargs="*", metavar="TARGET",
                        help=f"of {', '.join(TARGETS)}; all unless some are named")
    arguments = parser.parse_args()
    targets = arguments.targets or TARGETS
    if unknown := sorted(set(targets) - set(TARGETS)):
        parser.error(f"there is no target {', '.join(unknown)}; there are {', '.join(TARGETS)}")

    if reason := missing():
        print(f"skipped: {reason}")
        return SKIPPED
    if not build(arguments.build):
        return 1
    if arguments.seconds == 0:
        return 0
    fuzzers = [Fuzzer(arguments.build.resolve(), target) for target in targets]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        are_well = list(pool.map(lambda fuzzer: fuzzer.fuzz(int(arguments.seconds)), fuzzers))
    if arguments.keep:
        for fuzzer in fuzzers:
            fuzzer.keep_all()
    return 0 if all(are_well) else 1


if __name__ == "__main__":
    sys.exit(main())
