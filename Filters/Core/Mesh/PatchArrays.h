// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchArrays
 * @brief   the Bézier patches that a mesh carries, as vtkPatchSurfaceFilter writes them
 *
 * Field arrays, one tuple per patch or control point:
 * - Patches: VTK_BEZIER_QUADRILATERAL or VTK_BEZIER_TRIANGLE, the degrees along u and v (1 to 8, of
 *   a triangle the same twice), the index of its first control point.
 * - PatchPoints: x, y, z, and the weight, which is more than 0; the coordinates are not multiplied
 *   with it. Of a quadrilateral of degrees p and q point j (p + 1) + i belongs to u^i v^j; of a
 *   triangle of degree p the rows j = 0 to p have the points i = 0 to p - j of
 *   u^i v^j (1 - u - v)^(p - i - j).
 *
 * - PatchInnerBorders, if there is one: borders that are no edges of their cell, such as where a
 *   polygon is cut into triangles, a bit each: 1: v = 0, 2: u = 0, 4: v = 1 or, of a triangle,
 *   u + v = 1, 8: u = 1.
 *
 * - PatchNodes:NAME, for point arrays NAME: their Bézier coefficients, of the positions' own basis.
 *
 * Cell arrays, of the triangles that the mesh has for polygons:
 * - PatchIds: the index of the patch.
 * - PatchCoordinates: u and v of the three corners in the polygon's own order.
 *
 * Private to Relevo's own sources.
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
  /// Whether a mesh has patches, valid or not.
  static bool AreOn(vtkPolyData* mesh);

  /// Take them away from a mesh whose triangles are no longer their parts.
  static void Remove(vtkPolyData* mesh);

  /// The coefficients of one of the mesh's point arrays; nullptr where there are none for each of
  /// its components and control points.
  static vtkDataArray* FindNodes(vtkPolyData* mesh, vtkAbstractArray* pointArray);

  /// On the arrays and the triangles of a mesh.
  static Dependencies GetDependencies(vtkPolyData* mesh);

  /**
   * Take a mesh's patches. False, with an error to show the user, where an array is missing or of
   * another size, or a patch, a point or a triangle is not valid: then nothing may be asked. The
   * arrays are kept, and must stay as they are.
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
  /// Of a cell of the mesh, which must be a polygon.
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
  vtkSmartPointer<vtkIntArray> InnerBorders; // nullptr for none
  vtkSmartPointer<vtkIntArray> Ids;
  vtkSmartPointer<vtkFloatArray> Coordinates;
};
}

#endif
