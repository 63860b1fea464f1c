# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Images, and displacement by those of heights, for the scripts beside this file."""

import relevo
from vtkmodules.vtkCommonDataModel import vtkImageData


def make_image(columns, rows, components, kind, values):
    """An image of so many pixels; values(x, y), from 0 to 1, gives the components of one."""
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.AllocateScalars(kind, components)
    for j in range(rows):
        for i in range(columns):
            for c, value in enumerate(values((i + 0.5) / columns, (j + 0.5) / rows)):
                image.SetScalarComponentFromDouble(i, j, 0, c, value)
    return image


def displace(heights, scale):
    height_map = relevo.vtkHeightMap()
    height_map.SetImageData(heights)
    displacement = relevo.vtkDisplacement()
    displacement.SetHeightMap(height_map)
    displacement.SetScale(scale)
    return displacement
