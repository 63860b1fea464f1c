// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe/OpaqueSurfaces.h"

#include "Rays/ClippingPlanes.h"
#include "View/WorldView.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>

namespace relevo
{
OpaqueSurfaces::OpaqueSurfaces() = default;
OpaqueSurfaces::~OpaqueSurfaces() = default;

double OpaqueSurfaces::FindNearest(vtkRenderer* renderer, const Ray& ray)
{
  for (auto& entry : this->Entries)
  {
    entry.second.IsUsed = false;
  }
  double nearest = ray.Length;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto* actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && actor->GetVisibility() && actor->GetMapper() &&
        actor->HasTranslucentPolygonalGeometry() == 0 &&
        actor->GetProperty()->GetRepresentation() == VTK_SURFACE)
      {
        nearest = std::min(nearest, this->Find(actor, node->GetMatrix(), ray));
      }
    }
  }
  for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
  {
    entry = entry->second.IsUsed ? std::next(entry) : this->Entries.erase(entry);
  }
  return nearest;
}

double OpaqueSurfaces::Find(vtkActor* actor, vtkMatrix4x4* matrix, const Ray& ray)
{
  vtkMapper* mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) == 0)
  {
    return ray.Length;
  }
  mapper->Update();
  const Ray clipped = ClippingPlanes(mapper->GetClippingPlanes()).Clip(ray);
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  double nearest = clipped.Length;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      auto* mesh = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject());
      nearest = std::min(nearest, this->Find(mesh, matrix, clipped));
    }
  }
  else
  {
    nearest = this->Find(vtkDataSet::SafeDownCast(input), matrix, clipped);
  }
  return nearest < clipped.Length ? nearest + dot(clipped.Origin - ray.Origin, ray.Direction)
                                  : ray.Length;
}

double OpaqueSurfaces::Find(vtkDataSet* mesh, vtkMatrix4x4* matrix, const Ray& ray)
{
  if (!mesh || mesh->GetNumberOfCells() == 0 || !(ray.Length > 0.0))
  {
    return ray.Length;
  }
  const dmat4 toMesh = inverse(MakeMatrix(matrix));
  dvec3 begin(toMesh * dvec4(ray.Origin, 1.0));
  dvec3 end(toMesh * dvec4(ray.Origin + ray.Length * ray.Direction, 1.0));
  double share;
  double parameters[3];
  double point[3];
  int subId;
  vtkIdType cell;
  const int isHit = this->GetLocator(mesh)->IntersectWithLine(
    &begin.x, &end.x, 0.0, share, point, parameters, subId, cell);
  return isHit ? share * ray.Length : ray.Length;
}

vtkStaticCellLocator* OpaqueSurfaces::GetLocator(vtkDataSet* mesh)
{
  Entry& entry = this->Entries[mesh];
  entry.IsUsed = true;
  if (!entry.Locator || entry.Time != mesh->GetMTime())
  {
    entry.Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    entry.Locator->SetDataSet(mesh);
    entry.Locator->BuildLocator();
    entry.Time = mesh->GetMTime();
  }
  return entry.Locator;
}
}
