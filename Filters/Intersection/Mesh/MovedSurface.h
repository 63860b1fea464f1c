// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MovedSurface
 * @brief   the triangles of a mesh, transformed by a matrix, with a cached tree of boxes
 *
 * Coincident points are merged to the lowest point id. The tree is built once and updated when the
 * matrix changes.
 *
 * Private to the module.
 */
#ifndef MovedSurface_h
#define MovedSurface_h

#include "Boxes/BoxTree.h"
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

/// Returns an error of the polygons and strips, such as "has no polygons", or "".
std::string CheckSurface(vtkPolyData* mesh);

class RELEVOFILTERSINTERSECTION_EXPORT MovedSurface
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  MovedSurface();
  ~MovedSurface();

  /// Whether the points, polygons, strips and ghost cells of the mesh are unchanged since Take().
  bool IsOf(vtkPolyData* mesh) const;
  /// Takes a mesh without its ghost cells. `cells` replaces the cell ids if it is not empty.
  /// Returns the error of CheckSurface(), or "".
  std::string Take(vtkPolyData* mesh, std::vector<vtkIdType> cells = {});
  /// Transforms the mesh from its original position. Returns an error, or "".
  std::string Move(const Motion& motion);
  /// Releases the mesh and all data.
  void Clear();

  vtkIdType GetNumberOfTriangles() const;
  /// Returns the merged points of the corners.
  const Triangle& GetCorners(vtkIdType triangle) const;
  vtkIdType GetCell(vtkIdType triangle) const;
  vtkIdType GetNumberOfPoints() const;
  /// Returns the transformed coordinates of a merged point, or another point of a triangle.
  const double* GetPoint(vtkIdType point) const { return &this->Moved[3 * point]; }
  std::array<const double*, 3> GetPoints(vtkIdType triangle) const;
  /// Whether the transformed triangle has an area. Triangles without area are in the tree too.
  bool HasArea(vtkIdType triangle) const { return this->Areas[triangle] != 0; }
  /// Returns the number of triangles without area, including those with two coincident corners.
  vtkIdType GetNumberOfFlatTriangles() const { return this->NumberOfFlatTriangles; }
  /// Whether any triangle has an area.
  bool HasFaces() const
  {
    return this->NumberOfFlatTriangles <
      this->GetNumberOfTriangles() + this->NumberOfCollapsedTriangles;
  }
  /// The items of the tree are triangles.
  const DoubleBoxTree& GetTree() const { return this->Tree; }
  /// Whether each edge between merged points has exactly two triangles.
  bool IsClosed() const;

private:
  bool MovePoints(const Motion& motion);
  std::vector<DoubleBox> MeasureTriangles() const;

  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkCellArray> Polygons;
  vtkSmartPointer<vtkCellArray> Strips;
  vtkSmartPointer<vtkAbstractArray> Ghosts;
  std::array<vtkMTimeType, 4> State{}; // latest modification time, and sizes
  std::vector<vtkIdType> Cells;
  std::unique_ptr<SurfaceTriangles> Triangles;
  vtkIdType NumberOfCollapsedTriangles = 0;
  std::vector<unsigned char> AreUsed; // one per point, whether it is a corner

  Motion Current;
  bool IsMoved = false; // whether Current is applied
  std::vector<double> Moved;
  std::vector<unsigned char> Areas;
  vtkIdType NumberOfFlatTriangles = 0;
  DoubleBoxTree Tree;
  mutable int Closed = -1; // -1 if unknown
};
}

#endif
