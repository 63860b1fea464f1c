# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make images and displacements by images of heights, for the scripts in this folder."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import relevo
from vtkmodules.vtkCommonDataModel import vtkImageData


def make_image(
    columns: int,
    rows: int,
    components: int,
    kind: int,
    values: Callable[[float, float], Iterable[float]],
) -> vtkImageData:
    """Return an image. values(x, y) gives the components of a pixel, with x and y in [0, 1]."""
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.AllocateScalars(kind, components)
    for j in range(rows):
        for i in range(columns):
            for c, value in enumerate(values((i + 0.5) / columns, (j + 0.5) / rows)):
                image.SetScalarComponentFromDouble(i, j, 0, c, value)
    return image


def displace(heights: vtkImageData, scale: float) -> relevo.vtkDisplacement:
    height_map = relevo.vtkHeightMap()
    height_map.SetImageData(heights)
    displacement = relevo.vtkDisplacement()
    displacement.SetHeightMap(height_map)
    displacement.SetScale(scale)
    return displacement
