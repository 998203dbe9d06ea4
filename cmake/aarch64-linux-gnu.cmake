# Compiles for 64-bit ARM.
set(GLINT_TRIPLE aarch64-linux-gnu)
set(GLINT_QEMU qemu-aarch64-static)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
include(${CMAKE_CURRENT_LIST_DIR}/debian-cross.cmake)

# Pages as Android's phones have them: the linker's own guess of 64 KB would pad the library by as much.
set(CMAKE_SHARED_LINKER_FLAGS_INIT -Wl,-z,max-page-size=16384)
