# Compiles for WebAssembly with Debian's Emscripten; what comes out runs here in Node, and in browsers.
# The core needs no libraries but the compiler's own, only headers; those that are the same on every machine are lent by
# this one.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/lent-headers.cmake)
set(CMAKE_FIND_ROOT_PATH ${GLINT_LENT_HEADERS} ${EMSCRIPTEN_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${EMSCRIPTEN_SYSROOT}/lib/pkgconfig) # not this machine's libraries

# Debian keeps what Emscripten's linker runs in Node where Node does not look by itself.
set(CMAKE_C_LINKER_LAUNCHER env NODE_PATH=/usr/share/nodejs)
set(CMAKE_CXX_LINKER_LAUNCHER env NODE_PATH=/usr/share/nodejs)

# SIMD is chosen when a module is compiled: one without does not know the instructions, one with them does not load where
# they are missing. Exceptions and threads cost nothing where they are not used.
string(APPEND CMAKE_C_FLAGS_INIT " -pthread")
string(APPEND CMAKE_CXX_FLAGS_INIT " -pthread -fexceptions -msimd128")
# Programs are for Node: with the machine's files, and with threads made beforehand, since a thread that waits for
# another's making would wait for ever.
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT
    " -sNODERAWFS=1 -sPROXY_TO_PTHREAD=1 -sPTHREAD_POOL_SIZE=10 -sEXIT_RUNTIME=1 -sINITIAL_MEMORY=1GB -sTOTAL_STACK=1MB -sDEFAULT_PTHREAD_STACK_SIZE=1MB")
