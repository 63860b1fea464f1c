// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefCapture.h"

#include "Capture/FittedCamera.h"
#include "Capture/SceneCapture.h"
#include "Capture/SceneTime.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"

#include "vtkCamera.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int Given = -2; // levels of the sphere are at least 0
constexpr int Box = -1;
constexpr int HighestLevel = 3;
}

class vtkReliefCapture::vtkInternals
{
public:
  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkCamera>> Cameras; // cameras that the user has added
  int Level = Box;
  relevo::SceneTime Scene;
  relevo::SceneCapture Capture;
  // numbers of translucent props and volumes in the last warning
  std::pair<int, int> LeftOut{ 0, 0 };

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

  // Warn once for the same numbers.
  void WarnOfOthers(vtkReliefCapture* capture, const relevo::SceneProps& scene)
  {
    const std::pair<int, int> now(scene.NumberOfTranslucent, scene.NumberOfVolumes);
    if (now != this->LeftOut && now != std::pair<int, int>(0, 0))
    {
      vtkWarningWithObjectMacro(capture, << "Not captured, because they have no single depth: "
                                            "translucent parts of "
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
    vtkErrorMacro("Cannot add the camera: it is null.");
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
  return relevo::RequestWithinMemory(
    this, outputVector, "the reliefs", [&] { return this->Capture(output) ? 1 : 0; });
}

bool vtkReliefCapture::Capture(vtkMultiBlockDataSet* output)
{
  relevo::SceneCapture& capture = this->Internals->Capture;
  std::string error = capture.Begin(
    this->Internals->Renderer, relevo::SceneParts::All, this->Resolution[0], this->Resolution[1]);
  if (error.empty() && this->GetNumberOfCameras() == 0)
  {
    error = "There are no cameras to capture from: call AddCamera() or SetCamerasToBox().";
  }
  this->Internals->WarnOfOthers(this, capture.GetProps());
  const bool seesAny = error.empty() && this->CaptureAll(output);
  capture.End();
  if (error.empty() && !seesAny)
  {
    error = "None of the cameras sees anything to capture.";
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

bool vtkReliefCapture::CaptureAll(vtkMultiBlockDataSet* output)
{
  relevo::SceneCapture& capture = this->Internals->Capture;
  const auto cameras = this->Internals->MakeCameras(this->Resolution, capture.GetProps().Corners);
  output->SetNumberOfBlocks(static_cast<unsigned int>(cameras.size()));
  bool seesAny = false;
  for (size_t i = 0; i < cameras.size(); ++i)
  {
    const auto image = capture.CaptureFrom(cameras[i], this->CaptureNormals, this->Cropping);
    if (capture.WasSingular())
    {
      vtkErrorMacro("The matrices of camera " << i << " are singular.");
    }
    const auto block = static_cast<unsigned int>(i);
    output->SetBlock(block, image);
    output->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), ("Camera " + std::to_string(i)).c_str());
    seesAny = seesAny || image;
  }
  if (!seesAny)
  {
    output->Initialize();
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
