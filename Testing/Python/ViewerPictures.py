# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and compares pictures for tests."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGReader


def read_picture(name):
    """Rows of (red, green, blue), lowest first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(name))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = image.GetPointData().GetScalars()
    return [
        [
            tuple(values.GetComponent(j * width + i, c) for c in range(3))
            for i in range(width)
        ]
        for j in range(height)
    ]


def read_colours(name):
    """Colours from 0 to 255, as an array of rows from the top, columns and components."""
    reader = vtkPNGReader()
    reader.SetFileName(str(name))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    colours = vtk_to_numpy(image.GetPointData().GetScalars())
    return colours.reshape(height, width, -1)[::-1].astype(int)


def mean_of_blocks(path, side=20):
    """Mean colours of blocks, because details depend on noise and graphics card."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(reader.GetOutputPort())
    shrink.SetShrinkFactors(side, side, 1)
    shrink.AveragingOn()
    shrink.Update()
    scalars = shrink.GetOutput().GetPointData().GetScalars()
    return [scalars.GetTuple(i)[:3] for i in range(scalars.GetNumberOfTuples())]


def largest_difference(path, other):
    """The largest difference of the mean colours of blocks."""
    means = [mean_of_blocks(file) for file in (path, other)]
    assert len(means[0]) == len(means[1]), f"{path} and {other} differ in size"
    return max(abs(a - b) for colours in zip(*means) for a, b in zip(*colours))


def limit_for_decimated(limit):
    """The limit of largest_difference() for a mesh from VTK's decimation, which changed with 9.4."""
    is_changed = vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() >= 904
    return 40 if is_changed else limit


def find(picture, is_shown):
    """Left, right, lowest and highest pixel for which a function of red, green and blue is true."""
    pixels = [
        (i, j)
        for j, row in enumerate(picture)
        for i, colour in enumerate(row)
        if is_shown(*colour)
    ]
    columns, rows = zip(*pixels)
    return min(columns), max(columns), min(rows), max(rows)


def is_surface(red, green, blue):
    """Whether a pixel is not sky, which is blue."""
    return blue < red + 10


def is_dark(red, green, blue):
    """Whether a pixel has the colour of text and lines over the picture."""
    return max(red, green, blue) < 60
