# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive surface refinement on the GPU, for VTK.

The package has all wrapped classes of Relevo with their C++ names, for example
`relevo.vtkAdaptiveRefinementMapper` and `relevo.vtkHeightMap`. `relevo.arrays` converts heights,
refined meshes and images from and to numpy arrays.
"""

import importlib as _importlib
import pkgutil as _pkgutil

from .version import __version__

__all__ = []
for _module in sorted(module.name for module in _pkgutil.iter_modules(__path__)):
    # The extension modules depend on the options of the build.
    if not _module.startswith("Relevo"):
        continue
    for _name, _value in vars(_importlib.import_module("." + _module, __name__)).items():
        if not _name.startswith("_"):
            globals()[_name] = _value
            __all__.append(_name)
del _module, _name, _value
