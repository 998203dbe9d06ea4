"""Conan 2's recipe: builds the checkout that it lies in.

    conan create packaging/conan --build=missing

The package keeps Glint's own CMake and pkg-config files: programs say find_package(glint) as they do elsewhere, and choose
the static or the shared library by the target's name.
"""

from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class GlintConan(ConanFile):
    name = "glint"
    version = "0.1.0"
    license = "MIT"
    description = "Ray tracing on the CPUs people already carry"
    settings = "os", "compiler", "build_type", "arch"
    options = {
        "imageio": [True, False],  # glint::imageio
        "platform": [True, False],  # glint::gles, glint::egl, glint::osmesa
        "system_libraries": [True, False],  # those of the machine, instead of Conan's
    }
    default_options = {"imageio": True, "platform": True, "system_libraries": False}
    generators = "CMakeDeps", "PkgConfigDeps"

    def export_sources(self):
        copy(self, "*", Path(self.recipe_folder).parents[1], self.export_sources_folder,
             excludes=("build/*", ".git/*", "scenes/sdl/generated/*", "tests/*"))

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        if self.options.system_libraries:
            return
        self.requires("glm/1.0.1", transitive_headers=True)
        self.requires("highway/1.2.0")
        self.requires("tinyobjloader/2.0.0-rc10")
        self.requires("fast_float/6.1.5")
        self.requires("xxhash/0.8.2")
        if self.options.imageio:
            self.requires("openimageio/2.5.16.0")
        if self.options.platform:
            self.requires("egl/system")
            self.requires("opengl-registry/20240721")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update({
            "GLINT_BUILD_APPS": False,
            "GLINT_BUILD_TESTS": False,
            "GLINT_BUILD_IMAGEIO": bool(self.options.imageio),
            "GLINT_BUILD_PLATFORM": bool(self.options.platform),
        })
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # Glint's own files say it
        self.cpp_info.builddirs = ["lib/cmake/glint"]
        self.cpp_info.libs = ["glint"]
