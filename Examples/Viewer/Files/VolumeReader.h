// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads all cells of a mesh file, not only their surface
 */
#ifndef VolumeReader_h
#define VolumeReader_h

#include "vtkSmartPointer.h"

class ResultFile;
class StepFilter;
class ViewerMessages;
class vtkDataObject;

/// Returns a time step, a vtkDataSet or a composite data set, changed by the filter.
/// Throws ViewerError if there are no cells.
vtkSmartPointer<vtkDataObject> ReadVolume(
  ResultFile& file, int step, StepFilter& filter, ViewerMessages& messages);

#endif
