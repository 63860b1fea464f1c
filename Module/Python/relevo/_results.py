# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads meshes and results of simulations, with their time steps, from files."""

from __future__ import annotations

import errno
import importlib
import json
import math
import os
import pathlib
import xml.etree.ElementTree
from collections.abc import Callable, Iterator
from typing import Any, Protocol

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

from . import _plot3d, _work
from ._error import Error
from ._messages import Messages, warn
from ._typing import Path

_HDF = b"\x89HDF\r\n\x1a\n"


def check_file(path: Path) -> str:
    """Return a path as a string. Raise FileNotFoundError if the file does not exist."""
    path = os.fspath(path)
    if not os.path.exists(path):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), path)
    return path


class Reader(Protocol):
    """A source of data with time steps."""

    def get_times(self) -> list[float]:
        """Return the times in increasing order, without duplicates."""

    def read(self, time: float | None) -> vtkDataObject:
        """Return the data of a time, which is one of get_times(), or of the first."""


class AlgorithmReader:
    """An algorithm of VTK as a reader."""

    def __init__(self, algorithm: vtkAlgorithm) -> None:
        self._algorithm = algorithm

    def get_times(self) -> list[float]:
        with Messages():
            self._algorithm.UpdateInformation()
        information = self._algorithm.GetOutputInformation(0)
        key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        times = information.Get(key) if information and information.Has(key) else ()
        return sorted({float(time) for time in times if math.isfinite(time)})

    def read(self, time: float | None) -> vtkDataObject:
        if time is not None:
            key = vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()
            self._algorithm.GetOutputInformation(0).Set(key, time)
        _work.update(self._algorithm)
        output: vtkDataObject = self._algorithm.GetOutputDataObject(0)
        # The algorithm uses its output again for the next step.
        data: vtkDataObject = output.NewInstance()
        data.ShallowCopy(output)
        return data


class _Collection:
    """The files that a ParaView data file (.pvd) lists for its time steps."""

    def __init__(self, path: str) -> None:
        try:
            root = xml.etree.ElementTree.parse(path).getroot()
        except xml.etree.ElementTree.ParseError as error:
            raise Error(f"{path}: it is not XML: {error}") from None
        entries = root.find("Collection")
        if entries is None:
            raise Error(f"{path}: it is not XML with a Collection of files")
        self._files: dict[float, list[str]] = {}
        for number, entry in enumerate(entries.iter("DataSet"), 1):
            name = entry.get("file")
            if not name:
                raise Error(f"{path}: entry {number} of its Collection names no file")
            try:
                time = float(entry.get("timestep", 0.0))
            except ValueError:
                time = math.nan
            if not math.isfinite(time):
                raise Error(f"{path}: the time of {name} is not a number")
            file = os.path.join(os.path.dirname(path), name)
            self._files.setdefault(time, []).append(file)
        if not self._files:
            raise Error(f"{path}: it lists no files")

    def get_times(self) -> list[float]:
        return sorted(self._files)

    def read(self, time: float | None) -> vtkDataObject:
        parts = []
        for path in self._files[min(self._files) if time is None else time]:
            check_damage(check_file(path))
            parts.append(_make_reader("vtkIOXML", "vtkXMLGenericDataObjectReader", path).read(None))
        if len(parts) == 1:
            return parts[0]
        blocks = vtkMultiBlockDataSet()
        for i, part in enumerate(parts):
            blocks.SetBlock(i, part)
        return blocks


class _Series:
    """The files that a series of ParaView (.vtu.series and likewise) lists, a JSON file."""

    def __init__(self, path: str) -> None:
        try:
            with open(path, encoding="utf-8") as file:
                entries = json.load(file)["files"]
        except (ValueError, KeyError, TypeError):
            entries = None
        if not isinstance(entries, list):
            raise Error(f"{path}: it is not JSON with a list of files")
        self._files: dict[float, str] = {}
        for number, entry in enumerate(entries):
            name = entry.get("name") if isinstance(entry, dict) else None
            if not isinstance(name, str) or not name:
                raise Error(f"{path}: entry {number + 1} of its files has no name")
            time = entry.get("time", number)  # without times, steps are counted
            if isinstance(time, bool) or not isinstance(time, (int, float)):
                raise Error(f"{path}: the time of {name} is not a number")
            if not math.isfinite(time):
                raise Error(f"{path}: the time of {name} is not a number")
            if pathlib.Path(name).suffix.lower() == ".series":
                raise Error(f"{path}: a series cannot list another one")
            self._files[float(time)] = os.path.join(os.path.dirname(path), name)
        if not self._files:
            raise Error(f"{path}: it lists no files")

    def get_times(self) -> list[float]:
        return sorted(self._files)

    def read(self, time: float | None) -> vtkDataObject:
        path = self._files[min(self._files) if time is None else time]
        return open_file(path)[0].read(None)


