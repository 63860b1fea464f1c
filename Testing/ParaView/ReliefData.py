# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reliefs and databases of reliefs for tests, their pictures in plain VTK, and moving views."""

import os
import re

import numpy
from paraview import servermanager
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkRenderingCore import vtkActor

import RelevoParaView as relevo

SIZE = 40


def relief(color=(0, 200, 100), x=0, height=3, size=SIZE):
    """A parallel relief: a wave with a hole, at this distance along x."""
    row, column = numpy.mgrid[:size, :size]
    depths = 5 + height * numpy.sin(0.15 * column) * numpy.cos(0.15 * row)
    depths[numpy.hypot(row - size / 2, column - size / 2) < size / 8] = numpy.nan
    colors = numpy.empty((size * size, 3), numpy.uint8)
    colors[:] = color
    colors[:, 0] = (200 * column / size).ravel()
    matrix = numpy.eye(4)
    matrix[0, 3] = x
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    for name, values, to in (
        ("Color", colors, image.GetPointData()),
        ("Depth", depths.astype(numpy.float32).ravel(), image.GetPointData()),
        ("ReliefProjection", numpy.zeros(1, numpy.int32), image.GetFieldData()),
        ("ReliefMatrix", matrix.ravel(), image.GetFieldData()),
    ):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        to.AddArray(array)
    return image


def pair():
    return [relief(), relief((0, 60, 220), SIZE + 4)]


def write_image(image, path):
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def write_database(folder, reliefs, times=None):
    """Writes a database of reliefs, as the pages describe it, with one time for each if given."""
    os.makedirs(folder)
    lines = ["name,time,FILE" if times else "name,FILE"]
    for i, image in enumerate(reliefs):
        write_image(image, os.path.join(folder, f"{i}.vti"))
        time = f"{times[i]}," if times else ""
        lines.append(f"relief {i},{time}{i}.vti")
    with open(os.path.join(folder, "data.csv"), "w", encoding="utf-8") as table:
        table.write("\n".join(lines) + "\n")
    return folder


def mapper(**properties):
    """A vtkReliefMapper, whose class Python does not know here."""
    proxy = servermanager.ProxyManager().NewProxy("relevo", "ReliefMapper")
    for each, value in properties.items():
        proxy.GetProperty(each).SetElement(0, value)
    proxy.UpdateVTKObjects()
    return proxy.GetClientSideObject()


def plain(view, reliefs, actor=None, **properties):
    """The picture of the mapper in plain VTK, with the camera and the size of a view."""
    blocks = vtkMultiBlockDataSet()
    for i, image in enumerate(reliefs):
        blocks.SetBlock(i, image)
    drawn = mapper(**properties)
    drawn.SetInputDataObject(blocks)
    actor = actor or vtkActor()
    actor.SetMapper(drawn)
    window = relevo.plain_window(view, actor)
    window.Render()
    return relevo.read_window(window)


def passes(view):
    """The counters of a view's vtkReliefPass, by names."""
    client = view.GetClientSideObject()
    every = map(client.GetRepresentation, range(client.GetNumberOfRepresentations()))
    text = next(str(each) for each in every if each.IsA("vtkReliefInteraction"))
    found = dict(re.findall(r"^\s*(\w+): (.*)$", text[text.index("Pass:") :], re.MULTILINE))
    return int(found["NumberOfCaptures"]), int(found["NumberOfReliefFrames"])


def move(view, azimuth=0):
    """An interactive frame of a view, after a turn of its camera in degrees."""
    view.GetActiveCamera().Azimuth(azimuth)
    view.SMProxy.InteractiveRender()
    return relevo.drawn(view)
