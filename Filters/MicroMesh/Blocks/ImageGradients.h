// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   gradients of an image at the points of its isosurface
 */
#ifndef ImageGradients_h
#define ImageGradients_h

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace relevo
{
/**
 * Add the point array "Gradients" (float, 3 components), in units of the scalars per length. It is
 * interpolated between the central differences at both ends of the point's edge of the image. At
 * the border of the image, differences are one-sided.
 */
void AddGradients(vtkImageData* image, vtkDataArray* scalars, vtkPolyData* surface);
}

#endif
