/* All of Glint's C interface, for C11 and for whatever calls C. */
#ifndef GLINT_GLINT_H
#define GLINT_GLINT_H

/** @file
    Ray tracing on the CPUs people already carry, from C.

        glint_scene *scene = NULL;
        if (glint_scene_read("room.sdl", NULL, &scene) != GLINT_OK) puts(glint_last_error_message(scene));

    **Handles.** What functions named ..._create, _read, _wrap, _move, _build, ... leave behind is a handle, which its
    ..._release gives up; NULL is allowed there. Handles may be released in any order: what another one still needs
    lives on inside.

    **Failure.** Functions return a glint_error or, where they cannot fail, a value. glint_last_error_message(handle)
    says what the last failure on a handle was. A creating function that fails leaves a handle, too, which only carries
    that message: it must be released like any other, and every other function refuses it with
    GLINT_ERROR_INVALID_ARGUMENT, as it refuses NULL and handles of another kind. Only where memory is out even for the
    handle, or the place for it is NULL, there is none. Functions that only look at a handle (const) leave no message.
    No exception comes out of a function; errors are kept in handles, never for the thread or the process.

    **Threads.** One thread at a time uses a handle, different handles at the same time are fine; scenes, and jobs as
    said there, may be shared. The library starts no thread but a renderer's, and none where the host lends its own.

    **Structs that grow.** A struct with a `size` may get more members at its end in later versions. The caller puts
    sizeof in it, by the ..._init function where there is one, which sets all defaults, or by hand. A library that
    knows more members takes their defaults; one that knows fewer asks the rest to be 0. What the library fills, it
    fills up to `size`, what it does not know with 0. Sizes are multiples of sizeof(size_t), at most 4096. All else that
    is called reserved must be 0. Structs without a size never change.

    **Numbers.** The world is right-handed, in the scene's own units; colours are linear; angles are radians. Truth
    values are int32_t, 0 or not. Texts are UTF-8 and end with 0. */

#include <glint/error.h>
#include <glint/renderer.h>
#include <glint/scene.h>
#include <glint/scene_builder.h>
#include <glint/version.h>
#include <glint/view.h>

#endif
