// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkIntersectionWay
 * @brief   the filters that find where two surfaces meet
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

  /// Of meshes of triangles that are shared with no other way, or have not been used.
  BenchmarkIntersectionWay(Kind kind, vtkPolyData* first, vtkPolyData* second);
  ~BenchmarkIntersectionWay();

  static std::string GetName(Kind kind);

  /// The second mesh. vtkIntersectionPolyDataFilter gets a moved copy, which takes no time.
  void Move(vtkMatrix4x4* matrix);
  void Update();
  /// What was found: segments, or contacts.
  vtkIdType GetNumberOfSegments() const;
  /// The triangles that are said to meet.
  Pairs GetPairs() const;
  /// All in which a whole line of vtkIntersectionPolyDataFilter's is, up to 0.001: a line that
  /// several pairs have in common has the ids of one.
  Pairs GetUnnamedPairs() const;

private:
  Kind Policy;
  vtkSmartPointer<vtkPolyData> First;
  vtkSmartPointer<vtkPolyData> Second;
  vtkSmartPointer<vtkPolyDataAlgorithm> Filter;
  vtkNew<vtkMatrix4x4> Matrices[2];
};

#endif
