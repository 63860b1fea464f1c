// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkPatchWay
 * @brief   the pipeline from a grid of curved cells to its picture
 */
#ifndef BenchmarkPatchWay_h
#define BenchmarkPatchWay_h

#include "vtkSmartPointer.h"

#include <string>

class vtkMapper;
class vtkPolyData;
class vtkUnstructuredGrid;

class BenchmarkPatchWay
{
public:
  enum Kind
  {
    Linear, // patches, scalars linear on coarse triangles
    Exact,  // patches, scalars exact at every pixel
    Even    // vtkDataSetSurfaceFilter at level 4, vtkPolyDataMapper
  };
  static constexpr int EvenLevel = 4;

  /// Patches have an error of half a pixel.
  BenchmarkPatchWay(Kind kind, vtkUnstructuredGrid* grid);
  ~BenchmarkPatchWay();

  static std::string GetName(Kind kind);

  vtkMapper* GetMapper() const { return this->Mapper; }

  /// Valid after a frame.
  double GetNumberOfTriangles() const;
  /// Bytes of the mapper's input and of its buffers, after a frame.
  double GetMemorySize() const;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkMapper> Mapper;
};

#endif
