# Compiles for 64-bit ARM on a PC with Debian's cross compiler; what comes out runs here through QEMU.
# The core needs no libraries for ARM beyond the compiler's own, only headers. Those that are the same on every machine
# are lent by this one, each by name: the compiler must not see the rest of /usr/include, which describes another.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L /usr/aarch64-linux-gnu)

include(${CMAKE_CURRENT_LIST_DIR}/lent-headers.cmake)
set(CMAKE_FIND_ROOT_PATH ${GLINT_LENT_HEADERS} /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} /usr/aarch64-linux-gnu/lib/pkgconfig) # not this machine's libraries

# Pages as Android's phones have them: the linker's own guess of 64 KB would pad the library by as much.
set(CMAKE_SHARED_LINKER_FLAGS_INIT -Wl,-z,max-page-size=16384)
