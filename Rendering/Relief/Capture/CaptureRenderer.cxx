// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/CaptureRenderer.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

namespace relevo
{
vtkStandardNewMacro(CaptureRenderer);

CaptureRenderer::~CaptureRenderer()
{
  this->SetRenderWindow(nullptr);
}

void CaptureRenderer::Follow(vtkRenderer* renderer)
{
  this->SetRenderWindow(renderer->GetRenderWindow());
  this->SetAmbient(renderer->GetAmbient());
  this->SetTwoSidedLighting(renderer->GetTwoSidedLighting());
  this->SetLightFollowCamera(renderer->GetLightFollowCamera());
  this->SetAutomaticLightCreation(renderer->GetAutomaticLightCreation());
  this->SetUseImageBasedLighting(renderer->GetUseImageBasedLighting());
  this->SetEnvironmentTexture(renderer->GetEnvironmentTexture());
  this->SetEnvironmentUp(renderer->GetEnvironmentUp());
  this->SetEnvironmentRight(renderer->GetEnvironmentRight());
  if (auto* other = vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    this->SetUseSphericalHarmonics(other->GetUseSphericalHarmonics());
  }
  this->RemoveAllLights();
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  while (vtkLight* light = lights->GetNextLight(next))
  {
    vtkNew<vtkLight> copy;
    copy->DeepCopy(light);
    this->AddLight(copy);
  }
}

void CaptureRenderer::SetCaptureSize(int width, int height)
{
  this->CaptureSize[0] = width;
  this->CaptureSize[1] = height;
}

void CaptureRenderer::PlaceLights()
{
  if (this->LightFollowCamera)
  {
    this->UpdateLightsGeometryToFollowCamera();
  }
  this->UpdateLights();
}

int* CaptureRenderer::GetSize()
{
  this->Size[0] = this->CaptureSize[0];
  this->Size[1] = this->CaptureSize[1];
  return this->Size;
}

int* CaptureRenderer::GetOrigin()
{
  this->Origin[0] = this->Origin[1] = 0;
  return this->Origin;
}

void CaptureRenderer::GetTiledSizeAndOrigin(int* width, int* height, int* originX, int* originY)
{
  *width = this->CaptureSize[0];
  *height = this->CaptureSize[1];
  *originX = *originY = 0;
}
}
