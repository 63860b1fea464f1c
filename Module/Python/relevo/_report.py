# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The environment of the package, for bug reports."""

from __future__ import annotations

import importlib.metadata
import os
import platform

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkRenderer

import relevo

from .version import VTK_VERSION

_PACKAGES = ("numpy", "pyvista", "vedo", "xarray", "rasterio")
_OPENGL = ("OpenGL vendor", "OpenGL renderer", "OpenGL version")


def _find_version(package: str) -> str:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


def _describe_opengl() -> list[tuple[str, str]]:
    """Return the driver that draws without a display."""
    if not hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
        return [("OpenGL", "Relevo was built without rendering, or without EGL")]
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.AddRenderer(vtkRenderer())
    window.SetSize(16, 16)
    window.Render()
    found = []
    for line in str(window.ReportCapabilities()).splitlines():
        name, _, value = line.partition(":")
        if name.strip().removesuffix(" string") in _OPENGL:
            found.append((name.strip().removesuffix(" string"), value.strip()))
    window.Finalize()
    return found or [("OpenGL", "no context")]


def make_report() -> str:
    """Return versions and the graphics driver, in lines of a name and a value."""
    rows = [
        ("Relevo", relevo.__version__),
        ("built for VTK", VTK_VERSION),
        ("VTK", vtkVersion.GetVTKVersion()),
        ("Python", platform.python_version()),
        ("system", platform.platform()),
        ("display", os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or "none"),
        *_describe_opengl(),
        *((package, _find_version(package)) for package in _PACKAGES),
    ]
    width = max(len(name) for name, _ in rows) + 1
    return "\n".join(f"{name + ':':{width}} {value}" for name, value in rows)
