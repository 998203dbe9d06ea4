# glint_test(<name> <sources...>): one GoogleTest program; each of its tests becomes a ctest test "<name>.<sentence>".
# It may include the core's insides as "room/file.hpp".
# Tests of the core's rooms carry the label "core" and are built by the target core_tests: they need no display, driver
# or program, and run under the sanitizers every time.
# Debian compiles GoogleTest for its own machine alone, but its sources come with it.
if(CMAKE_CROSSCOMPILING)
    find_package(Threads REQUIRED)
    add_library(glint_gtest STATIC ${GLINT_GTEST_SOURCE}/src/gtest-all.cc ${GLINT_GTEST_SOURCE}/src/gtest_main.cc)
    target_include_directories(glint_gtest SYSTEM PUBLIC ${GLINT_GTEST_SOURCE}/include PRIVATE ${GLINT_GTEST_SOURCE})
    target_link_libraries(glint_gtest PUBLIC Threads::Threads)
    target_compile_features(glint_gtest PUBLIC cxx_std_20)
    # The compiler takes longer than what it compiles. What it would warn of, it does where these tests belong.
    target_compile_options(glint_gtest PUBLIC -O1 -w)
    add_library(GTest::gtest_main ALIAS glint_gtest)
else()
    find_package(GTest REQUIRED)
endif()
include(GoogleTest)
add_custom_target(core_tests)

function(glint_test name)
    add_executable(${name} ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/core ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE glint_core glint_build GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE GLINT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               GLINT_BINARY_DIR="${PROJECT_BINARY_DIR}")
    # What takes long in a test takes long in the core.
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    # Headers are a third of a test's compilation. Where tests are compiled as released, each shows that it includes what
    # it uses; what comes on top of that need not.
    if(GLINT_SANITIZE OR CMAKE_CROSSCOMPILING)
        if(NOT TARGET math_tests OR name STREQUAL math_tests)
            target_precompile_headers(${name} PRIVATE <gtest/gtest.h> <glint/glint.hpp>)
        else()
            target_precompile_headers(${name} REUSE_FROM math_tests)
        endif()
    endif()
    if(GLINT_SANITIZE)
        target_compile_definitions(${name} PRIVATE GLINT_SANITIZED)
    endif()
    gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600 LABELS "${GLINT_TEST_LABEL}")
    if(GLINT_TEST_LABEL STREQUAL core)
        add_dependencies(core_tests ${name})
    endif()
endfunction()
