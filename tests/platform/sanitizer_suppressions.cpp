// What the sanitizers must forgive: faults within drivers, which are built without them and are not ours.

// OSMesa 22.3 keeps its record of every drawable until the process ends, also after OSMesaDestroyContext.
extern "C" const char *__lsan_default_suppressions();
extern "C" const char *__lsan_default_suppressions() {
    return "leak:libOSMesa.so\n";
}

// llvmpipe hands work to its threads with atomics and futexes that ThreadSanitizer cannot see.
extern "C" const char *__tsan_default_suppressions();
extern "C" const char *__tsan_default_suppressions() {
    return "race:libOSMesa.so\n"
           "race:swrast_dri.so\n"
           "race:libgallium\n";
}
