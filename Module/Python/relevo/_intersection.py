# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where two surfaces meet."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPolyDataMapper

import relevo

from . import _inputs, _outputs, _work
from ._drawing import Drawing
from ._refined import set_material
from ._typing import Camera

if TYPE_CHECKING:
    from . import _vtk


class Intersection(Drawing):
    """The curves and areas where two surfaces meet, see relevo.intersection()."""

    mapper: _vtk.vtkPolyDataMapper
    actor: _vtk.vtkAssembly

    def __init__(self, a: Any, b: Any) -> None:
        self._find = relevo.vtkSurfaceIntersectionFilter()
        self._find.JoinSegmentsOn()
        self._inputs = []
        for port, source in enumerate((a, b)):
            if source is None and port == 1:
                continue
            taken = _inputs.take_data(source, "ab"[port])
            self._kind = self._kind or taken.package
            self._inputs.append(_inputs.extract_surface(taken.data))
            self._find.SetInputData(port, self._inputs[-1])
        _work.update(self._find)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._find.GetOutput(0))
        mapper.ScalarVisibilityOff()
        super().__init__(mapper, vtkAssembly())
        curves = vtkActor()
        curves.SetMapper(mapper)
        curves.GetProperty().SetColor(0.85, 0.10, 0.10)
        curves.GetProperty().SetLineWidth(3)
        curves.GetProperty().LightingOff()
        self.actor.AddPart(curves)
        for surface, colour in zip(self._inputs, ((0.80, 0.78, 0.74), (0.55, 0.67, 0.80))):
            part = vtkActor()
            surface_mapper = vtkPolyDataMapper()
            surface_mapper.SetInputData(surface)
            surface_mapper.ScalarVisibilityOff()
            # Curves on the surfaces must not be hidden by them.
            surface_mapper.SetResolveCoincidentTopologyToPolygonOffset()
            surface_mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1)
            part.SetMapper(surface_mapper)
            set_material(part)
            part.GetProperty().SetColor(colour)
            self.actor.AddPart(part)

    @property
    def curves(self) -> Any:
        """The curves, as a mesh of poly-lines and of vertices where surfaces touch in a point.

        Cell arrays "Input0CellID" and "Input1CellID" are the cells that meet, "ComponentId" numbers
        connected curves.
        """
        return _outputs.to_kind(self._find.GetOutput(0), self._kind)

    @property
    def overlaps(self) -> Any:
        """The areas where coplanar triangles overlap, as a mesh of polygons."""
        return _outputs.to_kind(self._find.GetOutput(1), self._kind)

    @property
    def contacts(self) -> tuple[Any, ...]:
        """Copies of both surfaces, one without b, with the cell arrays "Contact" and "Distance".

        Contact is 0 for cells that are free, 2 for those that meet the other surface and 3 for
        those inside of it. Distance is that from the other surface, 0 for cells that meet it.
        """
        self._find.SetClassify(len(self._inputs) > 1)
        _work.update(self._find)
        outputs = (self._find.GetOutput(2 + port) for port in range(len(self._inputs)))
        return tuple(_outputs.to_kind(output, self._kind) for output in outputs)

    def _describe(self) -> str:
        curves = self._find.GetOutput(0).GetNumberOfCells()
        faces = " and ".join(str(surface.GetNumberOfCells()) for surface in self._inputs)
        return f"{curves} curves of {faces} faces"

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        return self._find.GetOutput(0)
