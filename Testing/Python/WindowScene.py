# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Windows and their pictures, for tests of vtkWindowServer."""

import random

import relevo
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkActor2D,
    vtkImageMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)


def make_window(size=(200, 150), *, is_noisy=False):
    """An off-screen window with a cone, or with noise, which cannot be compressed."""
    if hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
        window = relevo.vtkEGLOffscreenRenderWindow()
    else:
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    renderer = vtkRenderer()
    renderer.SetBackground(0.1, 0.2, 0.4)
    renderer.AddActor(make_noise(size) if is_noisy else make_cone())
    window.AddRenderer(renderer)
    return window


def make_cone():
    cone = vtkConeSource()
    cone.SetResolution(24)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(cone.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def make_noise(size):
    image = vtkImageData()
    image.SetDimensions(*size, 1)
    values = vtkUnsignedCharArray()
    values.SetNumberOfComponents(3)
    values.SetNumberOfTuples(size[0] * size[1])
    memoryview(values).cast("B")[:] = random.Random(1).randbytes(3 * size[0] * size[1])
    image.GetPointData().SetScalars(values)
    mapper = vtkImageMapper()
    mapper.SetInputData(image)
    mapper.SetColorWindow(255)
    mapper.SetColorLevel(127.5)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    return actor


def pixels_of(image):
    width, height, _ = image.GetDimensions()
    scalars = image.GetPointData().GetScalars()
    pixels = bytearray(memoryview(scalars).cast("B"))
    if scalars.GetNumberOfComponents() == 4:
        del pixels[3::4]  # opacity
    return (width, height), bytes(pixels)


def own_picture(window):
    """The size and the pixels of a window as VTK reads them, without another frame."""
    reader = vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ShouldRerenderOff()
    reader.Update()
    return pixels_of(reader.GetOutput())


def read_picture(data):
    """The size and the pixels of a PNG file."""
    reader = vtkPNGReader()
    reader.SetMemoryBufferLength(len(data))
    reader.SetMemoryBuffer(data)
    reader.Update()
    return pixels_of(reader.GetOutput())


def frame_counter(window):
    """A list that gets an entry for each frame."""
    frames = []
    window.AddObserver("EndEvent", lambda *_: frames.append(None))
    return frames
