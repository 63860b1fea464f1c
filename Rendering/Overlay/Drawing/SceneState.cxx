// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SceneState.h"

#include "Drawing/OverlayProp.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMapper2D.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
std::vector<vtkRenderer*> FindRenderers(vtkOpenGLRenderWindow* window, vtkRenderer* other)
{
  std::vector<vtkRenderer*> renderers;
  vtkCollectionSimpleIterator cookie;
  window->GetRenderers()->InitTraversal(cookie);
  while (vtkRenderer* renderer = window->GetRenderers()->GetNextRenderer(cookie))
  {
    if (renderer != other)
    {
      renderers.push_back(renderer);
    }
  }
  return renderers;
}

std::vector<vtkProp*> GetItems(vtkPropCollection* props)
{
  std::vector<vtkProp*> items;
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    items.push_back(prop);
  }
  return items;
}

// With the time of the last change upstream. Nothing is executed.
void AddMapper(vtkAlgorithm* mapper, Dependencies& state)
{
  state.AddObject(mapper);
  const int connections =
    mapper && mapper->GetNumberOfInputPorts() > 0 ? mapper->GetNumberOfInputConnections(0) : 0;
  for (int i = 0; i < connections; ++i)
  {
    auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(mapper->GetInputExecutive(0, i));
    if (pipeline)
    {
      pipeline->UpdatePipelineMTime();
      state.Add(pipeline->GetPipelineMTime());
    }
  }
}

// GetRedrawMTime() of actors and volumes would execute their pipelines.
void AddPart(vtkProp* part, Dependencies& state)
{
  auto* actor = vtkActor::SafeDownCast(part);
  auto* volume = vtkVolume::SafeDownCast(part);
  auto* flat = vtkActor2D::SafeDownCast(part);
  vtkAlgorithm* mapper = actor ? actor->GetMapper()
    : volume                   ? static_cast<vtkAlgorithm*>(volume->GetMapper())
    : flat                     ? flat->GetMapper()
                               : nullptr;
  state.AddObject(part, mapper ? part->GetMTime() : part->GetRedrawMTime());
  AddMapper(mapper, state);
}

void AddProp(vtkProp* prop, Dependencies& state)
{
  state.AddObject(prop, prop->GetVisibility());
  if (!prop->GetVisibility())
  {
    return;
  }
  AddPart(prop, state);
  vtkNew<vtkPropCollection> parts; // of assemblies
  prop->GetActors(parts);
  prop->GetVolumes(parts);
  prop->GetActors2D(parts);
  for (vtkProp* part : GetItems(parts))
  {
    if (part != prop)
    {
      AddPart(part, state);
    }
  }
}

void AddRenderer(vtkRenderer* renderer, Dependencies& state)
{
  state.AddObject(renderer);
  state.AddObject(renderer->IsActiveCameraCreated() ? renderer->GetActiveCamera() : nullptr);
  state.AddObject(renderer->GetLights());
  vtkCollectionSimpleIterator cookie;
  renderer->GetLights()->InitTraversal(cookie);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cookie))
  {
    state.AddObject(light);
  }
  for (vtkProp* prop : GetItems(renderer->GetViewProps()))
  {
    AddProp(prop, state);
  }
}
}

//------------------------------------------------------------------------------
Dependencies FindSceneState(vtkOpenGLRenderWindow* window, vtkRenderer* other)
{
  const int* size = window->GetActualSize();
  Dependencies state =
    Dependencies::On(size[0], size[1], window->GetMultiSamples(), window->GetNumberOfLayers());
  vtkOpenGLFramebufferObject* buffer = window->GetRenderFramebuffer();
  state.AddObject(buffer, buffer ? buffer->GetFBOIndex() : 0);
  for (vtkRenderer* renderer : FindRenderers(window, other))
  {
    AddRenderer(renderer, state);
  }
  return state;
}

//------------------------------------------------------------------------------
bool CanRepeatScene(vtkOpenGLRenderWindow* window, vtkRenderer* other)
{
  const int* scale = window->GetTileScale();
  const std::vector<vtkRenderer*> renderers = FindRenderers(window, other);
  return scale[0] == 1 && scale[1] == 1 && !window->GetStereoRender() &&
    !window->GetAbortRender() &&
    std::none_of(renderers.begin(), renderers.end(),
      [](vtkRenderer* renderer)
      {
        const std::vector<vtkProp*> props = GetItems(renderer->GetViewProps());
        return renderer->GetSelector() ||
          std::any_of(props.begin(), props.end(),
            [](vtkProp* prop) { return OverlayProp::SafeDownCast(prop) != nullptr; });
      });
}
}
