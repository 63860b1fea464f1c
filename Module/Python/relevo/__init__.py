# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive surface refinement on the GPU, for VTK.

`relevo.show("file")` draws a file in a window. `relevo.terrain`, `refined`, `volume`, `patches`,
`lic`, `streamlines`, `relief`, `micromesh` and `intersection` draw files, arrays and meshes with
options, in windows, notebooks and pictures. `relevo.times` lists the time steps of a file.

The package also has all wrapped classes of Relevo with their C++ names, for example
`relevo.vtkAdaptiveRefinementMapper` and `relevo.vtkHeightMap`. `relevo.arrays` converts heights,
refined meshes and images from and to numpy arrays. dir(relevo) lists the classes, and
help(relevo.vtkHeightMap) shows one.
"""

from __future__ import annotations

import importlib as _importlib
import sys as _sys
from typing import Any as _Any

from .version import PYTHON_VERSION as _PYTHON_VERSION

if "{}.{}".format(*_sys.version_info[:2]) != _PYTHON_VERSION:
    raise ImportError(
        f"this relevo was built for Python {_PYTHON_VERSION}, but this is Python"
        f" {_sys.version.split()[0]}; build relevo again, or use that Python"
    )

from vtkmodules.vtkCommonCore import vtkVersion as _vtkVersion

from ._classes import EXTENSIONS as _EXTENSIONS
from .version import VTK_VERSION as _VTK_VERSION
from .version import __version__

if _vtkVersion.GetVTKVersion().split(".")[:2] != _VTK_VERSION.split(".")[:2]:
    # Classes of another version have other layouts in memory.
    raise ImportError(
        f"this relevo was built for VTK {_VTK_VERSION}, but vtkmodules has VTK"
        f" {_vtkVersion.GetVTKVersion()}; build relevo again, or install that VTK"
    )

if any(_name.startswith("RelevoRendering") for _name in _EXTENSIONS.values()):
    # VTK's renderers and actors need OpenGL before the first of them is created.
    import vtkmodules.vtkRenderingOpenGL2 as _opengl  # noqa: F401

_FUNCTIONS = {
    "Error": "_error",
    "terrain": "_functions",
    "refined": "_functions",
    "volume": "_functions",
    "patches": "_functions",
    "lic": "_functions",
    "streamlines": "_functions",
    "relief": "_functions",
    "micromesh": "_functions",
    "intersection": "_functions",
    "show": "_functions",
    "times": "_functions",
}

__all__ = [*_FUNCTIONS]  # help() and `import *` would be long with all classes


def __getattr__(name: str) -> _Any:
    """Import a class or function when it is used first, because some libraries load slowly."""
    if name in ("arrays", "files"):
        return _importlib.import_module("." + name, __name__)
    module = _EXTENSIONS.get(name) or _FUNCTIONS.get(name)
    if module is None:
        raise AttributeError(
            f"module 'relevo' has no attribute {name!r}", name=name, obj=_sys.modules[__name__]
        )
    value = getattr(_importlib.import_module("." + module, __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, *_EXTENSIONS})
