// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefCapture.h"

#include "Capture/CapturePass.h"
#include "Capture/CaptureRenderer.h"
#include "Capture/CaptureTarget.h"
#include "Capture/CapturedImage.h"
#include "Capture/FittedCamera.h"
#include "Capture/SceneProps.h"
#include "Capture/SceneTime.h"
#include "Core/SettingChecks.h"

#include "vtkCamera.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int Given = -2; // levels of the sphere are 0 and more
constexpr int Box = -1;
constexpr int HighestLevel = 3;

// nullptr, and what is wrong in `error`, if there is none with a context.
vtkOpenGLRenderWindow* ReadyWindow(vtkRenderer* renderer, std::string& error)
{
  if (!renderer)
  {
    error = "There is no renderer to capture: SetRenderer().";
    return nullptr;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    error = "The renderer is in no window that draws with OpenGL.";
    return nullptr;
  }
  window->Initialize();
  window->MakeCurrent();
  if (!window->IsCurrent())
  {
    error = "The window of the renderer has no OpenGL context.";
    return nullptr;
  }
  return window;
}
}

class vtkReliefCapture::vtkInternals
{
public:
  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkCamera>> Cameras; // those given
  int Level = Box;
  relevo::SceneTime Scene;
  vtkNew<relevo::CapturePass> Pass;
  std::pair<int, int> LeftOut{ 0, 0 }; // translucent props, volumes: of the last warning

  std::vector<vtkSmartPointer<vtkCamera>> MakeCameras(
    const int resolution[2], const std::vector<relevo::dvec3>& corners) const
  {
    if (this->Level == Given)
    {
      return this->Cameras;
    }
    std::vector<vtkSmartPointer<vtkCamera>> cameras;
    for (const relevo::dvec3& direction :
      this->Level == Box ? relevo::GetBoxDirections() : relevo::GetSphereDirections(this->Level))
    {
      cameras.push_back(relevo::MakeCameraAlong(direction, resolution[0], resolution[1], corners));
    }
    return cameras;
  }

  // The number of the camera is for errors.
  vtkSmartPointer<vtkImageData> CaptureFrom(size_t number, vtkCamera* camera,
    vtkReliefCapture* capture, relevo::CaptureRenderer* own, relevo::SceneProps& scene,
    relevo::CaptureTarget& target)
  {
    const int* resolution = capture->Resolution;
    const relevo::FittedCamera fitted = relevo::FitCamera(camera, resolution[0], resolution[1],
      scene.Corners, this->Renderer->GetNearClippingPlaneTolerance());
    if (fitted.IsSingular)
    {
      vtkErrorWithObjectMacro(
        capture, << "The matrices of camera " << number << " have no inverse.");
    }
    if (!fitted.Camera)
    {
      return nullptr;
    }
    own->SetActiveCamera(fitted.Camera);
    own->PlaceLights();
    this->Pass->Draw(own, scene.Opaque, target);
    relevo::CapturedPixels pixels;
    target.Read(pixels);
    return relevo::MakeCapturedImage(pixels, fitted, capture->CaptureNormals, capture->Cropping);
  }

  // Once for as many.
  void WarnOfOthers(vtkReliefCapture* capture, const relevo::SceneProps& scene)
  {
    const std::pair<int, int> now(scene.NumberOfTranslucent, scene.NumberOfVolumes);
    if (now != this->LeftOut && now != std::pair<int, int>(0, 0))
    {
      vtkWarningWithObjectMacro(capture, << "Left out, as they have no one depth: what is "
                                            "translucent of "
                                         << now.first << " props, and " << now.second
                                         << " volumes.");
    }
    this->LeftOut = now;
  }
};

vtkStandardNewMacro(vtkReliefCapture);

vtkReliefCapture::vtkReliefCapture()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
}

vtkReliefCapture::~vtkReliefCapture() = default;

void vtkReliefCapture::SetRenderer(vtkRenderer* renderer)
{
  if (this->Internals->Renderer != renderer)
  {
    this->Internals->Renderer = renderer;
    this->Modified();
  }
}

