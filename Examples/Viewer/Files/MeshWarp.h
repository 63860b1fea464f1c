// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshWarp
 * @brief   moves the points of a mesh by an array, such as displacements of an analysis
 */
#ifndef MeshWarp_h
#define MeshWarp_h

#include "vtkSmartPointer.h"

#include <string>

class ViewerMessages;
class vtkDataObject;

struct MeshWarp
{
  std::string Array; // of points, with 3 components; empty: the points stay where they are
  double Factor = 1.0;

  /// Returns a mesh with points moved by Factor times the array. Blocks without the array stay
  /// where they are, with a warning. Throws ViewerError if no block has it.
  vtkSmartPointer<vtkDataObject> Apply(vtkDataObject* data, ViewerMessages& messages) const;
};

#endif
