// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   streaks along a mesh's vectors
 */
#ifndef ViewerFlow_h
#define ViewerFlow_h

#include "vtkSmartPointer.h"

class vtkAdaptiveRefinementMapper;
class vtkDataArray;
class vtkDepthTagMetric;
class vtkPolyData;
struct ViewerOptions;

/// One that shows streaks, where the options ask for them.
vtkSmartPointer<vtkAdaptiveRefinementMapper> MakeMapper(const ViewerOptions& options);

/**
 * The vectors that the options name, of the mesh's points if they have them, else of its cells.
 * Throws ViewerError, with those that there are, where there are none of that name.
 */
vtkDataArray* FindVectors(const ViewerOptions& options, vtkPolyData* mesh, bool& isOfPoints);

/// Has the mapper follow them.
void SetVectorArray(vtkAdaptiveRefinementMapper* mapper, vtkDataArray* vectors, bool isOfPoints);

/// Has NaN stand for no data, so that points without data look as the surface between them does.
void MarkNoData(vtkDataArray* vectors);

/// The smallest and the largest length, of vectors that are data.
void GetLengthRange(vtkDataArray* vectors, double range[2]);

/// Deepest where the vectors vary, and no side of a triangle long on the screen.
vtkSmartPointer<vtkDepthTagMetric> MakeFlowMetric(const ViewerOptions& options);

#endif
