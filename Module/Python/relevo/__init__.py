# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive surface refinement on the GPU, for VTK.

Every class of Relevo, as C++ has it: `relevo.vtkAdaptiveRefinementMapper`, `relevo.vtkHeightMap`.
`relevo.arrays` moves heights and refined meshes to and from numpy.
"""

import importlib as _importlib
import pkgutil as _pkgutil

from .version import __version__

__all__ = []
for _module in sorted(module.name for module in _pkgutil.iter_modules(__path__)):
    # The extension modules; which of them there are depends on how Relevo was built.
    if not _module.startswith("Relevo"):
        continue
    for _name, _value in vars(_importlib.import_module("." + _module, __name__)).items():
        if not _name.startswith("_"):
            globals()[_name] = _value
            __all__.append(_name)
del _module, _name, _value
