// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshReader
 * @brief   reads the surface of a mesh at each time step
 */
#ifndef MeshReader_h
#define MeshReader_h

#include "Files/SurfaceExtractor.h"

#include "vtkSmartPointer.h"

class ResultFile;
class StepFilter;
class ViewerMessages;
class vtkDataSet;
class vtkPolyData;

/// The surface of an unstructured grid.
enum class MeshCells
{
  Flat,   // the outer surface in flat polygons
  Curved, // patches if some cells are curved, otherwise flat polygons
  Patches // patches for all cells
};

/// A surface, and whether it comes from cells, which define their curvature.
struct SurfaceMesh
{
  vtkSmartPointer<vtkPolyData> Data;
  vtkSmartPointer<vtkDataSet> Cells; // the mesh that the surface bounds, or the surface itself
  bool IsOfCells;
};

class MeshReader
{
public:
  /// The file must outlive this object.
  MeshReader(ResultFile& file, ViewerMessages& messages);

  /**
   * Reads the polygons and strips of a time step, or the outer surface of other data sets, changed
   * by the filter. Throws ViewerError if there are none, or if a point is not finite.
   */
  SurfaceMesh Read(int step, StepFilter& filter, MeshCells cells);

private:
  ResultFile& File;
  ViewerMessages& Messages;
  SurfaceExtractor Extractor;
};

#endif
