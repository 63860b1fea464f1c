# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A package for spack. It has not been tried, see Module/Documentation/packaging.md.

Copy this file to packages/relevo/package.py of a repository of packages, and build a clone:

    spack dev-build --source-path CLONE relevo@main
"""

from spack.package import *


class Relevo(CMakePackage):
    """VTK modules for adaptive refinement of meshes, terrain and volumes on the graphics card."""

    license("BSD-3-Clause")

    version("main", branch="main")

    variant("gdal", default=True, description="Read georeferenced rasters")
    variant("python", default=True, description="Build the Python package")
    variant("tools", default=True, description="Build relevo-view and relevo-pyramid")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.18:", type="build")
    depends_on("boost")
    depends_on("egl")
    depends_on("gdal", when="+gdal")
    depends_on("geographiclib")
    depends_on("gl@4:")
    depends_on("glm")
    depends_on("openimageio")
    depends_on("vtk@9.1:")
    depends_on("vtk+python", when="+python")
    extends("python@3.11:", when="+python")
    depends_on("py-numpy", type=("build", "run"), when="+python")

    def cmake_args(self):
        arguments = [
            self.define_from_variant("RELEVO_BUILD_EXAMPLES", "tools"),
            self.define_from_variant("RELEVO_WRAP_PYTHON", "python"),
            self.define("RELEVO_USE_GDAL", "ON" if self.spec.satisfies("+gdal") else "OFF"),
        ]
        if self.spec.satisfies("+python"):
            arguments += [
                self.define("Python3_EXECUTABLE", python.path),
                self.define("RELEVO_PYTHON_DESTINATION", python_platlib),
            ]
        return arguments
