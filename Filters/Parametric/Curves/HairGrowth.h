// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HairGrowth
 * @brief   roots and cubic Bézier curves of hairs on a surface
 *
 * A hair only depends on its number, the settings and the surface, so that hairs can be generated
 * in parallel.
 *
 * Private to the module.
 */
#ifndef HairGrowth_h
#define HairGrowth_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceTriangles.h"
#include "vtkType.h"

#include <vector> // for members

class vtkDataArray;
class vtkPolyData;

namespace relevo
{
struct HairSettings
{
  double Density;
  double Length;
  double Curl; // number of turns
  int Seed;
  dvec3 Gravity; // displacement of the tip of a hair of length 1
};

class HairGrowth
{
public:
  /// `mesh` must outlive this object.
  HairGrowth(vtkPolyData* mesh, const HairSettings& settings);

  /// Return the area of the surface, and the number of triangles without area.
  double GetArea() const { return this->Areas.empty() ? 0.0 : this->Areas.back(); }
  vtkIdType GetNumberOfBadTriangles() const { return this->NumberOfBadTriangles; }

  /// Returns density * area, rounded.
  double GetNumberOfHairs() const;
  int GetNumberOfCurves() const { return this->Curves; }
  int GetNumberOfPoints() const { return 3 * this->Curves + 1; }

  /// Generates the control points of a hair from its root, without duplicates at joints. Returns
  /// the input cell of the root.
  vtkIdType Grow(vtkIdType hair, dvec3* points) const;

  /// Returns the radius at a control point, the same for all hairs.
  double GetRadius(int point) const;

private:
  struct Root
  {
    dvec3 Place;
    dvec3 Normal; // normalized
    vtkIdType Cell;
  };
  double Throw(vtkIdType hair, int which) const;
  Root FindRoot(vtkIdType hair) const;
  dvec3 GetNormal(vtkIdType triangle, const dvec3& weights) const;

  HairSettings Settings;
  SurfaceTriangles Triangles;
  vtkDataArray* Normals;     // of points; may be nullptr
  std::vector<double> Areas; // prefix sums of the areas of triangles
  vtkIdType NumberOfBadTriangles;
  int Curves;
};
}

#endif
