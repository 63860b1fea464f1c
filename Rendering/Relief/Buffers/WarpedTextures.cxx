// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/WarpedTextures.h"

#include "Buffers/ReliefTexture.h"
#include "Buffers/ReliefTiles.h"
#include "Data/Relief.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkReliefWarper.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace relevo
{
WarpedTextures::WarpedTextures()
{
  this->Warper->SetCamera(this->Eye);
  this->Warper->SetPolicyToMultiThreaded();
}

WarpedTextures::~WarpedTextures() = default;

void WarpedTextures::SetRelief(vtkImageData* image, double maximumStretch)
{
  this->Warper->SetInputData(image);
  this->Warper->SetMaximumStretch(maximumStretch);
}

int WarpedTextures::GetNumberOfWarps() const
{
  return this->Warper->GetNumberOfWarps();
}

void WarpedTextures::MoveCamera(vtkRenderer* renderer, vtkActor* actor)
{
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(actor->GetMatrix(), toModel);
  vtkCamera* camera = renderer->GetActiveCamera();
  const auto transform = [&](const double* point)
  {
    const double in[4] = { point[0], point[1], point[2], 1.0 };
    double out[4];
    toModel->MultiplyPoint(in, out);
    return dvec3(out[0], out[1], out[2]) / out[3];
  };
  const dvec3 eye = transform(camera->GetPosition());
  const dvec3 focus = transform(camera->GetFocalPoint());
  const dvec3 along = focus - eye;
  this->Eye->SetPosition(eye.x, eye.y, eye.z);
  this->Eye->SetFocalPoint(focus.x, focus.y, focus.z);
  const bool isSteep = std::abs(along.y) > std::abs(along.x) + std::abs(along.z);
  this->Eye->SetViewUp(isSteep ? 1.0 : 0.0, isSteep ? 0.0 : 1.0, 0.0);
  this->Eye->SetParallelProjection(camera->GetParallelProjection());
}

bool WarpedTextures::Update(vtkRenderer* renderer, vtkActor* actor, const ReliefTiles& tiles)
{
  this->MoveCamera(renderer, actor);
  this->Warper->Update();
  if (!this->Warper->CanWarp())
  {
    return false;
  }
  const int warp = this->Warper->GetNumberOfWarps();
  if (warp != this->UploadedWarp || !this->Heights)
  {
    this->UploadedWarp = warp;
    return this->Upload(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), tiles);
  }
  return true;
}

bool WarpedTextures::Upload(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles)
{
  constexpr float nothing = 1e30f;
  this->ReleaseGraphicsResources(window);
  vtkImageData* picture = this->Warper->GetOutput();
  auto* colors =
    vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetArray(Relief::GetColorName()));
  auto* depths =
    vtkFloatArray::SafeDownCast(picture->GetPointData()->GetArray(Relief::GetDepthName()));
  auto* normals =
    vtkFloatArray::SafeDownCast(picture->GetPointData()->GetArray(Relief::GetNormalsName()));
  vtkDataArray* warp = picture->GetFieldData()->GetArray("ReliefWarp");
  if (!colors || !depths || !warp)
  {
    return false;
  }
  for (int i = 0; i < 4; ++i)
  {
    this->Coefficients[i] =
      warp->GetComponent(i / warp->GetNumberOfComponents(), i % warp->GetNumberOfComponents());
  }
  this->Size = ivec2(picture->GetDimensions()[0], picture->GetDimensions()[1]);
  std::vector<float> heights(depths->GetNumberOfTuples());
  for (size_t i = 0; i < heights.size(); ++i)
  {
    const float depth = depths->GetValue(i);
    heights[i] = std::isfinite(depth) ? static_cast<float>(tiles.ToHeight(depth)) : nothing;
  }
  const int components = colors->GetNumberOfComponents();
  this->Heights = MakeReliefTexture(window, this->Size, heights.data(), 1, VTK_FLOAT);
  this->Colors =
    MakeReliefTexture(window, this->Size, colors->GetPointer(0), components, VTK_UNSIGNED_CHAR);
  if (normals)
  {
    this->Normals = MakeReliefTexture(window, this->Size, normals->GetPointer(0), 3, VTK_FLOAT);
  }
  this->MemorySize =
    static_cast<vtkTypeInt64>(heights.size()) * (4 + components + (normals ? 12 : 0));
  return this->Heights && this->Colors;
}

void WarpedTextures::Activate(vtkShaderProgram* program, const ReliefTiles& tiles)
{
  ActivateReliefTexture(program, this->Heights, "warpedHeights");
  ActivateReliefTexture(program, this->Colors, "warpedColors");
  ActivateReliefTexture(program, this->Normals, "warpedNormals");
  const double plane = tiles.ToScaled(this->Coefficients.w);
  const float values[4] = { static_cast<float>(this->Coefficients.x / tiles.GetHeightScale()),
    static_cast<float>(this->Coefficients.y / tiles.GetHeightScale()),
    static_cast<float>(this->Coefficients.z / tiles.GetHeightScale()), static_cast<float>(plane) };
  program->SetUniform4f("warpCoefficients", values);
}

void WarpedTextures::Deactivate()
{
  for (vtkTextureObject* texture : { this->Heights.Get(), this->Colors.Get(), this->Normals.Get() })
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}

void WarpedTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* texture : { &this->Heights, &this->Colors, &this->Normals })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->MemorySize = 0;
}
}
