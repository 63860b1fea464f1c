// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RayEntries.h"

#include "Passes/ScreenPass.h"

#include "vtkPixelBufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

namespace relevo
{
void RayEntries::Draw(int numberOfFaces)
{
  this->Target.Draw(BlendOperation::Add, [=]() { this->Faces.Draw(numberOfFaces); });
  this->Target.End();
}

void RayEntries::DrawCounts()
{
  this->Target.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
  this->Target.End();
}

void RayEntries::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Target.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources();
}

int RayEntries::ReadMaximum()
{
  vtkTextureObject* sums = this->Target.GetTexture();
  if (!sums)
  {
    return 0;
  }
  vtkSmartPointer<vtkPixelBufferObject> pixels;
  pixels.TakeReference(sums->Download());
  const unsigned int size = sums->GetWidth() * sums->GetHeight();
  std::vector<float> values(2 * static_cast<size_t>(size));
  unsigned int dimensions[2] = { sums->GetWidth(), sums->GetHeight() };
  vtkIdType increments[2] = { 0, 0 };
  pixels->Download2D(VTK_FLOAT, values.data(), dimensions, 2, increments);
  float most = 0.0f;
  for (size_t i = 1; i < values.size(); i += 2)
  {
    most = std::max(most, values[i]);
  }
  return static_cast<int>(most);
}
}
