// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the array that a volume shows
 */
#ifndef VolumeArray_h
#define VolumeArray_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
struct ViewerOptions;

struct VolumeArray
{
  std::string Name;
  std::string Unit; // "" if unknown
  bool IsOfPoints;
  bool IsVector;   // shown by its magnitude
  double Range[2]; // range of the finite values of all blocks, never empty; only 3D cells count
  // Quantiles of a sample of the values; empty if no value is finite.
  std::vector<double> Quantiles;
};

/// Whether a cell is 3D. Other cells are not drawn.
bool IsVolumeCell(vtkDataSet* block, vtkIdType cell);

/// The array named by the options, of points if possible, otherwise of cells. By default the active
/// scalars or the first array. Throws ViewerError with the names of the existing arrays.
VolumeArray FindVolumeArray(const ViewerOptions& options, vtkDataObject* data);

#endif
