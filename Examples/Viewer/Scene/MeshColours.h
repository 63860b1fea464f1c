// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   pictures and lookup tables for meshes
 */
#ifndef MeshColours_h
#define MeshColours_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkScalarsToColors;
class ViewerMessages;

/// Reads a PNG, JPEG, TIFF or BMP file. Throws ViewerError.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName, ViewerMessages& messages);

/// A palette of --palette over a range; without a name, a perceptually uniform one from dark violet
/// to yellow. Vectors are mapped by magnitude.
vtkSmartPointer<vtkScalarsToColors> MakeColours(const std::string& palette, const double range[2]);

#endif
