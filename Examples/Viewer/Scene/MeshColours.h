// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   pictures and lookup tables for meshes
 */
#ifndef MeshColours_h
#define MeshColours_h

#include "vtkSmartPointer.h"

#include <string>

class vtkColorTransferFunction;
class vtkImageData;
class vtkScalarsToColors;
class ViewerMessages;
struct ViewerOptions;

/// Reads a PNG, JPEG, TIFF or BMP file. Throws ViewerError.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName, ViewerMessages& messages);

/// The palette of the options over a range, with their scale and colours out of range; by default,
/// a perceptually uniform palette from dark violet to yellow.
vtkSmartPointer<vtkColorTransferFunction> MakeColourFunction(
  const ViewerOptions& options, const double range[2]);

/// The same colours for mappers of surfaces. Vectors are mapped by magnitude. Of a logarithmic
/// scale, VTK's mappers need a vtkLookupTable.
vtkSmartPointer<vtkScalarsToColors> MakeColours(
  const ViewerOptions& options, const double range[2]);

/// Copies one result of MakeColours() to another.
void CopyColours(vtkScalarsToColors* from, vtkScalarsToColors* to);

/// Throws ViewerError if the options request a logarithmic scale, and the range of an array is not
/// above 0.
void CheckRange(const ViewerOptions& options, const std::string& array, const double range[2]);

#endif
