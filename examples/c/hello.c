/* Renders a scene and writes the picture as a PPM file: hello SCENE PICTURE */
#include <stdio.h>

#include <glint/glint.h>

int main(int argc, char **argv) {
    if (argc != 3) return fputs("usage: hello SCENE PICTURE\n", stderr), 2;
    glint_scene *scene = NULL;
    glint_renderer *renderer = NULL;
    glint_framebuffer *picture = NULL;
    glint_pixels pixels = {.size = sizeof pixels};
    const void *failed = NULL; /* the handle that says why */
    if (glint_scene_read(argv[1], NULL, &scene) != GLINT_OK) failed = scene;
    else if (glint_renderer_create(scene, NULL, &renderer) != GLINT_OK) failed = renderer;
    else if (glint_framebuffer_create(256, 256, 0, &picture) != GLINT_OK) failed = picture;
    else if (glint_renderer_render(renderer, picture, NULL, NULL) != GLINT_OK) failed = renderer;
    if (failed) fprintf(stderr, "%s\n", glint_last_error_message(failed));
    FILE *file = failed ? NULL : fopen(argv[2], "wb");
    if (file && glint_framebuffer_get_pixels(picture, &pixels) == GLINT_OK) {
        fprintf(file, "P6 %u %u 255\n", (unsigned)pixels.width_px, (unsigned)pixels.height_px);
        for (size_t i = 0; i < (size_t)pixels.width_px * pixels.height_px; ++i) fwrite(pixels.rgba8 + 4 * i, 1, 3, file);
    }
    const int is_written = file && fclose(file) == 0;
    glint_framebuffer_release(picture);
    glint_renderer_release(renderer);
    glint_scene_release(scene);
    return is_written ? 0 : 1;
}
