# How other projects find an installed Glint: find_package(glint) and the targets glint::core, glint::shared, ..., and
# pkg-config's glint, glint-core, .... Both name places relative to themselves: the whole prefix may be moved.
include(CMakePackageConfigHelpers)

set(components)
foreach(component IN ITEMS core shared imageio gles egl osmesa)
    if(TARGET glint_${component})
        list(APPEND components ${component})
    endif()
endforeach()

# CMake: each library's own folder installs it into the export set "glint"; here the set gets its names and its files.
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/glint)
install(EXPORT glint NAMESPACE glint:: DESTINATION ${package_folder} FILE glintTargets.cmake COMPONENT devel)
block()
    list(JOIN components ", " components)
    configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/glintConfig.cmake.in
        ${PROJECT_BINARY_DIR}/package/glintConfig.cmake INSTALL_DESTINATION ${package_folder}
        PATH_VARS CMAKE_INSTALL_LIBDIR NO_CHECK_REQUIRED_COMPONENTS_MACRO)
endblock()
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/glintConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/glintConfig.cmake ${PROJECT_BINARY_DIR}/package/glintConfigVersion.cmake
    DESTINATION ${package_folder} COMPONENT devel)

# pkg-config: "glint" is what -lglint makes of it, the shared library or with -static the other; "glint-core" is always
# the static one.
file(RELATIVE_PATH prefix_from_here ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_here ${prefix_from_here})
file(RELATIVE_PATH libdir_from_prefix ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH includedir_from_prefix ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})

# glint_pkgconfig(<name> <description> <requires> <libs> <libs of a static library>)
function(glint_pkgconfig name description requires libs libs_private)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/glint.pc.in ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT devel)
endfunction()

set(glm)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(GLINT_GLM QUIET glm) # not every GLM says where it is
    if(GLINT_GLM_FOUND)
        set(glm glm)
    endif()
endif()
set(runtime "-pthread -lstdc++ -lm")
glint_pkgconfig(glint-core "${PROJECT_DESCRIPTION}: the static library" "${glm}" "-L\${libdir} -l:libglint.a ${runtime}" "")
if(TARGET glint_shared)
    glint_pkgconfig(glint "${PROJECT_DESCRIPTION}" "${glm}" "-L\${libdir} -lglint" "${runtime}")
else()
    glint_pkgconfig(glint "${PROJECT_DESCRIPTION}" "${glm}" "-L\${libdir} -lglint ${runtime}" "")
endif()
if(TARGET glint_imageio)
    glint_pkgconfig(glint-imageio "Image files for Glint's pictures" glint
        "-L\${libdir} -lglint_imageio -Wl,-rpath,\${libdir}/glint -ldl" "")
endif()
if(TARGET glint_gles)
    glint_pkgconfig(glint-gles "Glint's pictures through OpenGL ES" glint "-L\${libdir} -lglint_gles -ldl" "")
    glint_pkgconfig(glint-egl "Off-screen OpenGL ES for Glint, by EGL" glint-gles "-L\${libdir} -lglint_egl" "")
    glint_pkgconfig(glint-osmesa "Off-screen OpenGL ES for Glint, by OSMesa" glint-gles "-L\${libdir} -lglint_osmesa" "")
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
