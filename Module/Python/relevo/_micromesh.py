# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Dense meshes as coarse meshes with displacements."""

from __future__ import annotations

import os
import pathlib
import tempfile
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _camera, _inputs, _work, files
from ._drawing import Drawing
from ._error import Error
from ._messages import Messages
from ._refined import Refined
from ._typing import Camera, Path

EXTENSION = ".rmm"
_TOLERANCE = "0.1%"
_LEVEL = 5
_HIGHEST_LEVEL = 7
_SHARE = 0.1  # of the deviation, for meshes without a camera


def is_micro_mesh(data: vtkDataObject) -> bool:
    """Return whether a data object is the output of vtkMicroMeshFilter."""
    return bool(
        isinstance(data, vtkPolyData) and data.GetFieldData().HasArray("MicroMeshDisplacements")
    )


def _find_tolerance(tolerance: Any, mesh: vtkPolyData) -> float:
    """Return a length. Texts such as "0.1%" are percentages of the diagonal."""
    if isinstance(tolerance, str):
        text = tolerance.strip()
        try:
            share = float(text.removesuffix("%")) / 100
        except ValueError:
            share = -1.0
        if not text.endswith("%") or not share > 0:
            raise ValueError(
                f"tolerance must be a length or a percentage of the diagonal such as '0.1%',"
                f" not {tolerance!r}"
            )
        return share * float(mesh.GetLength())
    _inputs.check_number(tolerance, "tolerance")
    return float(tolerance)


def _refuse_options(**options: Any) -> None:
    given = [name for name, value in options.items() if value is not None]
    if given:
        raise ValueError(
            f"{given[0]} is for meshes that are encoded, and this is a micro-mesh, which has its own;"
            f" encode the dense mesh again, or omit {given[0]}"
        )


class MicroMesh(Refined):
    """A micro-mesh, see relevo.micromesh().

    micro: the coarse mesh with displacements, a vtkPolyData. deviation: a bound of the distances
    between the dense mesh and the result, in both directions, as a length.
    """

    micro: vtkPolyData
    deviation: float

    def __init__(
        self,
        mesh: Any,
        tolerance: Any,
        max_level: int | None,
        error: float,
        up: str,
        lighting: bool,
        time: float | None = None,
    ) -> None:
        self._up = _camera.find_axis(up)
        _inputs.check_number(error, "error")
        data = self._take(mesh, time)
        self.micro = vtkPolyData()
        if is_micro_mesh(data):
            _refuse_options(tolerance=tolerance, max_level=max_level)
            self.micro.ShallowCopy(data)
        else:
            tolerance = _TOLERANCE if tolerance is None else tolerance
            max_level = _LEVEL if max_level is None else max_level
            _inputs.check_number(max_level, "max_level", integer=True)
            self._encode(_inputs.extract_surface(data), tolerance, max_level)
        bounds = self.micro.GetFieldData().GetArray("MicroMeshError")
        self.deviation = bounds.GetRange(0)[1] if bounds else float("nan")
        self._coarse = self.micro
        Drawing.__init__(self, relevo.vtkAdaptiveRefinementMapper(), vtkActor())
        metric = relevo.vtkMicroMeshErrorDepthTagMetric()
        self.recipe = relevo.vtkAdaptiveRefinement()
        self.recipe.SetSurface(relevo.vtkMicroMeshSurface())
        self.recipe.SetMetric(metric)
        self.recipe.SetLevelRuleToPerEdge()
        self.recipe.SetMaximumLevel(_HIGHEST_LEVEL)
        with Messages(ValueError, {"ScreenSpaceError": "error"}):
            metric.SetScreenSpaceError(error)
        self._set_up(self._find_scalars())
        self._set_lighting(lighting)

    def _encode(self, mesh: vtkPolyData, tolerance: Any, max_level: int) -> None:
        encode = relevo.vtkMicroMeshFilter()
        encode.SetInputData(mesh)
        names = {"Tolerance": "tolerance", "MaximumLevel": "max_level"}
        with Messages(ValueError, names):
            encode.SetTolerance(_find_tolerance(tolerance, mesh))
            encode.SetMaximumLevel(max_level)
        with Messages(names=names):
            _work.update(encode)
        if encode.GetOutput().GetNumberOfCells() == 0:
            raise Error("the mesh has no triangles to encode")
        self.micro.ShallowCopy(encode.GetOutput())

    def _describe(self) -> str:
        faces = self.micro.GetNumberOfCells()
        return f"{faces} faces, within {self.deviation:.3g}{self._describe_colours()}"

    def _make_mesh(self, camera: Camera) -> vtkDataObject:
        if camera is not None:
            return super()._make_mesh(camera)
        recipe = relevo.vtkAdaptiveRefinement()
        recipe.SetSurface(self.recipe.GetSurface())
        recipe.SetMaximumLevel(_HIGHEST_LEVEL)
        metric = relevo.vtkMicroMeshErrorDepthTagMetric()
        metric.SetMaximumError(_SHARE * self.deviation if self.deviation > 0 else 1e-9)
        recipe.SetMetric(metric)
        recipe.SetLevelRuleToPerEdge()
        refine = relevo.vtkAdaptiveRefinementFilter()
        refine.SetInputData(self.micro)
        refine.SetRefinement(recipe)
        _work.update(refine)
        return refine.GetOutput()

    def save(self, path: Path) -> None:
        """Write the micro-mesh (.rmm), a picture (.png, .jpg) or mesh() (.vtp, .ply, .stl).

        Raises ValueError for another extension, and OSError if the file cannot be written.
        """
        if pathlib.Path(path).suffix.lower() != EXTENSION:
            super().save(path)
            return
        writer = relevo.vtkMicroMeshWriter()
        writer.SetInputData(self.micro)
        with tempfile.TemporaryDirectory() as folder:
            written = os.path.join(folder, "mesh" + EXTENSION)
            writer.SetFileName(written)
            with Messages():
                writer.Write()
            files.write(path, pathlib.Path(written).read_bytes())
