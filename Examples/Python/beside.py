# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Put PNG pictures of equal height side by side: beside.py LEFT.png RIGHT.png ... PICTURE.jpg"""

from __future__ import annotations

import numpy
from arguments import check_file, read_arguments
from numpy.typing import NDArray
from relevo.files import write_picture
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader


def read_picture(name: str) -> NDArray[numpy.uint8]:
    reader = vtkPNGReader()
    reader.SetFileName(check_file(name))
    reader.Update()
    picture = reader.GetOutput()
    columns, rows, _ = picture.GetDimensions()
    pixels: NDArray[numpy.uint8] = vtk_to_numpy(picture.GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[:, :, :3]


names = read_arguments()
pixels = numpy.concatenate([read_picture(name) for name in names[:-1]], axis=1)
image = vtkImageData()
image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, pixels.shape[2]), deep=True))
write_picture(names[-1], image, quality=88)
