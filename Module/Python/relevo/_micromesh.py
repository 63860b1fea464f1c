# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Dense meshes as coarse meshes with displacements."""

from __future__ import annotations

import os
import pathlib
import tempfile
from collections.abc import Sequence
from typing import Any

from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataSet,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkRenderingCore import vtkActor

import relevo

from . import _inputs, _section, _work, files
from ._drawing import Drawing
from ._error import Error
from ._messages import Messages, warn
from ._options import MeshOptions
from ._refined import Refined
from ._typing import Camera, Path

EXTENSION = ".rmm"
_TOLERANCE = "0.1%"
_LEVEL = 5
_HIGHEST_LEVEL = 7
_Encoder = relevo.vtkMicroMeshFilter | relevo.vtkMicroMeshContourFilter
_SHARE = 0.1  # of the deviation, for meshes without a camera


def is_micro_mesh(data: vtkDataObject) -> bool:
    """Return whether a data object is the output of vtkMicroMeshFilter."""
    return bool(
        isinstance(data, vtkPolyData) and data.GetFieldData().HasArray("MicroMeshDisplacements")
    )


def _is_solid(data: vtkDataObject) -> bool:
    return any(_section.is_solid(block) for block in _inputs.get_blocks(data))


def _take_volume(data: vtkDataObject) -> vtkImageData | vtkUnstructuredGrid:
    """Return a mesh as an input of vtkMicroMeshContourFilter."""
    blocks = _inputs.get_blocks(data)
    if len(blocks) == 1 and isinstance(blocks[0], vtkImageData):
        return blocks[0]
    return _inputs.make_grid(data)


def _find_contour_array(mesh: vtkDataSet, name: str | None) -> str:
    """Return the name of an array of points with one component."""
    points = mesh.GetPointData()
    if name is not None:
        found, of_points = _inputs.find_array([mesh], name)
        if not of_points or found.GetNumberOfComponents() != 1:
            raise ValueError(f"array: {name!r} must be an array of points with one component")
        return name
    scalars = points.GetScalars()
    if scalars is not None and scalars.GetNumberOfComponents() == 1 and not scalars.GetName():
        scalars.SetName("Scalars")
    candidates = [scalars, *(points.GetArray(own) for own in _inputs.list_arrays([mesh])[0])]
    for own in candidates:
        if own is not None and own.GetName() and own.GetNumberOfComponents() == 1:
            chosen: str = own.GetName()
            return chosen
    raise ValueError("isosurfaces needs an array of points with one component")


def _find_tolerance(tolerance: Any, mesh: vtkDataSet) -> float:
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
        options: MeshOptions,
        tolerance: Any,
        max_level: int | None,
        error: float,
        isosurfaces: Any,
        array: str | None,
    ) -> None:
        _inputs.check_number(error, "error")
        values = _inputs.check_numbers(isosurfaces, "isosurfaces")
        if array is not None and not values:
            raise ValueError("array needs isosurfaces")
        data, _ = self._take(mesh, options)
        self.micro = vtkPolyData()
        if is_micro_mesh(data):
            _refuse_options(
                tolerance=tolerance, max_level=max_level, isosurfaces=values or None
            )
            self.micro.ShallowCopy(data)
        else:
            tolerance = _TOLERANCE if tolerance is None else tolerance
            max_level = _LEVEL if max_level is None else max_level
            _inputs.check_number(max_level, "max_level", integer=True)
            if values:
                self._encode_isosurfaces(data, values, array, tolerance, max_level)
            else:
                self._encode_surface(data, tolerance, max_level)
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
        self._set_lighting(options.lighting)

    def _encode(
        self, encode: _Encoder, mesh: vtkDataSet, tolerance: Any, max_level: int
    ) -> None:
        encode.SetInputData(mesh)
        names = {"Tolerance": "tolerance", "MaximumLevel": "max_level"}
        with Messages(ValueError, names):
            encode.SetTolerance(_find_tolerance(tolerance, mesh))
            encode.SetMaximumLevel(max_level)
        with Messages(names=names):
            _work.update(encode)
        self.micro.ShallowCopy(encode.GetOutput())

    def _encode_surface(self, data: vtkDataObject, tolerance: Any, max_level: int) -> None:
        if _is_solid(data):
            warn(
                "the mesh has 3D cells, and the micro-mesh is their outer surface; isosurfaces"
                " encodes surfaces of equal values"
            )
        mesh = _inputs.extract_surface(data)
        self._encode(relevo.vtkMicroMeshFilter(), mesh, tolerance, max_level)
        if self.micro.GetNumberOfCells() == 0:
            raise Error("the mesh has no triangles to encode")

    def _encode_isosurfaces(
        self,
        data: vtkDataObject,
        values: Sequence[float],
        array: str | None,
        tolerance: Any,
        max_level: int,
    ) -> None:
        if not _is_solid(data):
            raise ValueError("isosurfaces needs 3D cells, and the mesh has none")
        mesh = _take_volume(data)
        name = _find_contour_array(mesh, array)
        contour = relevo.vtkMicroMeshContourFilter()
        contour.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
        for i, value in enumerate(values):
            contour.SetValue(i, value)
        self._encode(contour, mesh, tolerance, max_level)
        if self.micro.GetNumberOfCells() == 0:
            low, high = mesh.GetPointData().GetArray(name).GetFiniteRange(0)
            raise ValueError(
                f"there is no isosurface at these values: {name!r} is from {low:g} to {high:g}"
            )

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
