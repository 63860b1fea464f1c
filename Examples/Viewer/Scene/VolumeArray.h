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
  std::string Unit; // "" where it is not known
  bool IsOfPoints;
  bool IsVector;   // shown by its length
  double Range[2]; // of the finite values of all blocks, never empty; only 3D cells count
  // As many values are between each and the next; none if nothing is finite. Of a sample of them.
  std::vector<double> Quantiles;
};

/// Whether a cell is 3D: others are not drawn.
bool IsVolumeCell(vtkDataSet* block, vtkIdType cell);

/// The array that the options name, of points if there is one, else of cells; by default the
/// active scalars, or the first array. Throws ViewerError, with those that there are.
VolumeArray FindVolumeArray(const ViewerOptions& options, vtkDataObject* data);

#endif
