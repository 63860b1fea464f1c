// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads the surface of the blocks in an Exodus II file
 */
#ifndef ExodusReader_h
#define ExodusReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class ViewerMessages;

/// The first time step, with the arrays of nodes and elements.
vtkSmartPointer<vtkPolyData> ReadExodus(const std::string& fileName, ViewerMessages& messages);

#endif