def _make_algorithm(module: str, name: str) -> Any:
    package = module if module == "relevo" else f"vtkmodules.{module}"
    return getattr(importlib.import_module(package), name)()


def _make_reader(module: str, name: str, path: str) -> AlgorithmReader:
    algorithm = _make_algorithm(module, name)
    algorithm.SetFileName(path)
    return AlgorithmReader(algorithm)


def _check_start(path: str, kind: str, starts: tuple[bytes, ...]) -> None:
    """Raise Error for a file of another format. Its reader would print, or end the program.

    A file of HDF5 must also be as long as its header says.
    """
    with open(path, "rb") as file:
        header = file.read(64)
    if not header.startswith(starts):
        raise Error(f"{path}: it is not a file of {kind}")
    if header.startswith(_HDF):
        version = header[8] if len(header) == 64 else 255
        header = header.ljust(64, b"\0")
        width = header[13 if version < 2 else 9]
        # Two addresses are before that of the end.
        first = {0: 24, 1: 28, 2: 12, 3: 12}.get(version, 0) + 2 * width
        end = int.from_bytes(header[first : first + width], "little")
        if width not in (4, 8) or version > 3 or os.path.getsize(path) < end:
            raise Error(f"{path}: the file is damaged or truncated")


def _open_cgns(path: str) -> Reader:
    _check_start(path, "CGNS", (_HDF, b"@(#)ADF"))
    reader = _make_algorithm("vtkIOCGNSReader", "vtkCGNSReader")
    reader.SetFileName(path)
    with Messages():
        reader.UpdateInformation()  # finds the names of bases and arrays
    reader.EnableAllBases()
    reader.EnableAllFamilies()
    reader.EnableAllPointArrays()
    reader.EnableAllCellArrays()
    return AlgorithmReader(reader)


def _open_ensight(path: str) -> Reader:
    reader = _make_algorithm("vtkIOEnSight", "vtkGenericEnSightReader")
    reader.SetCaseFileName(path)
    return AlgorithmReader(reader)


def _open_exodus(path: str) -> Reader:
    _check_start(path, "Exodus", (_HDF, b"CDF"))
    reader = _make_algorithm("vtkIOExodus", "vtkExodusIIReader")
    reader.SetFileName(path)
    # Readers apply the displacement by default; results are drawn where they are.
    reader.ApplyDisplacementsOff()
    with Messages():
        reader.UpdateInformation()  # finds the names of arrays
    for kind in (reader.NODAL, reader.ELEM_BLOCK):
        reader.SetAllArrayStatus(kind, 1)
    return AlgorithmReader(reader)


def _open_hdf(path: str) -> Reader:
    _check_start(path, "VTK in HDF5", (_HDF,))
    return _make_reader("vtkIOHDF", "vtkHDFReader", path)


def _open_amr(path: str) -> Reader:
    reader = _make_algorithm("vtkIOXML", "vtkXMLUniformGridAMRReader")
    reader.SetFileName(path)
    reader.SetMaximumLevelsToReadByDefault(0)  # all levels
    return AlgorithmReader(reader)


def _open_hyper_tree_grid(path: str) -> Reader:
    """Open the leaves of the trees as hexahedra or quadrilaterals."""
    reader = _make_algorithm("vtkIOXML", "vtkXMLHyperTreeGridReader")
    reader.SetFileName(path)
    leaves = _make_algorithm("vtkFiltersHyperTree", "vtkHyperTreeGridToUnstructuredGrid")
    leaves.SetInputConnection(reader.GetOutputPort())
    return AlgorithmReader(leaves)


def _open_plot3d(path: str) -> Reader:
    reader = _make_algorithm("vtkIOParallel", "vtkMultiBlockPLOT3DReader")
    reader.AutoDetectFormatOn()
    reader.SetFileName(path)
    solution = _plot3d.find_solution(path)
    if solution:
        reader.SetQFileName(solution)
        for function in (110, 120, 200):  # pressure, temperature, velocity
            reader.AddFunction(function)
    return AlgorithmReader(reader)


