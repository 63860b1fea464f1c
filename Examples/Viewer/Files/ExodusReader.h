// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads the blocks of an Exodus II file, or their surface
 */
#ifndef ExodusReader_h
#define ExodusReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkPolyData;
class ViewerMessages;

/// Reads the first time step with the arrays of nodes and elements.
vtkSmartPointer<vtkDataObject> ReadExodusBlocks(
  const std::string& fileName, ViewerMessages& messages);

/// Reads the surface of the blocks.
vtkSmartPointer<vtkPolyData> ReadExodus(const std::string& fileName, ViewerMessages& messages);

#endif
