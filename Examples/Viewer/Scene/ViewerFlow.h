// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   streaks along the vectors of a mesh
 */
#ifndef ViewerFlow_h
#define ViewerFlow_h

#include "vtkSmartPointer.h"

class vtkAdaptiveRefinementMapper;
class vtkDataArray;
class vtkDepthTagMetric;
class vtkPolyData;
struct ViewerOptions;

/// Creates a mapper, which shows streaks if the options request them.
vtkSmartPointer<vtkAdaptiveRefinementMapper> MakeMapper(const ViewerOptions& options);

/// Sets the streaks of the options on a mapper that shows them.
void UpdateStreaks(const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper);

/**
 * The vectors named by the options, of points if possible, otherwise of cells. If there are none,
 * throws ViewerError with the names of the existing ones.
 */
vtkDataArray* FindVectors(const ViewerOptions& options, vtkPolyData* mesh, bool& isOfPoints);

/// Selects the mapper's vectors.
void SetVectorArray(vtkAdaptiveRefinementMapper* mapper, vtkDataArray* vectors, bool isOfPoints);

/// Replaces missing values by NaN, so that points without data look like the surface around them.
void MarkNoData(vtkDataArray* vectors);

/// The smallest and largest length of vectors that are not missing.
void GetLengthRange(vtkDataArray* vectors, double range[2]);

/// Highest levels where the vectors vary, and a limit for the length of edges on the screen.
vtkSmartPointer<vtkDepthTagMetric> MakeFlowMetric(const ViewerOptions& options);

#endif
