// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneActor
 * @brief   the position of an actor, and its surface
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

/// Return the recipe of an actor's mapper; nullptr if it has none.
vtkAdaptiveRefinement* FindRecipe(vtkActor* actor);

class SceneActor
{
public:
  explicit SceneActor(vtkActor* actor);

  vtkActor* GetActor() const { return this->Actor; }

  /// Update to the current state of the actor.
  void Update();

  /// Return whether there is a finite box.
  bool HasBox() const { return this->IsPlaced; }
  /// Return the box in world coordinates, enlarged by rounding errors.
  const Bounds& GetBox() const { return this->Box; }
  /// Return the matrix, which is always the same object and modified when the actor has moved.
  vtkMatrix4x4* GetMatrix() const { return this->Matrix; }
  /// Return the mapper's input; nullptr if it is not a vtkPolyData with polygons or strips.
  vtkPolyData* GetSurface() const { return this->Surface; }
  /// Return the transformed triangles, shared by all that intersect them.
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
