// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICNoise.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace relevo
{
LICNoise::LICNoise() = default;
LICNoise::~LICNoise() = default;

vtkTextureObject* LICNoise::GetTexture(vtkOpenGLRenderWindow* window)
{
  if (!this->Texture || this->TextureVersion != this->GetVersion() ||
    this->Texture->GetContext() != window)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetWrapS(vtkTextureObject::Repeat);
    this->Texture->SetWrapT(vtkTextureObject::Repeat);
    this->TextureVersion = this->GetVersion();
    const NoiseTexels& texels = this->Chosen.GetTexels();
    // Create2DFromRaw() does not write to its argument.
    if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(texels.Plane.Columns),
          static_cast<unsigned int>(texels.Plane.Rows), 1, VTK_FLOAT,
          const_cast<float*>(texels.Values.data())))
    {
      this->Texture = nullptr;
    }
  }
  return this->Texture;
}

void LICNoise::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}

vtkTypeInt64 LICNoise::GetMemorySize() const
{
  return this->Texture
    ? static_cast<vtkTypeInt64>(this->Chosen.GetTexels().Values.size() * sizeof(float))
    : 0;
}
}
