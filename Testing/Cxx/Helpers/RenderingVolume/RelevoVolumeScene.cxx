// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoVolumeScene.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

int RelevoVolumeScene::Method = vtkGPUUnstructuredGridVolumeMapper::RAY_CASTING;

void RelevoVolumeScene::ForBothMethods(const std::function<void()>& test)
{
  for (int method : { vtkGPUUnstructuredGridVolumeMapper::RAY_CASTING,
         vtkGPUUnstructuredGridVolumeMapper::CELL_PROJECTION })
  {
    Method = method;
    test();
  }
  Method = vtkGPUUnstructuredGridVolumeMapper::RAY_CASTING;
}

RelevoVolumeScene::RelevoVolumeScene(
  vtkDataObject* mesh, vtkVolumeProperty* property, int width, int height)
{
  this->Mapper->SetInputDataObject(mesh);
  this->Mapper->SetMethod(Method);
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetProperty(property);
  this->Renderer->AddVolume(this->Volume);
  this->Window->SetMultiSamples(0);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->GetActiveCamera()->SetPosition(1.0, 0.7, 0.9);
  this->Renderer->ResetCamera();
}

std::vector<RelevoColor> RelevoVolumeScene::Draw()
{
  this->Window->Render();
  const int width = this->Window->GetSize()[0];
  const int height = this->Window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> bytes;
  this->Window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, bytes);
  std::vector<RelevoColor> picture(static_cast<size_t>(width) * height);
  for (size_t i = 0; i < picture.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      picture[i][c] = bytes->GetComponent(static_cast<vtkIdType>(i), c) / 255.0;
    }
    picture[i][3] = 0.0;
  }
  return picture;
}

std::vector<RelevoColor> RelevoVolumeScene::Cast(
  const std::function<void(vtkVolumeRayCastFilter*)>& set)
{
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputDataObject(this->Mapper->GetInputDataObject(0, 0));
  filter->SetVolumeProperty(this->Volume->GetProperty());
  filter->SetCamera(this->GetCamera());
  filter->SetViewportSize(this->Window->GetSize());
  set(filter);
  return ::Cast(filter);
}

double RelevoVolumeScene::Compare(
  double share, const std::function<void(vtkVolumeRayCastFilter*)>& set)
{
  const std::vector<RelevoColor> drawn = this->Draw();
  return Compare(drawn, this->Cast(set), share);
}

double RelevoVolumeScene::Compare(
  const std::vector<RelevoColor>& drawn, const std::vector<RelevoColor>& cast, double share)
{
  if (drawn.size() != cast.size())
  {
    return 255.0;
  }
  std::vector<double> apart;
  for (size_t i = 0; i < drawn.size(); ++i)
  {
    double most = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(most, std::abs(drawn[i][c] - std::min(cast[i][c], 1.0)));
    }
    apart.push_back(255.0 * most);
  }
  std::sort(apart.begin(), apart.end());
  const size_t left = static_cast<size_t>(share * static_cast<double>(apart.size()));
  return apart[apart.size() - 1 - std::min(left, apart.size() - 1)];
}

void LookAlongEdges(RelevoVolumeScene& scene)
{
  vtkCamera* camera = scene.GetCamera();
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetPosition(0.5, 0.5, 4.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(97.0 / 96.0);
  scene.GetRenderer()->ResetCameraClippingRange();
}
