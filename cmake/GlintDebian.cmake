# `cpack -G DEB`: the packages libglint0, libglint-dev, glint-imageio and glint-tools, a package for each component.
# What Debian wants of a package beside its files, packaging/debian/finish.cmake adds.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL runtime devel tools imageio)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_NAME glint)
set(CPACK_PACKAGE_VENDOR Glint)
set(CPACK_PACKAGE_CONTACT "Glint maintainers <maintainers@glint.invalid>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian/finish.cmake)
set(CPACK_GLINT_DEBIAN_FOLDER ${PROJECT_SOURCE_DIR}/packaging/debian)
set(CPACK_GLINT_CHANGELOG ${PROJECT_SOURCE_DIR}/CHANGELOG.md)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # dependencies are those of the libraries that are linked

# debian_package(<component> <package> <section> <summary> <what it is>)
macro(debian_package component package section summary description)
    string(TOUPPER ${component} key)
    set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package})
    set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${key}_DESCRIPTION "ray tracing on the CPUs people already carry: ${summary}
Glint is a portable, multithreaded Whitted ray tracer: it reads a scene,
traces it on every core, and leaves the pixels in a buffer, the same ones on
every processor.
.
${description}")
endmacro()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each has its own
set(release ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})

debian_package(runtime libglint0 libs "shared library"
"These are the C++ library and its C interface, for programs that were built
with them.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/debian/triggers)

debian_package(devel libglint-dev libdevel "development files"
"These are the headers, the static libraries, among them those that show
pictures through OpenGL ES, and what CMake and pkg-config need to find them.")
set(CPACK_DEBIAN_DEVEL_PACKAGE_DEPENDS "libglint0 (= ${release}), libglm-dev")
set(CPACK_DEBIAN_DEVEL_PACKAGE_RECOMMENDS "glint-imageio")

debian_package(imageio glint-imageio libs "image files"
"This is the module by which programs that use Glint read and write image files.
They load it when they need it.")

debian_package(tools glint-tools graphics "command line"
"This is the program glint, which renders scene files, shows them, and measures
how long that takes.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "glint-imageio, libegl1, libsdl2-2.0-0")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "libosmesa6")

include(CPack)
