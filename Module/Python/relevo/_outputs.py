# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the caller's package, and files of meshes."""

from __future__ import annotations

import importlib
import pathlib
import tempfile
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkDataObject

from . import files
from ._typing import Path

# Classes of vedo by those of VTK, with their names up to 2023.
_VEDO_KINDS = {"vtkPolyData": ("Mesh",), "vtkUnstructuredGrid": ("UnstructuredGrid", "UGrid")}
EXTENSIONS = (".vtp", ".vtu", ".vti", ".ply", ".stl")


def to_kind(mesh: vtkDataObject, package: str) -> Any:
    """Return a vtkDataObject as a mesh of a package, "pyvista" or "vedo"; otherwise unchanged."""
    if package == "pyvista":
        return importlib.import_module("pyvista").wrap(mesh)
    if package == "vedo":
        vedo = importlib.import_module("vedo")
        for name in _VEDO_KINDS.get(mesh.GetClassName(), ()):
            if hasattr(vedo, name):
                return getattr(vedo, name)(mesh)
    return mesh


def check_extension(path: Path) -> None:
    """Raise ValueError if no mesh can be written to such a file."""
    if pathlib.Path(path).suffix.lower() not in EXTENSIONS:
        raise ValueError(
            f"{str(path)!r} must end with .png, .jpg or, for a mesh, {', '.join(EXTENSIONS)}"
        )


def write_mesh(path: Path, mesh: vtkDataObject) -> None:
    """Write a vtkDataObject as the extension says, see files.write()."""
    extension = pathlib.Path(path).suffix.lower()
    writer: Any
    kind = "vtkPolyData"
    if extension in (".vtp", ".vtu", ".vti"):
        from vtkmodules.vtkIOXML import (
            vtkXMLImageDataWriter,
            vtkXMLPolyDataWriter,
            vtkXMLUnstructuredGridWriter,
        )

        kinds: dict[str, tuple[Any, str]] = {
            ".vtp": (vtkXMLPolyDataWriter, "vtkPolyData"),
            ".vtu": (vtkXMLUnstructuredGridWriter, "vtkUnstructuredGrid"),
            ".vti": (vtkXMLImageDataWriter, "vtkImageData"),
        }
        make_writer, kind = kinds[extension]
        writer = make_writer()
    elif extension == ".ply":
        from vtkmodules.vtkIOPLY import vtkPLYWriter

        writer = vtkPLYWriter()
    else:
        from vtkmodules.vtkIOGeometry import vtkSTLWriter

        writer = vtkSTLWriter()
    if not mesh.IsA(kind):
        raise ValueError(f"{str(path)!r}: the mesh is a {mesh.GetClassName()}, not a {kind}")
    writer.SetInputData(mesh)
    if extension in (".ply", ".stl"):
        writer.SetFileTypeToBinary()
    with tempfile.TemporaryDirectory() as folder:
        written = pathlib.Path(folder) / f"mesh{extension}"
        writer.SetFileName(str(written))
        writer.Write()
        files.write(path, written.read_bytes())
