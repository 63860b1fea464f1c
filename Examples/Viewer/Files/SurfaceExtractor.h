// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceExtractor
 * @brief   extracts the surface of each time step; faster if only arrays change
 */
#ifndef SurfaceExtractor_h
#define SurfaceExtractor_h

#include "vtkSmartPointer.h"

class ViewerMessages;
class vtkDataSet;
class vtkPolyData;

class SurfaceExtractor
{
public:
  SurfaceExtractor();
  ~SurfaceExtractor();

  /// Returns the outer faces of a data set with its arrays and "vtkOriginalCellIds". Of a data set
  /// with the points and cells of the last one, only arrays are copied.
  vtkSmartPointer<vtkPolyData> Extract(vtkDataSet* data, ViewerMessages& messages);

private:
  vtkSmartPointer<vtkPolyData> CopyArrays(vtkDataSet* data) const;

  vtkSmartPointer<vtkDataSet> Last;
  vtkSmartPointer<vtkPolyData> Surface; // of the last data set
};

#endif
