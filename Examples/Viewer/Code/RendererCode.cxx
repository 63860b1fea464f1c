// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/RendererCode.h"

#include "Code/ActorCode.h"
#include "Code/OverlayCode.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTerrainContourLabels.h"
#include "vtkTextActor.h"
#include "vtkVolume.h"

#include <string>

namespace
{
void AddVector(
  SceneCode& code, const std::string& object, const std::string& method, const double* numbers)
{
  code.Call(object, method, { numbers[0], numbers[1], numbers[2] });
}

// Marks that have not been set have no points.
bool IsEmpty(vtkProp* prop)
{
  auto* actor = vtkActor2D::SafeDownCast(prop);
  auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor ? actor->GetMapper() : nullptr);
  vtkPolyData* shape = mapper ? mapper->GetInput() : nullptr;
  return !prop->GetVisibility() || (shape && shape->GetNumberOfPoints() == 0);
}

void AddPropCode(SceneCode& code, vtkProp* prop)
{
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    const std::string variable = AddActorCode(code, actor);
    code.Call("renderer", "AddActor", { CodeValue::Object(variable) });
  }
  else if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    const std::string variable = AddVolumeCode(code, volume);
    code.Call("renderer", "AddVolume", { CodeValue::Object(variable) });
  }
  else if (auto* text = vtkTextActor::SafeDownCast(prop))
  {
    AddTextCode(code, text);
  }
  else if (auto* labels = vtkTerrainContourLabels::SafeDownCast(prop))
  {
    const std::string variable = code.New("vtkTerrainContourLabels", "labels");
    code.Call(variable, "SetActor", { *code.Find(labels->GetActor()) });
    code.Call("renderer", "AddViewProp", { CodeValue::Object(variable) });
  }
  else if (auto* shape = vtkActor2D::SafeDownCast(prop))
  {
    AddLineCode(code, shape);
  }
  else
  {
    throw ViewerError("a program cannot have a " + std::string(prop->GetClassName()));
  }
}

void AddLightCode(SceneCode& code, vtkRenderer* renderer)
{
  code.Note("The lights.");
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    const std::string variable = code.New("vtkLight", "light");
    code.Call(variable, "SetLightTypeToSceneLight");
    AddVector(code, variable, "SetPosition", light->GetPosition());
    AddVector(code, variable, "SetFocalPoint", light->GetFocalPoint());
    code.Call(variable, "SetIntensity", { light->GetIntensity() });
    code.Call("renderer", "AddLight", { CodeValue::Object(variable) });
  }
}
}

//------------------------------------------------------------------------------
void AddRendererCode(SceneCode& code, vtkRenderer* renderer, const std::array<int, 2>& size,
  const std::function<bool(vtkProp*)>& addOwn)
{
  code.Note("A window without a display, and the background.");
#ifdef VIEWER_HAS_EGL
  const std::string window = code.New("vtkEGLOffscreenRenderWindow", "window");
#else
  const std::string window = code.New("vtkRenderWindow", "window");
  code.Call(window, "OffScreenRenderingOn");
#endif
  code.Call(window, "SetSize", { size[0], size[1] });
  code.Call(window, "SetMultiSamples", { 4 });
  code.New("vtkRenderer", "renderer");
  code.Call("renderer", "AutomaticLightCreationOff");
  code.Call("renderer", "GradientBackgroundOn");
  AddVector(code, "renderer", "SetBackground", renderer->GetBackground());
  AddVector(code, "renderer", "SetBackground2", renderer->GetBackground2());
  code.Call(window, "AddRenderer", { CodeValue::Object("renderer") });
  // VTK draws what is over the picture last, and legends use the colours of mappers.
  for (const bool isOver : { false, true })
  {
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator iterator;
    props->InitTraversal(iterator);
    while (vtkProp* prop = props->GetNextProp(iterator))
    {
      const bool isNext = isOver == !vtkProp3D::SafeDownCast(prop);
      if (isNext && !addOwn(prop) && !IsEmpty(prop))
      {
        AddPropCode(code, prop);
      }
    }
  }
  AddLightCode(code, renderer);
}

//------------------------------------------------------------------------------
void AddPictureCode(SceneCode& code, vtkRenderer* renderer)
{
  vtkCamera* view = renderer->GetActiveCamera();
  code.Note(
    "The camera. If you move it or change the scene, call ResetCameraClippingRange() of the "
    "renderer in place of SetClippingRange().");
  const std::string camera = code.Get("vtkCamera", "camera", "renderer", "GetActiveCamera");
  AddVector(code, camera, "SetPosition", view->GetPosition());
  AddVector(code, camera, "SetFocalPoint", view->GetFocalPoint());
  AddVector(code, camera, "SetViewUp", view->GetViewUp());
  code.Call(camera, "SetViewAngle", { view->GetViewAngle() });
  if (view->GetParallelProjection())
  {
    code.Call(camera, "ParallelProjectionOn");
    code.Call(camera, "SetParallelScale", { view->GetParallelScale() });
  }
  const double* range = view->GetClippingRange();
  code.Call(camera, "SetClippingRange", { range[0], range[1] });
  code.Note("The picture.");
  code.Call("window", "Render");
  const std::string pixels = code.New("vtkWindowToImageFilter", "pixels");
  code.Call(pixels, "SetInput", { CodeValue::Object("window") });
  code.Call(pixels, "ReadFrontBufferOff");
  code.Call(pixels, "ShouldRerenderOff");
  const std::string writer = code.New("vtkPNGWriter", "writer");
  code.Call(writer, "SetFileName", { CodeValue::Object("picture") });
  code.Call(writer, "SetInputConnection", { CodeValue::Port(pixels) });
  code.Call(writer, "Write");
}
