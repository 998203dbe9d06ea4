# glint_test(<name> <sources...>): one GoogleTest program; each of its tests becomes a ctest test "<name>.<sentence>".
# It may include the core's insides as "room/file.hpp".
# Tests of the core's rooms carry the label "core" and are built by the target core_tests: they need no display, driver
# or program, and run under the sanitizers every time.
find_package(GTest REQUIRED)
include(GoogleTest)
add_custom_target(core_tests)

function(glint_test name)
    add_executable(${name} ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/core ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE glint_core glint_build GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE GLINT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               GLINT_BINARY_DIR="${PROJECT_BINARY_DIR}")
    if(GLINT_SANITIZE)
        target_compile_definitions(${name} PRIVATE GLINT_SANITIZED)
    endif()
    gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600 LABELS "${GLINT_TEST_LABEL}")
    if(GLINT_TEST_LABEL STREQUAL core)
        add_dependencies(core_tests ${name})
    endif()
endfunction()
