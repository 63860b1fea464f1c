// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DenseMesh
 * @brief   the triangles of the input between merged points, and the lines that must be kept
 *
 * Lines are edges at the border of the surface, sharp edges, edges between materials, and edges at
 * which points are split (seams). A vertex is an end of no line, on one line, or locked: at ends
 * and branches of lines, at edges of more than two triangles or of inconsistent winding, and where
 * several fans of triangles meet, and where the input's points are fixed.
 *
 * Coordinates are relative to the centre and scaled by a power of two, so that the box's largest
 * side is in (0.5, 1].
 */
#ifndef DenseMesh_h
#define DenseMesh_h

#include "Dense/LineTable.h"
#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h"
#include "vtkType.h" // for vtkIdType

#include <array>  // for members
#include <map>    // for members
#include <vector> // for members

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace relevo
{
class DenseMesh
{
public:
  enum class Kind : unsigned char
  {
    FREE,
    LINE,
    LOCKED
  };
  enum LineFlags : unsigned char
  {
    BORDER = 1,
    SHARP = 2,
    MATERIAL = 4,
    SEAM = 8,
    UNCLEAR = 16 // more than two triangles or inconsistent winding
  };
  using Triangle = std::array<int, 3>;

  /// Values of the array of fixed points. Removable points are fixed, too, unless they are on a
  /// border between other fixed points.
  static constexpr unsigned char FixedMark = 1;
  static constexpr unsigned char RemovableMark = 2;

  /// `materials` is a cell array or nullptr. `featureAngle` is in degrees. `fixed` is a point array
  /// or nullptr; points with a first component other than 0 are fixed. The next three components
  /// are their direction, unless they are 0.
  DenseMesh(vtkPolyData* input, vtkDataArray* materials, double featureAngle,
    vtkDataArray* fixed = nullptr);
  ~DenseMesh();

  /// The coordinates of a vertex in the input, and the conversion of coordinates from the input.
  dvec3 GetPlace(int vertex) const;
  dvec3 FromInput(const dvec3& place) const { return (place - this->Centre) / this->Scale; }
  /// Whether points of the input's type can have a coordinate, without rounding.
  bool CanStore(double coordinate) const;
  dvec3 GetNormal(const Triangle& triangle) const; // with twice the area as its length

  /// Per vertex.
  std::vector<dvec3> Points;
  std::vector<Kind> Kinds;
  LineTable LineEnds;
  /// The direction of the displacements at a vertex, if a fixed point has it; otherwise 0.
  vec3 GetFixedDirection(int vertex) const
  {
    const auto found = this->FixedDirections.find(vertex);
    return found == this->FixedDirections.end() ? vec3(0.0f) : found->second;
  }
  bool IsFixed(int vertex) const
  {
    return !this->AreFixed.empty() && this->AreFixed[static_cast<std::size_t>(vertex)] != 0;
  }
  /// The vertices per triangle.
  std::vector<Triangle> Triangles;

  /// Whether vertices represent several points of the input.
  bool HasWedges() const { return !this->Wedges.empty(); }
  /// The points of the input at a triangle, and its cell.
  Triangle GetWedges(std::size_t triangle) const
  {
    return this->HasWedges() ? this->Wedges[triangle] : this->GetWedges(this->Triangles[triangle]);
  }
  const std::vector<Triangle>& GetAllWedges() const { return this->Wedges; }
  vtkIdType GetCell(std::size_t triangle) const
  {
    return this->Cells.empty() ? static_cast<vtkIdType>(triangle) + this->FirstCell
                               : this->Cells[triangle];
  }
  /// The points of the input at vertices that represent one each.
  Triangle GetWedges(const Triangle& vertices) const
  {
    return { { this->PointIds[static_cast<std::size_t>(vertices[0])],
      this->PointIds[static_cast<std::size_t>(vertices[1])],
      this->PointIds[static_cast<std::size_t>(vertices[2])] } };
  }

  /// A length of the input divided by the same length here.
  double Scale = 1.0;
  dvec3 Centre = dvec3(0.0);

  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfDuplicates = 0;
  vtkIdType NumberOfUnclearEdges = 0;
  vtkIdType NumberOfSharpEdges = 0;

private:
  void ReadTriangles(vtkPolyData* input);
  void ScalePoints(vtkPolyData* input);
  void FindLines(vtkDataArray* materials, double featureAngle);
  void FindKinds(const std::vector<char>& areUnclear);
  unsigned char GetFlags(
    const std::vector<int>& sides, vtkDataArray* materials, double smallestCosine) const;
  void LockFans();
  void LockFixed(vtkDataArray* fixed);

  vtkSmartPointer<vtkPoints> InputPoints;
  std::vector<int> PointIds;    // of the input, per vertex
  std::vector<Triangle> Wedges; // empty if each vertex represents one point
  std::vector<vtkIdType> Cells; // empty if they are consecutive
  vtkIdType FirstCell = 0;
  std::vector<unsigned char> AreFixed; // marks per vertex, empty if none is fixed
  std::map<int, vec3> FixedDirections; // per vertex
  std::vector<int> Opposite;           // half-edge 3 t + e from corner e to e + 1; -1 for none
};
}

#endif
