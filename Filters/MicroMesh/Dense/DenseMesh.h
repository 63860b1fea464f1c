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

#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h" // for vtkIdType

#include <array>  // for members
#include <vector> // for members

class vtkDataArray;
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
  struct LineEnd
  {
    int Vertex;
    unsigned char Flags;
  };
  using Lines = std::vector<std::vector<LineEnd>>; // per vertex, the other ends
  using Triangle = std::array<int, 3>;

  /// `materials` is a cell array or nullptr. `featureAngle` is in degrees. `fixed` is a point array
  /// or nullptr; points with a value other than 0 are fixed.
  DenseMesh(vtkPolyData* input, vtkDataArray* materials, double featureAngle,
    vtkDataArray* fixed = nullptr);

  dvec3 ToInput(const dvec3& point) const { return point * this->Scale + this->Centre; }
  dvec3 GetNormal(const Triangle& triangle) const; // with twice the area as its length

  /// Per vertex.
  std::vector<dvec3> Points;
  std::vector<Kind> Kinds;
  Lines LineEnds;
  /// The points of the input that the vertices represent.
  std::vector<vtkIdType> PointIds;
  /// Per triangle: vertices, points of the input, and the input's cell.
  std::vector<Triangle> Triangles;
  std::vector<Triangle> Wedges;
  std::vector<vtkIdType> Cells;

  /// A length of the input divided by the same length here.
  double Scale = 1.0;
  dvec3 Centre = dvec3(0.0);

  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfDuplicates = 0;
  vtkIdType NumberOfUnclearEdges = 0;
  vtkIdType NumberOfFixedEdges = 0; // at the border, between fixed points

private:
  void ReadTriangles(vtkPolyData* input);
  void ScalePoints(vtkPolyData* input);
  void FindLines(vtkDataArray* materials, double featureAngle);
  unsigned char GetFlags(
    const std::vector<int>& sides, vtkDataArray* materials, double smallestCosine) const;
  void LockFans();
  void LockFixed(vtkDataArray* fixed);

  std::vector<int> Opposite; // half-edge 3 t + e from corner e to e + 1; -1 for none
};
}

#endif