vtkRenderer* vtkReliefCapture::GetRenderer()
{
  return this->Internals->Renderer;
}

void vtkReliefCapture::SetResolution(int columns, int rows)
{
  relevo::SetPixelSize(this, "Resolution", this->Resolution, columns, rows);
}

void vtkReliefCapture::AddCamera(vtkCamera* camera)
{
  if (!camera)
  {
    vtkErrorMacro("There is no camera to add.");
    return;
  }
  this->Internals->Cameras.emplace_back(camera);
  this->Internals->Level = Given;
  this->Modified();
}

void vtkReliefCapture::RemoveAllCameras()
{
  this->Internals->Cameras.clear();
  this->Internals->Level = Given;
  this->Modified();
}

void vtkReliefCapture::SetCamerasToBox()
{
  this->RemoveAllCameras();
  this->Internals->Level = Box;
}

void vtkReliefCapture::SetCamerasToSphere(int level)
{
  if (relevo::CheckRange(this, "CamerasToSphere", level, 0, HighestLevel))
  {
    this->RemoveAllCameras();
    this->Internals->Level = level;
  }
}

int vtkReliefCapture::GetNumberOfCameras()
{
  const int level = this->Internals->Level;
  return level == Given ? static_cast<int>(this->Internals->Cameras.size())
    : level == Box      ? 6
                        : 2 + 10 * (1 << 2 * level);
}

vtkMTimeType vtkReliefCapture::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkCamera* camera : this->Internals->Cameras)
  {
    time = std::max(time, camera->GetMTime());
  }
  return std::max(time, this->Internals->Scene.Find(this->Internals->Renderer));
}

int vtkReliefCapture::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  auto* output = vtkMultiBlockDataSet::GetData(outputVector);
  output->Initialize();
  return this->Capture(output) ? 1 : 0;
}

bool vtkReliefCapture::Capture(vtkMultiBlockDataSet* output)
{
  std::string error;
  vtkRenderer* renderer = this->Internals->Renderer;
  vtkOpenGLRenderWindow* window = ReadyWindow(renderer, error);
  relevo::SceneProps scene;
  relevo::CaptureTarget target;
  if (window)
  {
    scene = relevo::FindSceneProps(renderer);
    this->Internals->WarnOfOthers(this, scene);
    error = scene.Opaque.empty()
      ? "The renderer shows nothing that can be captured: visible props with opaque geometry."
      : this->GetNumberOfCameras() == 0
      ? "There are no cameras to capture from: AddCamera() or SetCamerasToBox()."
      : target.Allocate(window, this->Resolution[0], this->Resolution[1]);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  vtkNew<relevo::CaptureRenderer> own;
  own->Follow(renderer);
  own->SetCaptureSize(this->Resolution[0], this->Resolution[1]);
  output->SetNumberOfBlocks(static_cast<unsigned int>(this->GetNumberOfCameras()));
  const auto cameras = this->Internals->MakeCameras(this->Resolution, scene.Corners);
  bool seesAny = false;
  for (size_t i = 0; i < cameras.size(); ++i)
  {
    const unsigned int block = static_cast<unsigned int>(i);
    const auto image = this->Internals->CaptureFrom(i, cameras[i], this, own, scene, target);
    output->SetBlock(block, image);
    output->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), ("Camera " + std::to_string(i)).c_str());
    seesAny = seesAny || image;
  }
  window->GetShaderCache()->ReleaseCurrentShader();
  if (!seesAny)
  {
    vtkErrorMacro("None of the cameras sees anything to capture.");
  }
  return seesAny;
}

void vtkReliefCapture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->GetRenderer() << "\n";
  os << indent << "Resolution: " << this->Resolution[0] << " x " << this->Resolution[1] << "\n";
  os << indent << "NumberOfCameras: " << this->GetNumberOfCameras() << "\n";
  os << indent << "Cropping: " << this->Cropping << "\n";
  os << indent << "CaptureNormals: " << this->CaptureNormals << "\n";
}
