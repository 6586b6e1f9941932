# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipe of Conan, for the library without programs (src/doc/packaging.md)."""

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import get


class PclOps(ConanFile):
    name = "pcl_ops"
    license = "BSD-3-Clause"
    description = "Finds all planes of unorganized point clouds"
    settings = "os", "arch", "compiler", "build_type"
    requires = "pcl/[>=1.12]", "eigen/[>=3.4 <4]"

    def layout(self):
        cmake_layout(self, src_folder="src")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for option in ("PCL_OPS_BUILD_LAB", "PCL_OPS_BUILD_APPS", "PCL_OPS_BUILD_PYTHON",
                       "BUILD_TESTING"):
            toolchain.cache_variables[option] = "OFF"
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The package has a config file of its own, which Conan must not replace.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/pcl_ops"]
