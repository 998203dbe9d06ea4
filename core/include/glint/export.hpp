// Marks what the shared library shows; everything else stays inside.
#pragma once

#if defined(_WIN32)
#define GLINT_API
#else
#define GLINT_API __attribute__((visibility("default")))
#endif
