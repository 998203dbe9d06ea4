"""A compiler launcher that takes an object from Glint's own build where that was made by the very same command.

As a part of another project Glint is compiled as it is by itself, which is worth a test and makes this one quick: a second
compiler's run would give the same object. GLINT_COMMANDS names Glint's compile_commands.json; GLINT_COMPILED is a file that
gets a line for each source that had to be compiled after all.
"""

import json
import os
import shlex
import shutil
import sys
from pathlib import Path

WITH_VALUE = {"-o", "-MF", "-MT"} # where the results go: elsewhere in every build
ALONE = {"-MD"}


def essence(words):
    """The command without its launcher, which is itself a program's name, and without where the results go."""
    words = list(words)
    while len(words) > 1 and not words[1].startswith("-"):
        words.pop(0)
    kept = []
    skip = False
    for word in words[1:]:
        if not skip and word not in WITH_VALUE and word not in ALONE:
            kept.append(word)
        skip = word in WITH_VALUE
    return [Path(words[0]).name, *kept]


def object_of_own_build(words):
    source = words[-1]
    for entry in json.loads(Path(os.environ["GLINT_COMMANDS"]).read_text()):
        if entry["file"] == source:
            own = shlex.split(entry["command"])
            if essence(own) == essence(words):
                return Path(entry["directory"]) / own[own.index("-o") + 1]
    return None


def main():
    words = sys.argv[1:]
    found = object_of_own_build(words) if "-c" in words else None
    if found and found.exists():
        target = words[words.index("-o") + 1]
        shutil.copyfile(found, target)
        if "-MF" in words:
            Path(words[words.index("-MF") + 1]).write_text(f"{target}:\n")
        return
    with open(os.environ["GLINT_COMPILED"], "a") as log:
        log.write(words[-1] + "\n")
    os.execvp(words[0], words)


main()
