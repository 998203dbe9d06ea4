/* Marks what the shared library shows, in C and C++; everything else stays inside. */
#ifndef GLINT_EXPORT_H
#define GLINT_EXPORT_H

#if defined(_WIN32)
#define GLINT_API
#else
#define GLINT_API __attribute__((visibility("default")))
#endif

/* Around the declarations of a C header. */
#if defined(__cplusplus)
#define GLINT_C_BEGIN extern "C" {
#define GLINT_C_END }
#else
#define GLINT_C_BEGIN
#define GLINT_C_END
#endif

#endif
