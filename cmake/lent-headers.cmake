# For cross-compilers: headers that are the same on every machine, as links in GLINT_LENT_HEADERS.
set(GLINT_LENT_HEADERS ${CMAKE_BINARY_DIR}/lent-headers)
foreach(name IN ITEMS include/EGL include/GLES2 include/GLES3 include/KHR include/fast_float include/glm include/hwy
        include/tiny_obj_loader.h include/xxh3.h include/xxhash.h share/cmake/glm)
    if(EXISTS /usr/${name} AND NOT EXISTS ${GLINT_LENT_HEADERS}/${name})
        cmake_path(GET name PARENT_PATH folder)
        file(MAKE_DIRECTORY ${GLINT_LENT_HEADERS}/${folder})
        file(CREATE_LINK /usr/${name} ${GLINT_LENT_HEADERS}/${name} SYMBOLIC)
    endif()
endforeach()
