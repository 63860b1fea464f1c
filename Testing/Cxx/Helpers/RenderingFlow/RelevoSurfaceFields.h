// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Vector fields on planes, spheres and tori by formulae, and their projections to the screen.
#ifndef RelevoSurfaceFields_h
#define RelevoSurfaceFields_h

#include "RelevoLICScene.h"

#include "vtkMatrix4x4.h"

// A vector or a normal at a point of the surface.
using RelevoSurfaceField = std::function<std::array<double, 3>(const std::array<double, 3>&)>;

struct RelevoNamedSurfaceField
{
  std::string Name;
  RelevoSurfaceField Field;
};

// Of the sphere about the origin.
std::array<double, 3> NormalOfSphere(const std::array<double, 3>& p);

// Of the torus of RelevoMeshes.
std::array<double, 3> NormalOfTorus(const std::array<double, 3>& p);

// The tangential part of the field.
RelevoSurfaceField TangentOf(const RelevoSurfaceField& field, const RelevoSurfaceField& normal);

// Fields tangential to a surface with these normals, about the size of the unit sphere.
std::vector<RelevoNamedSurfaceField> MakeSurfaceFields(const RelevoSurfaceField& normal);

// The mesh with the field as its active vectors "Flow".
RelevoMeshes::Mesh WithField(vtkPolyData* mesh, const RelevoSurfaceField& field);

// The mesh with unit normals by a formula.
RelevoMeshes::Mesh WithNormals(vtkPolyData* mesh, const RelevoSurfaceField& normal);

// Converts between world coordinates and pixels in double precision.
class RelevoScreen
{
public:
  explicit RelevoScreen(vtkRenderer* renderer);

  // The point visible at a pixel's centre, from its depth.
  std::array<double, 3> Find(int column, int row, double depth) const;

  // The motion on the screen of a point with this velocity.
  void Project(
    const std::array<double, 3>& place, const std::array<double, 3>& velocity, double* v) const;

private:
  static std::array<double, 3> Transform(vtkMatrix4x4* matrix, const std::array<double, 3>& p);

  int Size[2];
  vtkNew<vtkMatrix4x4> ToScreen;
  vtkNew<vtkMatrix4x4> ToWorld;
};

// Deviations of a picture's streaks from a field, where the surface is not seen at a grazing angle
// and the field is not close to zero. Actors must have identity matrices.
RelevoDeviations MeasureStreaks(const RelevoLICPicture& picture, vtkRenderer* renderer,
  const RelevoSurfaceField& field, const RelevoSurfaceField& normal);

#endif
