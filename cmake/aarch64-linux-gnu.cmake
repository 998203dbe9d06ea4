# Compiles for 64-bit ARM on a PC with Debian's cross compiler; what comes out runs here through QEMU.
# The core needs no libraries for ARM beyond the compiler's own, only headers. Those that are the same on every machine
# are lent by this one, each by name: the compiler must not see the rest of /usr/include, which describes another.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L /usr/aarch64-linux-gnu)

set(lent ${CMAKE_BINARY_DIR}/lent-headers)
foreach(name IN ITEMS include/EGL include/GLES2 include/GLES3 include/KHR include/glm include/hwy
        include/tiny_obj_loader.h include/xxh3.h include/xxhash.h share/cmake/glm)
    if(EXISTS /usr/${name} AND NOT EXISTS ${lent}/${name})
        cmake_path(GET name PARENT_PATH folder)
        file(MAKE_DIRECTORY ${lent}/${folder})
        file(CREATE_LINK /usr/${name} ${lent}/${name} SYMBOLIC)
    endif()
endforeach()

set(CMAKE_FIND_ROOT_PATH ${lent} /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} /usr/aarch64-linux-gnu/lib/pkgconfig) # not this machine's libraries
