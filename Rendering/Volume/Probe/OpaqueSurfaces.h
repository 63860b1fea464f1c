// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OpaqueSurfaces
 * @brief   finds where a ray meets the opaque actors of a renderer
 *
 * Uses the data sets of the actors' mappers, with a cell locator for each. Actors are those that
 * are visible, opaque and drawn as surfaces.
 *
 * Private to the module.
 */
#ifndef OpaqueSurfaces_h
#define OpaqueSurfaces_h

#include "Integral/Ray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>

class vtkActor;
class vtkDataSet;
class vtkMatrix4x4;
class vtkRenderer;
class vtkStaticCellLocator;

namespace relevo
{
class OpaqueSurfaces
{
public:
  OpaqueSurfaces();
  ~OpaqueSurfaces();

  /// Return the distance along the ray, in world coordinates, of the nearest surface, or the ray's
  /// length.
  double FindNearest(vtkRenderer* renderer, const Ray& ray);

private:
  struct Entry
  {
    vtkSmartPointer<vtkStaticCellLocator> Locator;
    vtkMTimeType Time = 0;
    bool IsUsed = false;
  };
  double Find(vtkActor* actor, vtkMatrix4x4* matrix, const Ray& ray);
  double Find(vtkDataSet* mesh, vtkMatrix4x4* matrix, const Ray& ray);
  vtkStaticCellLocator* GetLocator(vtkDataSet* mesh);

  std::map<vtkDataSet*, Entry> Entries;
};
}

#endif
