// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   hair on a mesh
 */
#ifndef ViewerHair_h
#define ViewerHair_h

#include "vtkSmartPointer.h"

class vtkActor;
class vtkPolyData;
class ViewerMessages;
struct ViewerOptions;

/// Adds the number of hairs in the options. Throws ViewerError if the surface has no area.
vtkSmartPointer<vtkActor> GrowHair(
  const ViewerOptions& options, vtkPolyData* surface, ViewerMessages& messages);

#endif
