# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the caller's package, and files of meshes."""

import pathlib
import sys
import tempfile

from . import files

EXTENSIONS = (".vtp", ".vtu", ".vti", ".ply", ".stl")


def to_kind(mesh, package):
    """Return a vtkDataObject as a mesh of a package, "pyvista" or "vedo"; otherwise unchanged."""
    if package == "pyvista":
        return sys.modules["pyvista"].wrap(mesh)
    kinds = {"vtkPolyData": "Mesh", "vtkUnstructuredGrid": "UGrid"}
    if package == "vedo" and mesh.GetClassName() in kinds:
        return getattr(sys.modules["vedo"], kinds[mesh.GetClassName()])(mesh)
    return mesh


def check_extension(path):
    """Raise ValueError if no mesh can be written to such a file."""
    if pathlib.Path(path).suffix.lower() not in EXTENSIONS:
        raise ValueError(
            f"{str(path)!r} must end with .png, .jpg or, for a mesh, {', '.join(EXTENSIONS)}"
        )


def write_mesh(path, mesh):
    """Write a vtkDataObject as the extension says, see files.write()."""
    extension = pathlib.Path(path).suffix.lower()
    if extension in (".vtp", ".vtu", ".vti"):
        from vtkmodules.vtkIOXML import (
            vtkXMLImageDataWriter,
            vtkXMLPolyDataWriter,
            vtkXMLUnstructuredGridWriter,
        )

        kinds = {
            ".vtp": (vtkXMLPolyDataWriter, "vtkPolyData"),
            ".vtu": (vtkXMLUnstructuredGridWriter, "vtkUnstructuredGrid"),
            ".vti": (vtkXMLImageDataWriter, "vtkImageData"),
        }
        writer, kind = kinds[extension]
    elif extension == ".ply":
        from vtkmodules.vtkIOPLY import vtkPLYWriter as writer

        kind = "vtkPolyData"
    else:
        from vtkmodules.vtkIOGeometry import vtkSTLWriter as writer

        kind = "vtkPolyData"
    if not mesh.IsA(kind):
        raise ValueError(f"{str(path)!r}: the mesh is a {mesh.GetClassName()}, not a {kind}")
    writer = writer()
    writer.SetInputData(mesh)
    if extension in (".ply", ".stl"):
        writer.SetFileTypeToBinary()
    with tempfile.TemporaryDirectory() as folder:
        written = pathlib.Path(folder) / f"mesh{extension}"
        writer.SetFileName(str(written))
        writer.Write()
        files.write(path, written.read_bytes())