def _open_foam(path: str) -> Reader:
    reader = _make_algorithm("vtkIOGeometry", "vtkOpenFOAMReader")
    reader.SetFileName(path)
    reader.CreateCellToPointOn()
    return AlgorithmReader(reader)


def _open_geometry(path: str) -> Reader:
    """Open a .g file: of Exodus (netCDF files, classic or of HDF5), PLOT3D or Movie.BYU."""
    with open(path, "rb") as file:
        start = file.read(8)
    if start.startswith((b"CDF", _HDF)):
        return _open_exodus(path)
    if _plot3d.is_grid(path):
        return _open_plot3d(path)
    reader = _make_algorithm("vtkIOGeometry", "vtkBYUReader")
    reader.SetGeometryFileName(path)
    return AlgorithmReader(reader)


# How files with an extension are opened: by a function, or by the module and the class of a reader.
_FORMATS: dict[str, Callable[[str], Reader] | tuple[str, str]] = {
    ".bpt": ("relevo", "vtkBezierPatchReader"),
    ".case": _open_ensight,
    ".cgns": _open_cgns,
    ".e": _open_exodus,
    ".ex2": _open_exodus,
    ".exo": _open_exodus,
    ".exoii": _open_exodus,
    ".foam": _open_foam,
    ".g": _open_geometry,
    ".glb": ("vtkIOGeometry", "vtkGLTFReader"),
    ".gltf": ("vtkIOGeometry", "vtkGLTFReader"),
    ".htg": _open_hyper_tree_grid,
    ".obj": ("vtkIOGeometry", "vtkOBJReader"),
    ".off": ("vtkIOGeometry", "vtkOFFReader"),  # since VTK 9.4
    ".p3d": ("vtkIOParallel", "vtkPlot3DMetaReader"),
    ".ply": ("vtkIOPLY", "vtkPLYReader"),
    ".pvd": _Collection,
    ".pvti": ("vtkIOXML", "vtkXMLPImageDataReader"),
    ".pvtp": ("vtkIOXML", "vtkXMLPPolyDataReader"),
    ".pvtr": ("vtkIOXML", "vtkXMLPRectilinearGridReader"),
    ".pvts": ("vtkIOXML", "vtkXMLPStructuredGridReader"),
    ".pvtu": ("vtkIOXML", "vtkXMLPUnstructuredGridReader"),
    ".rmm": ("relevo", "vtkMicroMeshReader"),
    ".series": _Series,
    ".stl": ("vtkIOGeometry", "vtkSTLReader"),
    ".vth": _open_amr,
    ".vthb": _open_amr,
    ".vti": ("vtkIOXML", "vtkXMLImageDataReader"),
    ".vtk": ("vtkIOLegacy", "vtkGenericDataObjectReader"),
    ".vtkhdf": _open_hdf,
    ".vtm": ("vtkIOXML", "vtkXMLMultiBlockDataReader"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
    ".vtr": ("vtkIOXML", "vtkXMLRectilinearGridReader"),
    ".vts": ("vtkIOXML", "vtkXMLStructuredGridReader"),
    ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"),
}


# Formats without a reader in VTK.
_CONVERTED = {".med": "MED", ".mesh": "MEDIT", ".meshb": "MEDIT", ".msh": "Gmsh"}


def _find_format(path: str) -> Callable[[str], Reader] | tuple[str, str] | None:
    extension = pathlib.Path(path).suffix.lower()
    if extension in _plot3d.EXTENSIONS and _plot3d.is_grid(path):
        return _open_plot3d
    if extension in _CONVERTED:
        return _refuse
    return _FORMATS.get(extension)


def _refuse(path: str) -> Reader:
    own = pathlib.Path(path)
    raise Error(
        f"{path}: VTK has no reader for files of {_CONVERTED[own.suffix.lower()]}; convert it, for"
        f" example with meshio: meshio convert {own.name} {own.with_suffix('.vtu').name}"
    )


def is_mesh_file(path: Path) -> bool:
    """Return whether a file is a mesh by its extension, or by its content if that is ambiguous."""
    return _find_format(os.fspath(path)) is not None


def check_damage(path: str) -> None:
    """Raise Error for a damaged file with which the reader of VTK crashes, or that it accepts."""
    try:
        from . import _filechecks
    except ImportError:  # a build of VTK without VTK::IOGeometry
        return
    try:
        with Messages():
            warnings = _filechecks.check(path)
        for text in warnings:
            warn(text)
    except ValueError as error:
        raise Error(f"{path}: {error}") from None


def open_file(path: Path) -> tuple[Reader, str]:
    """Return the reader of a file, and the path as a string."""
    path = check_file(path)
    extension = pathlib.Path(path).suffix.lower()
    found = _find_format(path)
    if found is None:
        raise ValueError(f"{path}: meshes have the extensions {', '.join(sorted(_FORMATS))}")
    check_damage(path)
    try:
        return found(path) if callable(found) else _make_reader(*found, path), path
    except (ImportError, AttributeError):
        version = vtkVersion.GetVTKVersion()
        raise Error(f"{path}: VTK {version} cannot read {extension} files") from None


def _find_time(times: list[float], time: float | None, title: str) -> float | None:
    """Return the step that is nearest to a time, or the first one."""
    if time is None:
        return times[0] if times else None
    if not times:
        raise ValueError(f"{title} has no time steps")
    wanted = time
    found = min(times, key=lambda own: abs(own - wanted))
    if not times[0] <= time <= times[-1]:
        warn(
            f"time {time:g} is outside of the times of {title}, {times[0]:g} to {times[-1]:g}; the"
            f" nearest one is {found:g}"
        )
    return found


def _list_cells(block: vtkDataObject) -> list[vtkCellArray]:
    if isinstance(block, vtkPolyData):
        cells = [block.GetVerts(), block.GetLines(), block.GetPolys(), block.GetStrips()]
    elif isinstance(block, vtkUnstructuredGrid):
        cells = [block.GetCells()]
    else:
        return []
    return [own for own in cells if own and own.GetNumberOfConnectivityIds()]


def _check_corners(data: vtkDataObject, path: str) -> None:
    """Raise Error if a cell has a point that does not exist."""
    blocks: list[Any] = [data]
    if isinstance(data, vtkCompositeDataSet):
        blocks = []
        iterator = data.NewIterator()
        while not iterator.IsDoneWithTraversal():
            blocks.append(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
    if not any(isinstance(block, vtkDataSet) for block in blocks):
        raise Error(f"{path}: it has no data set with points and cells")
    for block in blocks:
        first = 0
        for cells in _list_cells(block):
            points = vtk_to_numpy(cells.GetConnectivityArray())
            number = block.GetNumberOfPoints()
            if points.min() < 0 or points.max() >= number:
                wrong = int(((points < 0) | (points >= number)).argmax())
                offsets = vtk_to_numpy(cells.GetOffsetsArray())
                cell = first + int(offsets.searchsorted(wrong, side="right")) - 1
                raise Error(
                    f"{path}: cell {cell} refers to point {points[wrong]}, but there are {number}"
                    " points"
                )
            first += cells.GetNumberOfCells()


def _read_step(
    reader: Reader, time: float | None, title: str
) -> tuple[vtkDataObject, float | None]:
    times = reader.get_times()
    found = _find_time(times, time, title)
    return reader.read(found), found if len(times) > 1 else None


def read(path: Path, time: float | None = None) -> tuple[vtkDataObject, float | None]:
    """Return the data of the time step that is nearest to a time; of the first one without.

    The second value is the time of the step, or None if there are not several.
    """
    reader, path = open_file(path)
    data, found = _read_step(reader, time, path)
    _check_corners(data, path)
    return data, found


def update(algorithm: vtkAlgorithm, time: float) -> tuple[vtkDataObject, float | None]:
    """Return the output of an algorithm for the time step that is nearest to a time, and that time
    as read()."""
    return _read_step(AlgorithmReader(algorithm), time, algorithm.GetClassName())


def find_current_time(algorithm: vtkAlgorithm) -> float | None:
    """Return the time of the output of an algorithm, or None if it has not several time steps."""
    if len(AlgorithmReader(algorithm).get_times()) < 2:
        return None
    information = algorithm.GetOutputDataObject(0).GetInformation()
    key = vtkDataObject.DATA_TIME_STEP()
    return float(information.Get(key)) if information.Has(key) else None


def read_all(source: Any) -> Iterator[vtkDataObject]:
    """Yield the data of all time steps of a path or an algorithm; nothing for other sources."""
    reader: Reader
    title = type(source).__name__
    if isinstance(source, (str, os.PathLike)):
        reader, title = open_file(source)
    elif isinstance(source, vtkAlgorithm):
        reader = AlgorithmReader(source)
    else:
        return
    for time in reader.get_times():
        data = reader.read(time)
        _check_corners(data, title)
        yield data
