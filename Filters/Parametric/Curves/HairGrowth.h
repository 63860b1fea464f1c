// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HairGrowth
 * @brief   where on a surface hairs grow, and the cubic Bézier curves that each is made of
 *
 * A hair depends on its number, the settings and the surface alone, so that threads may make them
 * in any order.
 *
 * Private to the module's own sources.
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
  double Curl; // turns
  int Seed;
  dvec3 Gravity; // how far the tip sinks, of a length of 1
};

class HairGrowth
{
public:
  /// The mesh must live as long.
  HairGrowth(vtkPolyData* mesh, const HairSettings& settings);

  /// Of triangles with an area, and how many others there are.
  double GetArea() const { return this->Areas.empty() ? 0.0 : this->Areas.back(); }
  vtkIdType GetNumberOfBadTriangles() const { return this->NumberOfBadTriangles; }

  /// Density times area, rounded.
  double GetNumberOfHairs() const;
  int GetNumberOfCurves() const { return this->Curves; }
  int GetNumberOfPoints() const { return 3 * this->Curves + 1; }

  /// The control points of one hair from its root, those of the joints once, and the input's cell
  /// that it grows on.
  vtkIdType Grow(vtkIdType hair, dvec3* points) const;

  /// The same for all hairs.
  double GetRadius(int point) const;

private:
  struct Root
  {
    dvec3 Place;
    dvec3 Normal; // of length 1
    vtkIdType Cell;
  };
  double Throw(vtkIdType hair, int which) const;
  Root FindRoot(vtkIdType hair) const;
  dvec3 GetNormal(vtkIdType triangle, const dvec3& weights) const;

  HairSettings Settings;
  SurfaceTriangles Triangles;
  vtkDataArray* Normals;     // of points, or nullptr
  std::vector<double> Areas; // of all triangles up to and with each
  vtkIdType NumberOfBadTriangles;
  int Curves;
};
}

#endif
