// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   pictures and tables of colours for meshes
 */
#ifndef MeshColours_h
#define MeshColours_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkScalarsToColors;
class ViewerMessages;

/// A PNG, JPEG, TIFF or BMP; throws ViewerError.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName, ViewerMessages& messages);

/// From dark violet to yellow, in even steps to the eye; of vectors by their lengths.
vtkSmartPointer<vtkScalarsToColors> MakeColours(const double range[2]);

#endif
