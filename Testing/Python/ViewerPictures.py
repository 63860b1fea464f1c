# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of relevo-view, for the tests of it."""

from vtkmodules.vtkIOImage import vtkPNGReader


def read_picture(name):
    """Rows of (red, green, blue), the lowest first."""
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


def find(picture, is_shown):
    """Left, right, lowest and highest pixel of some kind, told from red, green and blue."""
    pixels = [
        (i, j)
        for j, row in enumerate(picture)
        for i, colour in enumerate(row)
        if is_shown(*colour)
    ]
    columns, rows = zip(*pixels)
    return min(columns), max(columns), min(rows), max(rows)


def is_surface(red, green, blue):
    """Not the sky, which is blue."""
    return blue < red + 10


def is_dark(red, green, blue):
    """As letters and lines over the picture are."""
    return max(red, green, blue) < 60
