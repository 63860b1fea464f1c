# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The attribute `relevo` of PyVista's meshes, which PyVista 0.48 and later loads with its first use.

The entry point `pyvista.accessors` names this module.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pyvista

import relevo

if TYPE_CHECKING:
    from ._intersection import Intersection
    from ._lic import LIC
    from ._micromesh import MicroMesh
    from ._patches import Patches
    from ._refined import Refined
    from ._relief import Relief
    from ._streamlines import Streamlines
    from ._volume import Volume


@pyvista.register_dataset_accessor("relevo", pyvista.DataObject)
class MeshFunctions:
    """The functions of the package for a mesh. Options and results are those of the functions."""

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    def refined(self, **options: Any) -> Refined:
        """Draw the surface, refined where the viewer needs detail, see relevo.refined()."""
        return relevo.refined(self._mesh, **options)

    def volume(self, array: str | None = None, **options: Any) -> Volume:
        """Draw the interior of 3D cells, see relevo.volume()."""
        return relevo.volume(self._mesh, array, **options)

    def micromesh(self, **options: Any) -> MicroMesh:
        """Encode a dense surface with displacements and draw it, see relevo.micromesh()."""
        return relevo.micromesh(self._mesh, **options)

    def patches(self, **options: Any) -> Patches:
        """Draw curved cells with their exact shape, see relevo.patches()."""
        return relevo.patches(self._mesh, **options)

    def lic(self, vectors: str | None = None, **options: Any) -> LIC:
        """Draw streaks along vectors, see relevo.lic()."""
        return relevo.lic(self._mesh, vectors, **options)

    def streamlines(self, vectors: str | None = None, **options: Any) -> Streamlines:
        """Draw streamlines along vectors, see relevo.streamlines()."""
        return relevo.streamlines(self._mesh, vectors, **options)

    def relief(self, **options: Any) -> Relief:
        """Draw reliefs, which are images with depth, see relevo.relief()."""
        return relevo.relief(self._mesh, **options)

    def intersection(self, other: Any = None) -> Intersection:
        """Find where the surface meets another one, or itself, see relevo.intersection()."""
        return relevo.intersection(self._mesh, other)
