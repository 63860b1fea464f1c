// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/SceneProps.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkFollower.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Props without bounds, such as annotations in the plane of the window, have no position in space.
bool HasBounds(const double* bounds)
{
  return bounds && bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5] &&
    std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); });
}

bool IsSurface(vtkActor* actor)
{
  if (!actor || !actor->GetMapper() || vtkFollower::SafeDownCast(actor) ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return false;
  }
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  auto* mesh = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
  return !mesh || mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0;
}

// Return whether a prop, including all parts of an assembly, is a surface.
bool IsSurface(vtkProp* prop)
{
  bool isSurface = true;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    isSurface = isSurface && IsSurface(vtkActor::SafeDownCast(part));
  }
  return isSurface;
}

void AddCorners(const double* bounds, std::vector<dvec3>& corners)
{
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back(dvec3(bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2 & 1)]));
  }
}
}

SceneProps FindSceneProps(vtkRenderer* renderer, SceneParts parts)
{
  SceneProps scene;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
  {
    const double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
    if (!HasBounds(bounds))
    {
      continue;
    }
    if (vtkVolume::SafeDownCast(prop))
    {
      ++scene.NumberOfVolumes;
      continue;
    }
    if (prop->HasTranslucentPolygonalGeometry())
    {
      ++scene.NumberOfTranslucent;
    }
    if (prop->HasOpaqueGeometry() && (parts == SceneParts::All || IsSurface(prop)))
    {
      scene.Opaque.push_back(prop);
      AddCorners(bounds, scene.Corners);
    }
  }
  return scene;
}
}
