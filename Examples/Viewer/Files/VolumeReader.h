// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads all cells of a mesh file, not only their surface
 */
#ifndef VolumeReader_h
#define VolumeReader_h

#include "vtkSmartPointer.h"

class ResultFile;
class ViewerMessages;
class vtkDataObject;
struct MeshWarp;

/// Returns a time step, a vtkDataSet or a composite data set, with the points moved by the warp.
/// Throws ViewerError if there are no cells.
vtkSmartPointer<vtkDataObject> ReadVolume(
  ResultFile& file, int step, const MeshWarp& warp, ViewerMessages& messages);

#endif
