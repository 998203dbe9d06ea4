# glint_test(<name> <sources...>): one GoogleTest program; each of its tests becomes a ctest test "<name>.<sentence>".
# It may include the core's insides as "room/file.hpp".
find_package(GTest REQUIRED)
include(GoogleTest)

function(glint_test name)
    add_executable(${name} ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/core ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE glint_core glint_build GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE GLINT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               GLINT_BINARY_DIR="${PROJECT_BINARY_DIR}")
    if(GLINT_SANITIZE)
        target_compile_definitions(${name} PRIVATE GLINT_SANITIZED)
    endif()
    gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600)
endfunction()
