# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The attribute `relevo` of PyVista's plotters, which PyVista 0.48 and later loads with its first use.

The entry point `pyvista.plotter_components` names this module.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pyvista

import relevo

if TYPE_CHECKING:
    from ._drawing import Drawing
    from ._intersection import Intersection
    from ._lic import LIC
    from ._micromesh import MicroMesh
    from ._patches import Patches
    from ._refined import Refined
    from ._relief import Relief
    from ._streamlines import Streamlines
    from ._terrain import Terrain
    from ._volume import Volume


@pyvista.register_plotter_component("relevo")
class PlotterFunctions:
    """Methods that draw in a plotter, with the arguments of the functions of the package.

    They return the drawing. plotter.remove_actor(drawing.actors) removes it.
    """

    def __init__(self, plotter: Any) -> None:
        self._plotter = plotter

    def _add(self, drawing: Drawing) -> None:
        drawing.add_to(self._plotter)

    def add_terrain(self, source: Any, **options: Any) -> Terrain:
        """Add heights as a terrain, see relevo.terrain()."""
        drawing = relevo.terrain(source, **options)
        self._add(drawing)
        return drawing

    def add_refined(self, mesh: Any, **options: Any) -> Refined:
        """Add a surface, refined where the viewer needs detail, see relevo.refined()."""
        drawing = relevo.refined(mesh, **options)
        self._add(drawing)
        return drawing

    def add_volume(self, mesh: Any, array: str | None = None, **options: Any) -> Volume:
        """Add the interior of 3D cells, see relevo.volume()."""
        drawing = relevo.volume(mesh, array, **options)
        self._add(drawing)
        return drawing

    def add_micromesh(self, mesh: Any, **options: Any) -> MicroMesh:
        """Add a dense surface, encoded with displacements, see relevo.micromesh()."""
        drawing = relevo.micromesh(mesh, **options)
        self._add(drawing)
        return drawing

    def add_patches(self, mesh: Any, **options: Any) -> Patches:
        """Add curved cells with their exact shape, see relevo.patches()."""
        drawing = relevo.patches(mesh, **options)
        self._add(drawing)
        return drawing

    def add_lic(self, mesh: Any, vectors: str | None = None, **options: Any) -> LIC:
        """Add streaks along vectors, see relevo.lic()."""
        drawing = relevo.lic(mesh, vectors, **options)
        self._add(drawing)
        return drawing

    def add_streamlines(self, mesh: Any, vectors: str | None = None, **options: Any) -> Streamlines:
        """Add streamlines along vectors, see relevo.streamlines()."""
        drawing = relevo.streamlines(mesh, vectors, **options)
        self._add(drawing)
        return drawing

    def add_relief(self, source: Any, **options: Any) -> Relief:
        """Add reliefs, which are images with depth, see relevo.relief()."""
        drawing = relevo.relief(source, **options)
        self._add(drawing)
        return drawing

    def add_intersection(self, a: Any, b: Any = None) -> Intersection:
        """Add two surfaces and the curves where they meet, see relevo.intersection()."""
        drawing = relevo.intersection(a, b)
        self._add(drawing)
        return drawing
