// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads all cells of a mesh file, not only their surface
 */
#ifndef VolumeReader_h
#define VolumeReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class ViewerMessages;

/// The supported formats, as in ".vtk or .vtu files".
std::string GetVolumeFormats();

/// Returns a vtkDataSet or a composite data set. Throws ViewerError if there are no cells.
vtkSmartPointer<vtkDataObject> ReadVolume(const std::string& fileName, ViewerMessages& messages);

#endif
