# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Small results with time steps for tests of relevo-view and of drawings in Python."""

import os
import pathlib

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

# Results of other programs, in VTK's test data.
DATA = pathlib.Path(os.environ.get("RELEVO_TEST_DATA") or "/nonexistent") / "result"
TIMES = [0.25, 1.0, 4.0]
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def add_array(data, name, tuples):
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(tuples[0]))
    for values in tuples:
        array.InsertNextTuple(values)
    data.AddArray(array)


def make_cube(time=1.0, offset=0.0, names=("Heat", "Move")):
    """A hexahedron with Heat = time * x and Move = time * (0, x, 0)."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    for x, y, z in CORNERS:
        points.InsertNextPoint(x + offset, y, z)
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_HEXAHEDRON, 8, range(8))
    if "Heat" in names:
        add_array(grid.GetPointData(), "Heat", [(time * x,) for x, y, z in CORNERS])
    if "Move" in names:
        add_array(grid.GetPointData(), "Move", [(0.0, time * x, 0.0) for x, y, z in CORNERS])
    return grid


def write_list(folder, name, entries):
    """A .pvd file."""
    path = folder / name
    path.write_text(
        f'<?xml version="1.0"?><VTKFile type="Collection" version="0.1"><Collection>'
        f"{''.join(entries)}</Collection></VTKFile>"
    )
    return path


def write_series(folder, name, **keywords):
    """A .pvd file of cubes."""
    entries = []
    for i, time in enumerate(TIMES):
        part = f"{name}-{i}.vtu"
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(folder / part))
        writer.SetInputData(make_cube(time, **keywords))
        writer.Write()
        entries.append(f'<DataSet timestep="{time}" part="0" file="{part}"/>')
    return write_list(folder, name, entries)
