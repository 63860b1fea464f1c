// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   curved cells
 */
#ifndef ViewerPatches_h
#define ViewerPatches_h

#include "vtkSmartPointer.h"

class vtkAdaptiveRefinementMapper;
class vtkDepthTagMetric;
class vtkPolyData;
struct ViewerOptions;

/// Whether the mesh's triangles are parts of curved cells.
bool HasPatches(vtkPolyData* mesh);

/// Highest levels where triangles would deviate most from the cells' shape.
vtkSmartPointer<vtkDepthTagMetric> MakeErrorMetric(const ViewerOptions& options);

/// Shows isolines of an array with this range if the options request them.
void ShowIsolines(
  const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper, const double range[2]);

/// Shows the cells' edges if the options request them.
void ShowPatchEdges(const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper);

#endif
