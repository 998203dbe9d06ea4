"""What an object compiled for one instruction set shows the linker: its kernel, and names of its own alone.

Of an inline function that several objects have, the linker keeps one copy for all. Were it the copy with wide
instructions, the rest of the program would crash on machines that lack them.

GLINT_KERNEL_OBJECTS names a file that lists the objects packet/kernel_<isa>.o, a line each; NM is the program nm.
"""

import os
import re
import subprocess
import unittest
from pathlib import Path

OBJECTS = Path(os.environ["GLINT_KERNEL_OBJECTS"])
NM = os.environ.get("NM", "nm")

# Highway's names for what the files are compiled for (HWY_NAMESPACE).
NAMESPACES = {"sse4": "N_SSE4", "avx2": "N_AVX2", "avx512": "N_AVX3", "neon": "N_NEON"}


def isa_of(path):
    return re.fullmatch(r"kernel_(\w+)\.cpp\.o(bj)?", path.name)[1]


def kernel_name(isa):
    """glint::<isa>_kernel, mangled."""
    return f"_ZN5glint{len(isa) + 7}{isa}_kernelE"


def lies_inside(name, isa):
    """Whether a mangled name begins in the namespace glint::N_<ISA>: it is declared there, or local to what is; the
    same of virtual tables, type information and the guards of static variables."""
    space = NAMESPACES[isa]
    return re.match(rf"_Z(T[VTIS]|GV)?Z*N[KVrRO]*5glint{len(space)}{space}", name) is not None


def leaks(names, isa):
    """Those of an object's mangled names that are not its own."""
    return [name for name in names if name != kernel_name(isa) and not lies_inside(name, isa)]


def shown_by(path):
    """All names that an object defines and the linker sees: strong, weak, unique."""
    out = subprocess.run([NM, "--format=posix", "--defined-only", "--extern-only", path],
                         check=True, capture_output=True, text=True).stdout
    return [line.split()[0] for line in out.splitlines()]


class Objects(unittest.TestCase):
    def test_each_shows_its_kernel_and_nothing_that_others_may_have_too(self):
        paths = [Path(line) for line in OBJECTS.read_text().split("\n") if line]
        if not paths:
            self.skipTest("no instruction sets were built in")
        for path in paths:
            isa = isa_of(path)
            with self.subTest(isa=isa):
                names = shown_by(path)
                self.assertIn(kernel_name(isa), names)
                self.assertEqual(leaks(names, isa), [])


class TheCheck(unittest.TestCase):
    def test_it_knows_what_is_inside(self):
        for name in (
            "_ZN5glint11avx2_kernelE",
            "_ZN5glint6N_AVX25traceILb0ELb1EEEvRKNS0_13TraceQuestionE",
            "_ZNK5glint6N_AVX24Beam5widthEv",
            "_ZZN5glint6N_AVX24pathEvE5table",
            "_ZGVZN5glint6N_AVX24pathEvE5table",
            "_ZTIN5glint6N_AVX24BeamE",
        ):
            self.assertEqual(leaks([name], "avx2"), [], name)

    def test_it_sees_what_leaks(self):
        for name in (
            "_ZSt3minIfERKT_S2_S2_",                               # std::min<float>
            "_ZNSt6vectorIN5glint6N_AVX24BeamESaIS2_EE4sizeEv",    # a member of std::vector<glint::N_AVX2::Beam>
            "_ZNK5glint6KdNode5splitEv",                           # an inline function of another room
            "_ZN5glint6N_SSE45traceEv",                            # of another instruction set
            "_ZN5glint11sse4_kernelE",
            "_ZN3hwy6N_AVX23AddEv",
            "_ZTIN5glint6KdNodeE",
            "helper",
        ):
            self.assertEqual(leaks([name], "avx2"), [name], name)


if __name__ == "__main__":
    unittest.main()
