"""The rooms of the house and who may use whom, read from the #include lines.

One way, no loops: every room is written below the rooms it may use. A public header may be used by every room of its
own part of the house, so that core/ and platform/ meet at the public headers only.
"""

import re
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]

# Room -> the rooms whose insides it may include; its own it always may.
USES = {
    "core/include": (),
    "core/math": (),
    "core/text": (),
    "core/threads": (),
    "core/scene": ("core/math", "core/text"),
    "core/mesh": ("core/math", "core/text", "core/scene"),
    "core/sdl": ("core/math", "core/text", "core/scene", "core/mesh"),
    "core/accel": ("core/math", "core/threads", "core/scene"),
    "core/image": ("core/math",),
    "core/kernel": ("core/math", "core/scene", "core/accel", "core/image"),
    "core/render": ("core/math", "core/threads", "core/scene", "core/accel", "core/image", "core/kernel"),
    "core/view": ("core/math", "core/threads", "core/scene", "core/image"),
    "core/c": ("core/math", "core/scene", "core/view"),
    "core/imageio": ("core/image",),
    "platform/gles": (),
    "platform/egl": ("platform/gles",),
    "platform/osmesa": ("platform/gles",),
    "platform/viewer/hud": (),
    "platform/viewer": ("platform/gles", "platform/egl", "platform/osmesa", "platform/viewer/hud"),
    # The view on a phone moves, traces and shows with the desktop viewer's own parts.
    "platform/android": ("platform/gles", "platform/egl", "platform/viewer"),
    # Peers wait for work in the same pool of threads as Glint does, so that waking up costs all the same.
    "bench/peers": (),
    "bench/peers/embree": ("bench/peers", "core/threads"),
    "bench/peers/tinyobj": ("bench/peers",),
    # What the presenter could do instead is measured with its own tools.
    "bench/presenting": ("platform/gles",),
    "bench/instructions": (),
    "bench": ("bench/peers", "bench/peers/embree", "bench/peers/tinyobj", "bench/presenting", "core/threads"),
    "apps/glint": ("bench", "platform/viewer"),
    "scenes/generate": (),
    # What others write: they see what is installed.
    "examples": (),
}

# Where "room/file.hpp" is looked for, as the compiler does.
INCLUDE_ROOTS = ("core", "platform", "scenes", "")

# Beginning of a header's name -> the rooms that may include it, each with all that lies inside it.
LIBRARIES = {
    "glm/": ("core", "scenes"),
    "tiny_obj_loader.h": ("core/mesh", "bench/peers/tinyobj"),
    "xxhash.h": ("core/image",),
    "fast_float/": ("core/text",),
    "hwy/": ("core/kernel",),
    "OpenImageIO/": ("core/imageio",),
    "EGL/": ("platform/egl", "examples"),
    "stdio.h": ("examples",),
    "GLES2/": ("platform/gles",),
    "GLES3/": ("platform/gles", "examples"),
    "SDL2/": ("platform/viewer", "examples"),
    "jni.h": ("platform/android",),
    "malloc.h": ("apps",),
    "android/": ("platform/android",),
    "CLI/": ("apps",),
    "fmt/": ("apps", "bench"),
    "nlohmann/": ("apps", "bench"),
    "embree3/": ("bench/peers/embree",),
    "immintrin.h": ("bench/peers/embree",),
}

POSIX = {"dlfcn.h", "fcntl.h", "sched.h", "sys/mman.h", "sys/stat.h", "sys/utsname.h", "unistd.h"}
STANDARD = re.compile(r"[a-z_]+|std(int|def|bool)\.h")
# The standard's own ways to print and to catch signals; the core is a guest in somebody's process.
NOT_FOR_GUESTS = {"iostream", "print", "csignal", "csetjmp", "syncstream"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?P<open>["<])(?P<name>[^">]+)[">]')


def is_inside(path, folder):
    return path == folder or path.startswith(folder + "/")


def includes_of(path):
    """(line number, is it in quotes, name) of every #include of a file."""
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        if match := INCLUDE.match(line):
            yield number, match["open"] == '"', match["name"]


def sources(root):
    """Every C and C++ file of the rooms, as paths relative to root."""
    tops = sorted({room.split("/")[0] for room in USES})
    files = (path for top in tops for path in (root / top).rglob("*") if path.suffix in (".cpp", ".hpp", ".c", ".h"))
    return sorted(path.relative_to(root).as_posix() for path in files)


def room_of(path):
    """The innermost room that the file lies in; the folder that would have to be one where there is none."""
    rooms = [room for room in USES if is_inside(path, room)]
    return max(rooms, key=len) if rooms else "/".join(path.split("/")[:2])


class Source:
    """One file, where it stands and what it may include."""

    def __init__(self, root, path):
        self.root = root
        self.path = path
        self.room = room_of(path)
        self.is_public = "/include/glint/" in path

    def complaint(self, quoted, name):
        """Why the file may not include `name`; None where it may."""
        if self.room not in USES:
            return f"{self.room} is not a room: write it into tests/architecture/rooms.py"
        return self.about_quoted(name) if quoted else self.about_angled(name)

    def about_quoted(self, name):
        if self.is_public:
            return "a public header includes what is installed, by <glint/...>"
        if ".." in name.split("/"):
            return 'rooms are entered by name, "room/file.hpp"'
        if "/" not in name:
            beside = (self.root / self.path).parent / name
            return None if beside.is_file() else "there is no such file in the same folder"
        for top in INCLUDE_ROOTS:
            found = f"{top}/{name}".lstrip("/")
            if (self.root / found).is_file():
                return self.about_room(Source(self.root, found).room)
        return "there is no such file in any room"

    def about_angled(self, name):
        if name.startswith("glint/"):
            return self.about_public(name)
        if STANDARD.fullmatch(name):
            is_refused = self.room.startswith("core/") and name in NOT_FOR_GUESTS
            return "the core prints nothing and leaves signals alone" if is_refused else None
        for library, rooms in LIBRARIES.items():
            if name.startswith(library):
                may = any(is_inside(self.room, room) for room in rooms)
                return None if may else f"{library} is for {' and '.join(rooms)}"
        if name in POSIX:
            return "a public header is the same on every system" if self.is_public else None
        return "an unknown library: write who may use it into tests/architecture/rooms.py"

    def about_public(self, name):
        """Public headers of the core are for all, those of a platform for whoever may use that platform."""
        for platform in (self.root / "platform").glob("*/include"):
            if (platform / name).is_file():
                if is_inside(self.room, "bench") or self.room in ("apps/glint", "examples"):
                    return None
                return self.about_room(f"platform/{platform.parent.name}")
        return None if (self.root / "core/include" / name).is_file() else "there is no such public header"

    def about_room(self, room):
        if room == self.room or room in USES[self.room]:
            return None
        return f"{self.room} may not use {room}"


def violations(root=SOURCE):
    """A line for every #include that breaks the rules."""
    found = []
    for path in sources(root):
        source = Source(root, path)
        for number, quoted, name in includes_of(root / path):
            if complaint := source.complaint(quoted, name):
                found.append(f"{path}:{number}: {name}: {complaint}")
    return found
