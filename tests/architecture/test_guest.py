"""The core neither prints nor ends the process nor installs handlers, and the check of that sees what does."""

import unittest

import guest


class TheCore(unittest.TestCase):
    def test_no_source_prints_exits_aborts_or_installs_handlers(self):
        self.assertEqual(guest.violations(), [])


class TheCheck(unittest.TestCase):
    def test_it_sees_what_a_guest_does_not_do(self):
        for line, what in (
            ('printf("%d", n);', "printf"),
            ('std::fprintf(file, "x");', "fprintf"),
            ('std::cerr << "oh";', "cerr"),
            ("std::exit (1);", "exit"),
            ("if (!ok) ::abort();", "abort"),
            ("signal(SIGINT, handler);", "signal"),
            ("fflush(stdout);", "stdout"),
        ):
            self.assertEqual(guest.misbehaviour(f"int n = 1'000;\n{line}\n"), [(2, what)], line)

    def test_it_lets_pass_what_only_looks_like_it(self):
        for line in (
            'std::snprintf(text, size, "%s", name);',
            "door.exit(); door->exit();",
            "// never printf() here",
            "/* exit(1) and\n abort() */",
            'say("call exit(1)");',
            'say(R"(exit(1) " abort())");',
            "footprint(3); exits = printfs;",
            "char c = '\"'; int d = 'x'; // \" printf(",
        ):
            self.assertEqual(guest.misbehaviour(line), [], line)

    def test_code_after_a_text_is_still_read(self):
        self.assertEqual(guest.misbehaviour('f("a\\"b", \'"\'); exit(1);\n'), [(1, "exit")])
        self.assertEqual(guest.misbehaviour('f(R"x(a)" )x"); abort();\n'), [(1, "abort")])


if __name__ == "__main__":
    unittest.main()
