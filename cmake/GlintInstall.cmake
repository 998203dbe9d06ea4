# What an installed Glint offers other projects: find_package(glint) and the targets glint::core, glint::shared, ...
# Each library's own folder installs it into the export set "glint"; here the set gets its names and its package files.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/glint)

foreach(library IN ITEMS core shared imageio gles egl osmesa)
    if(TARGET glint_${library})
        set_target_properties(glint_${library} PROPERTIES EXPORT_NAME ${library}) # glint::core here and there
    endif()
endforeach()
install(EXPORT glint NAMESPACE glint:: DESTINATION ${package_folder} FILE glintTargets.cmake)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/glintConfig.cmake.in
    ${PROJECT_BINARY_DIR}/package/glintConfig.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/glintConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/glintConfig.cmake ${PROJECT_BINARY_DIR}/package/glintConfigVersion.cmake
    DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
