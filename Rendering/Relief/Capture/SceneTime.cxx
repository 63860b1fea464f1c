// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/SceneTime.h"

#include "Changes/LatestTime.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithm.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDataObject.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>

namespace relevo
{
namespace
{
void AddNumbers(Dependencies& list, const double* numbers, int count)
{
  for (int i = 0; i < count; ++i)
  {
    list.Add(numbers[i]);
  }
}

void AddLight(Dependencies& list, vtkLight* light, bool followsCamera)
{
  list.Add(light->GetLightType());
  list.Add(light->GetSwitch());
  list.Add(light->GetPositional());
  AddNumbers(list, light->GetAmbientColor(), 3);
  AddNumbers(list, light->GetDiffuseColor(), 3);
  AddNumbers(list, light->GetSpecularColor(), 3);
  AddNumbers(list, light->GetAttenuationValues(), 3);
  list.Add(light->GetIntensity());
  list.Add(light->GetExponent());
  list.Add(light->GetConeAngle());
  if (!followsCamera || !light->LightTypeIsHeadlight())
  {
    AddNumbers(list, light->GetPosition(), 3);
    AddNumbers(list, light->GetFocalPoint(), 3);
  }
  vtkMatrix4x4* matrix = light->GetTransformMatrix();
  if (matrix && (!followsCamera || light->LightTypeIsSceneLight()))
  {
    AddNumbers(list, matrix->GetData(), 16);
  }
}

Dependencies DescribeLights(vtkRenderer* renderer)
{
  Dependencies list;
  const bool follow = renderer->GetLightFollowCamera() != 0;
  list.Add(follow);
  list.Add(renderer->GetTwoSidedLighting());
  list.Add(renderer->GetUseImageBasedLighting());
  list.AddObject(renderer->GetEnvironmentTexture());
  AddNumbers(list, renderer->GetEnvironmentUp(), 3);
  AddNumbers(list, renderer->GetEnvironmentRight(), 3);
  AddNumbers(list, renderer->GetAmbient(), 3);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  while (vtkLight* light = lights->GetNextLight(next))
  {
    AddLight(list, light, follow);
  }
  if (lights->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation())
  {
    vtkNew<vtkLight> created; // the light that VTK creates when it draws the renderer
    created->SetLightTypeToHeadlight();
    AddLight(list, created, follow);
  }
  return list;
}

bool IsAssembly(vtkProp* prop)
{
  return vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop);
}

// Return the modification time of an actor's appearance, without its position.
vtkMTimeType FindLookTime(vtkActor* actor)
{
  vtkMTimeType time = GetLatestTime(actor->GetProperty()->GetMTime(),
    { actor->GetBackfaceProperty(), actor->GetTexture(), actor->GetMapper() });
  vtkMapper* mapper = actor->GetMapper();
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->GetInputAlgorithm()->Update();
    time = GetLatestTime(time, { mapper->GetInputDataObject(0, 0) });
  }
  return time;
}

// Assemblies modify the matrices of their parts whenever they are drawn or their bounds are
// computed, so the times of parts are not used.
void AddAssembly(Dependencies& list, vtkProp* assembly)
{
  list.AddObject(assembly, static_cast<vtkMTimeType>(assembly->GetVisibility()));
  assembly->InitPathTraversal();
  while (vtkAssemblyPath* path = assembly->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    vtkActor* actor = vtkActor::SafeDownCast(part);
    list.AddObject(part, actor ? FindLookTime(actor) : part->GetMTime());
    list.Add(part->GetVisibility());
    if (vtkMatrix4x4* matrix = path->GetLastNode()->GetMatrix())
    {
      AddNumbers(list, matrix->GetData(), 16);
    }
  }
}

Dependencies DescribeAssemblies(vtkRenderer* renderer)
{
  Dependencies list;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
  {
    if (IsAssembly(prop))
    {
      AddAssembly(list, prop);
    }
  }
  return list;
}

// Annotations in the plane of the window are never captured, and texts change when they are drawn.
vtkMTimeType FindTime(vtkProp* prop)
{
  return IsAssembly(prop) || vtkActor2D::SafeDownCast(prop) ? 0
    : prop->GetVisibility()                                 ? prop->GetRedrawMTime()
                                                            : prop->GetMTime();
}
}

vtkMTimeType SceneTime::Find(vtkRenderer* renderer)
{
  if (this->IsFinding)
  {
    return 0;
  }
  if (this->Lights.Update(renderer ? DescribeLights(renderer) : Dependencies()))
  {
    this->LightsChanged.Modified();
  }
  if (!renderer)
  {
    return this->LightsChanged.GetMTime();
  }
  this->IsFinding = true;
  if (this->Assemblies.Update(DescribeAssemblies(renderer)))
  {
    this->AssembliesChanged.Modified();
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkMTimeType time = std::max(
    { this->LightsChanged.GetMTime(), this->AssembliesChanged.GetMTime(), props->GetMTime() });
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
  {
    time = std::max(time, FindTime(prop));
  }
  this->IsFinding = false;
  return time;
}
}
