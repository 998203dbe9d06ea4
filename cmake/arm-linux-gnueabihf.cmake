# Compiles for 32-bit ARM: ARMv7 with VFPv3 and NEON.
set(GLINT_TRIPLE arm-linux-gnueabihf)
set(GLINT_QEMU qemu-arm-static)
set(CMAKE_SYSTEM_PROCESSOR armv7)
include(${CMAKE_CURRENT_LIST_DIR}/debian-cross.cmake)
