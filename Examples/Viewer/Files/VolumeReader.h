// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads the cells in a mesh file, not only their surface
 */
#ifndef VolumeReader_h
#define VolumeReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class ViewerMessages;

/// What can be read, as ".vtk or .vtu files".
std::string GetVolumeFormats();

/// A vtkDataSet, or a composite data set of some. Throws ViewerError where there are no cells.
vtkSmartPointer<vtkDataObject> ReadVolume(const std::string& fileName, ViewerMessages& messages);

#endif
