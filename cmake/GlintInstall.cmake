# Where the parts of an installed Glint go. "runtime" is the shared library, "imageio" the module that brings a hundred
# libraries along, "tools" the command line and its scene, "devel" all that programs are built with.
include(GNUInstallDirs)

# glint_install_libraries(<glint_name>...): each becomes the target glint::<name> of the package, and the folder's
# public headers go with them.
function(glint_install_libraries)
    foreach(library IN LISTS ARGN)
        string(REGEX REPLACE "^glint_" "" name ${library})
        set_target_properties(${library} PROPERTIES EXPORT_NAME ${name}) # glint::core here and there
    endforeach()
    if(NOT GLINT_INSTALL)
        return()
    endif()
    install(TARGETS ${ARGN} EXPORT glint
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT devel
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT devel)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/include)
        install(DIRECTORY include/glint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT devel)
    endif()
endfunction()
