// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchArrays
 * @brief   the Bézier patches stored with a mesh by vtkPatchSurfaceFilter
 *
 * The field arrays have one tuple per patch or control point:
 * - Patches: VTK_BEZIER_QUADRILATERAL or VTK_BEZIER_TRIANGLE, the degrees along u and v (1 to 8;
 *   equal for triangles), and the index of the first control point.
 * - PatchPoints: x, y, z and the weight, which is positive. The coordinates are not multiplied by
 *   the weight. For quadrilaterals of degrees p and q, point j (p + 1) + i belongs to u^i v^j. For
 *   triangles of degree p, row j = 0 to p has the points i = 0 to p - j of
 *   u^i v^j (1 - u - v)^(p - i - j).
 * - PatchInnerBorders (optional): borders that are not edges of their cell, for example where a
 *   polygon is split into triangles. The bits are 1: v = 0, 2: u = 0, 4: v = 1 (quadrilaterals) or
 *   u + v = 1 (triangles), and 8: u = 1.
 * - PatchNodes:NAME, for point arrays NAME: their Bézier coefficients, in the same basis.
 *
 * The cell arrays have one tuple per triangle of the mesh:
 * - PatchIds: the index of the patch.
 * - PatchCoordinates: u and v of the three corners in the polygon's order.
 */
#ifndef PatchArrays_h
#define PatchArrays_h

#include "Changes/Dependencies.h"
#include "Mathematics/BezierDegree.h" // for callers
#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkDoubleArray.h"          // for members
#include "vtkFloatArray.h"           // for members
#include "vtkIdTypeArray.h"          // for members
#include "vtkIntArray.h"             // for members
#include "vtkSmartPointer.h"         // for members

#include <string> // for errors

class vtkAbstractArray;
class vtkPolyData;

namespace relevo
{
constexpr const char* PatchesName = "Patches";
constexpr const char* PatchPointsName = "PatchPoints";
constexpr const char* PatchInnerBordersName = "PatchInnerBorders";
constexpr const char* PatchNodesPrefix = "PatchNodes:";
constexpr const char* PatchIdsName = "PatchIds";
constexpr const char* PatchCoordinatesName = "PatchCoordinates";

struct Patch
{
  bool IsTriangle;
  ivec2 Degrees;
  vtkIdType FirstPoint;

  int GetNumberOfPoints() const
  {
    return this->IsTriangle ? (this->Degrees.x + 1) * (this->Degrees.x + 2) / 2
                            : (this->Degrees.x + 1) * (this->Degrees.y + 1);
  }
};

class RELEVOFILTERSCORE_EXPORT PatchArrays
{
public:
  /// Whether the mesh has patches, valid or not.
  static bool AreOn(vtkPolyData* mesh);

  /// Remove the patches from a mesh whose triangles no longer belong to them.
  static void Remove(vtkPolyData* mesh);

  /// Return the coefficients of a point array, or nullptr if they do not exist for all its
  /// components and control points.
  static vtkDataArray* FindNodes(vtkPolyData* mesh, vtkAbstractArray* pointArray);

  /// Return whether the weights of control points differ. The mesh must have valid patches.
  static bool HaveDifferentWeights(vtkPolyData* mesh);

  /// The arrays and triangles of the mesh as dependencies.
  static Dependencies GetDependencies(vtkPolyData* mesh);

  /**
   * Read the patches of a mesh. Returns false and an error for the user if an array is missing or
   * has the wrong size, or if a patch, point or triangle is invalid. Other functions must not be
   * called then. The object keeps references to the arrays, which must not change.
   */
  bool Take(vtkPolyData* mesh, std::string& error);

  int GetNumberOfPatches() const { return static_cast<int>(this->Patches->GetNumberOfTuples()); }
  Patch GetPatch(int patch) const;
  int GetInnerBorders(int patch) const
  {
    return this->InnerBorders ? this->InnerBorders->GetValue(patch) : 0;
  }

  vtkIdType GetNumberOfPoints() const { return this->Points->GetNumberOfTuples(); }
  /// x, y, z and weight.
  dvec4 GetPoint(vtkIdType point) const
  {
    const double* x = this->Points->GetPointer(4 * point);
    return dvec4(x[0], x[1], x[2], x[3]);
  }

  //@{
  /// The patch of a cell, which must be a polygon.
  int GetPatchId(vtkIdType cell) const { return this->Ids->GetValue(cell); }
  vec2 GetCoordinates(vtkIdType cell, int corner) const
  {
    const float* uv = this->Coordinates->GetPointer(6 * cell + 2 * corner);
    return vec2(uv[0], uv[1]);
  }
  //@}

private:
  bool CheckPatches(std::string& error) const;
  bool CheckPoints(std::string& error) const;
  bool CheckTriangle(vtkIdType cell, std::string& error) const;
  bool CheckCells(vtkPolyData* mesh, std::string& error) const;

  vtkSmartPointer<vtkIdTypeArray> Patches;
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkIntArray> InnerBorders; // nullptr if there are none
  vtkSmartPointer<vtkIntArray> Ids;
  vtkSmartPointer<vtkFloatArray> Coordinates;
};
}

#endif
