// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkIntersectionWay
 * @brief   the filters that intersect two surfaces
 */
#ifndef BenchmarkIntersectionWay_h
#define BenchmarkIntersectionWay_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <set>
#include <string>
#include <utility>

class vtkMatrix4x4;
class vtkPolyData;
class vtkPolyDataAlgorithm;

class BenchmarkIntersectionWay
{
public:
  enum Kind
  {
    Exact,      // vtkSurfaceIntersectionFilter
    Collisions, // vtkCollisionDetectionFilter, all contacts
    Lines,      // vtkIntersectionPolyDataFilter without splitting
    Splits      // the same with splitting, its default
  };
  using Pairs = std::set<std::pair<vtkIdType, vtkIdType>>;

  /// The triangle meshes must not be shared with other ways, or must not have been used.
  BenchmarkIntersectionWay(Kind kind, vtkPolyData* first, vtkPolyData* second);
  ~BenchmarkIntersectionWay();

  static std::string GetName(Kind kind);

  /// Moves the second mesh. vtkIntersectionPolyDataFilter gets a moved copy, whose creation is not
  /// timed.
  void Move(vtkMatrix4x4* matrix);
  void Update();
  /// Number of segments or contacts found.
  vtkIdType GetNumberOfSegments() const;
  /// The triangles reported as intersecting.
  Pairs GetPairs() const;
  /// All pairs that contain a whole line of vtkIntersectionPolyDataFilter, up to 0.001: a line
  /// shared by several pairs has the ids of one.
  Pairs GetUnnamedPairs() const;

private:
  Kind Policy;
  vtkSmartPointer<vtkPolyData> First;
  vtkSmartPointer<vtkPolyData> Second;
  vtkSmartPointer<vtkPolyDataAlgorithm> Filter;
  vtkNew<vtkMatrix4x4> Matrices[2];
};

#endif
