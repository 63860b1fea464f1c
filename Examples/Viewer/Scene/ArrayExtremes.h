// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   where an array has its largest and its smallest value
 */
#ifndef ArrayExtremes_h
#define ArrayExtremes_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkPlane;
class PictureMarks;

struct ArrayExtreme
{
  double Value = 0.0; // a number, or the length of a vector
  std::array<double, 3> Place;
  vtkSmartPointer<vtkDataSet> Mesh; // with the cell or the point
  vtkIdType Index = -1;             // of the point, or of the cell
};

/// Returns the smallest and the largest finite value of an array of points or cells in the blocks
/// of a mesh, or nothing. The place of a cell's value is the centre of its points. Points without
/// cells do not count, and places behind a plane, unless it is nullptr.
std::optional<std::pair<ArrayExtreme, ArrayExtreme>> FindExtremes(
  vtkDataObject* data, const std::string& array, bool isOfPoints, vtkPlane* plane);

/// Labels both with their values, and the numbers of their cells and points. `cells` is the mesh
/// whose numbers are shown; nullptr for that of each extreme.
void MarkExtremes(const std::pair<ArrayExtreme, ArrayExtreme>& extremes, bool isOfPoints,
  vtkDataSet* cells, PictureMarks& marks);

#endif
