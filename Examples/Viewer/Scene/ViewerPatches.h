// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   curved cells as they are
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

/// Deepest where triangles would be far from the cells' shape.
vtkSmartPointer<vtkDepthTagMetric> MakeErrorMetric(const ViewerOptions& options);

/// Lines of equal value, where the options ask for them, of an array with this range.
void ShowIsolines(
  const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper, const double range[2]);

/// The cells' edges, where the options ask for them.
void ShowPatchEdges(const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper);

#endif
