# What a build can switch, and how every target of ours is compiled.
# As a part of another project (add_subdirectory, FetchContent) Glint is its libraries: no programs, no tests, nothing
# installed, and only what the project links is built.

option(GLINT_BUILD_APPS "Build the command line, the scenes and the benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(GLINT_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(GLINT_BUILD_PLATFORM "Build glint::gles, glint::egl and glint::osmesa, which show pictures" ON)
option(GLINT_BUILD_IMAGEIO "Build glint::imageio, which reads and writes image files" ON)
option(GLINT_INSTALL "Install what is built, and the package by which other projects find it" ${PROJECT_IS_TOP_LEVEL})
set(GLINT_ISAS "all" CACHE STRING "Instruction sets to trace with beside plain C++: all, or some, as in avx2;avx512")
option(GLINT_WERROR "Treat warnings as errors" OFF)
option(GLINT_FUZZERS "Build the fuzzers, and no other test; with Clang only" OFF)
set(GLINT_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined or thread")

if((GLINT_BUILD_APPS OR GLINT_BUILD_TESTS) AND NOT (GLINT_BUILD_PLATFORM AND GLINT_BUILD_IMAGEIO))
    message(FATAL_ERROR "The programs and the tests use every library of Glint's: without GLINT_BUILD_PLATFORM or "
        "GLINT_BUILD_IMAGEIO, say GLINT_BUILD_APPS=OFF and GLINT_BUILD_TESTS=OFF, too")
endif()

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Linked privately by every target of ours: the language, the warnings and the floating-point contract.
add_library(glint_build INTERFACE)
target_compile_features(glint_build INTERFACE cxx_std_20 c_std_11)
# -ffp-contract=off: a fused multiply-add rounds once where others round twice; the pixels must not depend on it.
target_compile_options(glint_build INTERFACE -ffp-contract=off -fvisibility=hidden
    $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wundef
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual>)
# GCC 12 sees overlapping copies in "literal" + std::string that are not there (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(glint_build INTERFACE -Wno-restrict)
endif()
if(GLINT_WERROR)
    target_compile_options(glint_build INTERFACE -Werror)
endif()
if(GLINT_SANITIZE)
    # -g1: functions and lines are all that the reports need; more makes the compiler half as fast.
    target_compile_options(glint_build INTERFACE -fsanitize=${GLINT_SANITIZE} -fno-omit-frame-pointer -g1
        -fno-sanitize-recover=all)
    target_link_options(glint_build INTERFACE -fsanitize=${GLINT_SANITIZE})
    # What GCC warns of after optimising is often not there once sanitizers add code of their own (GCC's manual advises
    # against -Werror beside them). The other builds warn of it.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(glint_build INTERFACE -Wno-array-bounds -Wno-stringop-overflow
            -Wno-stringop-overread -Wno-maybe-uninitialized)
    endif()
endif()
if(GLINT_FUZZERS)
    # libFuzzer follows the readers; which way a ray goes through a tree tells it nothing about a text.
    target_compile_options(glint_build INTERFACE -fsanitize=fuzzer-no-link
        -fsanitize-coverage-ignorelist=${PROJECT_SOURCE_DIR}/tests/fuzz/not_followed.txt)
    target_link_options(glint_build INTERFACE -fsanitize=fuzzer-no-link)
endif()
