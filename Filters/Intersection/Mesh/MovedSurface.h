// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MovedSurface
 * @brief   the triangles of a mesh, moved by a matrix, with a tree of boxes that is kept
 *
 * Points that coincide in the mesh are one place, named by its lowest point id. The tree is built
 * once and follows the matrix.
 *
 * Private to the module's own sources.
 */
#ifndef MovedSurface_h
#define MovedSurface_h

#include "Mesh/BoxTree.h"
#include "Mesh/Motion.h"
#include "RelevoFiltersIntersectionModule.h" // for export macro
#include "vtkSmartPointer.h"                 // for members
#include "vtkType.h"                         // for vtkIdType

#include <array>  // for members
#include <memory> // for members
#include <string> // for return values
#include <vector> // for members

class vtkAbstractArray;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;

namespace relevo
{
class SurfaceTriangles;

/// What is wrong with a mesh's polygons and strips, as "has no polygons", or nothing.
std::string CheckSurface(vtkPolyData* mesh);

class RELEVOFILTERSINTERSECTION_EXPORT MovedSurface
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  MovedSurface();
  ~MovedSurface();

  /// Whether the mesh has the points, polygons, strips and ghosts that were taken, unchanged.
  bool IsOf(vtkPolyData* mesh) const;
  /// Take a mesh without its ghost cells, and the ids to give its cells; none for their own.
  /// Returns what CheckSurface() has.
  std::string Take(vtkPolyData* mesh, std::vector<vtkIdType> cells = {});
  /// Move it from where it was taken. Returns what is wrong then, or nothing.
  std::string Move(const Motion& motion);
  /// Forget all.
  void Clear();

  vtkIdType GetNumberOfTriangles() const;
  /// The places of the corners.
  const Triangle& GetCorners(vtkIdType triangle) const;
  vtkIdType GetCell(vtkIdType triangle) const;
  vtkIdType GetNumberOfPoints() const;
  /// Where a place, or another point of a triangle, is now.
  const double* GetPoint(vtkIdType point) const { return &this->Moved[3 * point]; }
  std::array<const double*, 3> GetPoints(vtkIdType triangle) const;
  /// Whether the triangle has an area now; others are in the tree as well.
  bool HasArea(vtkIdType triangle) const { return this->Areas[triangle] != 0; }
  /// How many triangles have none, or two corners at one place.
  vtkIdType GetNumberOfFlatTriangles() const { return this->NumberOfFlatTriangles; }
  /// Whether any has an area.
  bool HasFaces() const
  {
    return this->NumberOfFlatTriangles <
      this->GetNumberOfTriangles() + this->NumberOfCollapsedTriangles;
  }
  /// The items are triangles.
  const BoxTree& GetTree() const { return this->Tree; }
  /// Whether each edge between places is of exactly two triangles.
  bool IsClosed() const;

private:
  bool MovePoints(const Motion& motion);
  std::vector<Box> MeasureTriangles() const;

  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkCellArray> Polygons;
  vtkSmartPointer<vtkCellArray> Strips;
  vtkSmartPointer<vtkAbstractArray> Ghosts;
  std::array<vtkMTimeType, 4> State{}; // the latest of their times, and their sizes
  std::vector<vtkIdType> Cells;
  std::unique_ptr<SurfaceTriangles> Triangles;
  vtkIdType NumberOfCollapsedTriangles = 0;
  std::vector<unsigned char> AreUsed; // per point, whether it is a corner

  Motion Current;
  bool IsMoved = false; // by it
  std::vector<double> Moved;
  std::vector<unsigned char> Areas;
  vtkIdType NumberOfFlatTriangles = 0;
  BoxTree Tree;
  mutable int Closed = -1; // not known yet
};
}

#endif
