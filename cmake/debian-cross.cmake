# Compiles for GLINT_TRIPLE, a machine of another kind, on a PC with Debian's cross compiler; what comes out runs here
# through GLINT_QEMU. The core needs no libraries for it beyond the compiler's own, only headers. Those that are the same
# on every machine are lent by this one, each by name: the compiler must not see the rest of /usr/include, which describes
# another.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${GLINT_TRIPLE}-gcc)
set(CMAKE_CXX_COMPILER ${GLINT_TRIPLE}-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR ${GLINT_QEMU} -L /usr/${GLINT_TRIPLE})

include(${CMAKE_CURRENT_LIST_DIR}/lent-headers.cmake)
set(CMAKE_FIND_ROOT_PATH ${GLINT_LENT_HEADERS} /usr/${GLINT_TRIPLE})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} /usr/${GLINT_TRIPLE}/lib/pkgconfig) # not this machine's libraries
