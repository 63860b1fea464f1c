// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneActor
 * @brief   where an actor is, and the surface that it shows
 */
#ifndef SceneActor_h
#define SceneActor_h

#include "vtkActor.h"        // for members
#include "vtkMatrix4x4.h"    // for members
#include "vtkNew.h"          // for members
#include "vtkPolyData.h"     // for members
#include "vtkSmartPointer.h" // for members

#include <array>  // for Bounds
#include <memory> // for members

class vtkAdaptiveRefinement;

namespace relevo
{
class MovedSurface;

/// xmin, xmax, ymin, ymax, zmin, zmax.
using Bounds = std::array<double, 6>;

bool HaveCommonBox(const Bounds& a, const Bounds& b);
Bounds GetCommonBox(const Bounds& a, const Bounds& b);

/// The recipe of an actor's mapper; nullptr where that has none.
vtkAdaptiveRefinement* FindRecipe(vtkActor* actor);

class SceneActor
{
public:
  explicit SceneActor(vtkActor* actor);

  vtkActor* GetActor() const { return this->Actor; }

  /// Look at the actor as it is.
  void Update();

  /// Whether there is a finite one.
  bool HasBox() const { return this->IsPlaced; }
  /// In the world; what is within rounding of it belongs to it.
  const Bounds& GetBox() const { return this->Box; }
  /// Always the same object, modified when the actor has moved.
  vtkMatrix4x4* GetMatrix() const { return this->Matrix; }
  /// The mapper's input, nullptr where it is no vtkPolyData with polygons or strips.
  vtkPolyData* GetSurface() const { return this->Surface; }
  /// Its triangles where the actor is, for all that intersect it.
  const std::shared_ptr<MovedSurface>& GetTriangles() const { return this->Triangles; }

private:
  bool TakeBox(const double* bounds);

  vtkSmartPointer<vtkActor> Actor;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkSmartPointer<vtkPolyData> Surface;
  std::shared_ptr<MovedSurface> Triangles;
  Bounds Box{};
  bool IsPlaced = false;
};
}

#endif
