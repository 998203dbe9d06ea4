"""What a guest in somebody's process does not do: print, end the process, or install handlers.

Read from the core's sources with comments and texts taken out, so that talking about printing is allowed.
"""

import re

import rooms

# Comments, raw strings, strings and characters, whichever begins first.
NOT_CODE = re.compile(
    r"""
    //[^\n]* | /\*.*?\*/
    | R"(?P<end>[^(]*)\(.*?\)(?P=end)"
    | "(?:\\.|[^"\\\n])*" | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])*'
    """,
    re.VERBOSE | re.DOTALL,
)

CALLS = (
    "printf fprintf vprintf vfprintf dprintf puts fputs putchar putc fputc perror print println "
    "exit _exit _Exit quick_exit abort terminate set_terminate atexit at_quick_exit "
    "signal sigaction raise kill setjmp longjmp"
).split()
STREAMS = "stdout stderr cout cerr clog wcout wcerr wclog".split()

# A name before the call, as in snprintf(), or an object, as in door.exit(), makes it another function.
FORBIDDEN = re.compile(
    rf"(?<![\w.])(?<!->)(?:(?P<call>{'|'.join(CALLS)})\s*\(|(?P<stream>{'|'.join(STREAMS)})\b)"
)


def blanked(text):
    """The text with everything that is not code replaced by spaces, line breaks kept."""
    return NOT_CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def misbehaviour(text):
    """(line number, what) of everything in a source text that a guest does not do."""
    code = blanked(text)
    return [(code.count("\n", 0, match.start()) + 1, match["call"] or match["stream"])
            for match in FORBIDDEN.finditer(code)]


def violations():
    """A line for everything that the core should not do."""
    files = [path for path in rooms.sources(rooms.SOURCE) if rooms.is_inside(path, "core")]
    return [f"{path}:{line}: {what}"
            for path in files
            for line, what in misbehaviour((rooms.SOURCE / path).read_text())]
