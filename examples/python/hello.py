"""Renders a scene and writes the picture as a PPM file: hello.py SCENE PICTURE"""
import ctypes
import sys

glint = ctypes.CDLL("libglint.so.0")
glint.glint_last_error_message.restype = ctypes.c_char_p


def made(create, *arguments):
    """The handle that a creating function leaves behind; it also carries what went wrong."""
    handle = ctypes.c_void_p()
    if create(*arguments, ctypes.byref(handle)) != 0:
        sys.exit(glint.glint_last_error_message(handle).decode())
    return handle


width, height = 256, 256
memory = ctypes.create_string_buffer(4 * width * height)  # the picture lands in Python's own memory
scene = made(glint.glint_scene_read, sys.argv[1].encode(), None)
renderer = made(glint.glint_renderer_create, scene, None)
picture = made(glint.glint_framebuffer_wrap, width, height, memory, None, None, None)
if glint.glint_renderer_render(renderer, picture, None, None) != 0:
    sys.exit(glint.glint_last_error_message(renderer).decode())
with open(sys.argv[2], "wb") as file:
    file.write(b"P6 %d %d 255\n" % (width, height))
    file.write(bytes(byte for i, byte in enumerate(memory.raw) if i % 4 != 3))
for name, handle in (("framebuffer", picture), ("renderer", renderer), ("scene", scene)):
    glint[f"glint_{name}_release"](handle)
