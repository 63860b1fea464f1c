// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceTriangles
 * @brief   the triangles of a mesh between merged points, and the triangles at each merged point
 *
 * Polygons are split into fans (0, i, i + 1), as VTK's mappers do, and strips into triangles.
 * Coincident points are merged; the lowest point id represents them. Triangles with coincident or
 * non-finite corners are skipped.
 */
#ifndef SurfaceTriangles_h
#define SurfaceTriangles_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkPoints.h"               // for GetPoint
#include "vtkSmartPointer.h"         // for members
#include "vtkType.h"                 // for vtkIdType

#include <array>  // for Triangle
#include <vector> // for members

class vtkCellArray;
class vtkPolyData;

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT SurfaceTriangles
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /// Holds a reference to the points of the mesh. Without uses, which need as much memory as the
  /// triangles, the triangles at points are not known.
  explicit SurfaceTriangles(vtkPolyData* mesh, bool withUses = true);

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  vtkIdType GetMergedPoint(vtkIdType point) const
  {
    return this->MergedPoints.empty() ? point : this->MergedPoints[point];
  }
  /// The lowest coincident point per point; empty if no points coincide.
  const std::vector<vtkIdType>& GetMergedPoints() const { return this->MergedPoints; }
  /// The points that are merged into another point.
  const std::vector<vtkIdType>& GetCoincidentPoints() const { return this->CoincidentPoints; }
  void GetPoint(vtkIdType point, double x[3]) const { this->Points->GetPoint(point, x); }

  /// All triangles; their corners are merged points.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// The original points of a triangle, which have the data of its corners.
  const Triangle& GetPoints(vtkIdType triangle) const
  {
    return this->PointTriangles.empty() ? this->Triangles[triangle]
                                        : this->PointTriangles[triangle];
  }
  /// The id of the mesh's cell that contains a triangle.
  vtkIdType GetCell(vtkIdType triangle) const { return this->Cells[triangle]; }

  vtkIdType GetNumberOfTriangles(vtkIdType mergedPoint) const
  {
    return this->Starts[mergedPoint + 1] - this->Starts[mergedPoint];
  }
  /// Call f(t) for the index of each triangle at the merged point.
  template <typename Function>
  void ForEachTriangleIndex(vtkIdType mergedPoint, Function&& f) const
  {
    for (vtkIdType i = this->Starts[mergedPoint]; i < this->Starts[mergedPoint + 1]; ++i)
    {
      f(this->Uses[i] / 3);
    }
  }
  /// Call f(p, q) for each triangle (mergedPoint, p, q).
  template <typename Function>
  void ForEachTriangle(vtkIdType mergedPoint, Function&& f) const
  {
    for (vtkIdType i = this->Starts[mergedPoint]; i < this->Starts[mergedPoint + 1]; ++i)
    {
      const Triangle& triangle = this->Triangles[this->Uses[i] / 3];
      const int corner = static_cast<int>(this->Uses[i] % 3);
      f(triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]);
    }
  }

private:
  void FindUses();
  void AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c);
  void AddPolygons(vtkCellArray* polygons, vtkIdType firstCell);
  void AddStrips(vtkCellArray* strips, vtkIdType firstCell);

  vtkSmartPointer<vtkPoints> Points;
  std::vector<vtkIdType> MergedPoints;
  std::vector<vtkIdType> CoincidentPoints;
  vtkIdType NumberOfPoints = 0;
  std::vector<Triangle> Triangles;
  std::vector<Triangle> PointTriangles; // empty if no points coincide
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Starts; // index into Uses per merged point
  std::vector<vtkIdType> Uses;   // 3 * triangle + corner
};
}

#endif
