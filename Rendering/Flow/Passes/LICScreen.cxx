// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICScreen.h"

#include "OpenGL/RelevoOpenGL.h"
#include "Passes/LICPass.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
bool LICScreen::Allocate(vtkOpenGLRenderWindow* window, bool withColors)
{
  const int width = this->Viewport[2];
  const int height = this->Viewport[3];
  const auto fits = [&](vtkTextureObject* texture)
  {
    return texture && texture->GetContext() == window &&
      texture->GetWidth() == static_cast<unsigned int>(width) &&
      texture->GetHeight() == static_cast<unsigned int>(height);
  };
  if (!fits(this->Vectors) || !fits(this->Image) || !fits(this->Depth))
  {
    this->Sources.Clear();
    this->Vectors.TakeReference(NewFloatTexture(window, width, height, 4, true));
    this->Image.TakeReference(NewFloatTexture(window, width, height, 2, false));
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(window);
    if (!this->Depth->AllocateDepth(static_cast<unsigned int>(width),
          static_cast<unsigned int>(height), vtkTextureObject::Fixed24))
    {
      this->Depth = nullptr;
    }
  }
  if (withColors && !fits(this->Colors))
  {
    this->Colors.TakeReference(NewFloatTexture(window, width, height, 4, false));
  }
  else if (!withColors)
  {
    this->Colors = nullptr;
    this->Range = nullptr;
  }
  return this->Vectors && this->Image && this->Depth && (this->Colors || !withColors);
}

void LICScreen::SetBounds(const double bounds[6], vtkMatrix4x4* project)
{
  double low[2] = { 1.0, 1.0 };
  double high[2] = { -1.0, -1.0 };
  bool isInFront = vtkMath::AreBoundsInitialized(bounds) != 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double place[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
      bounds[4 + (corner >> 2)], 1.0 };
    double clip[4];
    project->MultiplyPoint(place, clip);
    isInFront = isInFront && clip[3] > 0.0;
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], clip[i] / clip[3]);
      high[i] = std::max(high[i], clip[i] / clip[3]);
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    const int size = this->Viewport[2 + i];
    int first = 0;
    int last = size; // one past the last pixel
    if (isInFront)
    {
      // One pixel is added on both sides for rounding.
      const auto toPixel = [size](double place)
      { return 0.5 * (std::min(std::max(place, -1.0), 1.0) + 1.0) * size; };
      first = std::max(static_cast<int>(std::floor(toPixel(low[i]))) - 1, 0);
      last = std::min(static_cast<int>(std::ceil(toPixel(high[i]))) + 1, size);
    }
    this->Rectangle[i] = first;
    this->Rectangle[2 + i] = std::max(last - first, 0);
  }
  this->GrowConvolved(0);
}

void LICScreen::GrowConvolved(int margin)
{
  for (int i = 0; i < 2; ++i)
  {
    const int last = this->Rectangle[i] + this->Rectangle[2 + i] + margin;
    this->Convolved[i] = std::max(this->Rectangle[i] - margin, 0);
    this->Convolved[2 + i] = std::min(last, this->Viewport[2 + i]) - this->Convolved[i];
  }
}

bool LICScreen::Begin(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer)
{
  vtkOpenGLState* state = window->GetState();
  framebuffer->Bind();
  framebuffer->AddDepthAttachment(this->Depth);
  framebuffer->AddColorAttachment(0, this->Vectors);
  if (this->Colors)
  {
    framebuffer->AddColorAttachment(1, this->Colors);
  }
  framebuffer->ActivateDrawBuffers(this->Colors ? 2 : 1);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->End(window, framebuffer);
    return false;
  }
  framebuffer->InitializeViewport(this->Viewport[2], this->Viewport[3]);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return true;
}

void LICScreen::End(vtkOpenGLRenderWindow*, vtkOpenGLFramebufferObject* framebuffer)
{
  framebuffer->RemoveDepthAttachment();
  framebuffer->RemoveColorAttachments(this->Colors ? 2 : 1);
  framebuffer->DeactivateDrawBuffers();
}

std::vector<float> LICScreen::ReadVectors(
  vtkOpenGLFramebufferObject* framebuffer, const int rectangle[4]) const
{
  std::vector<float> vectors(static_cast<size_t>(4) * rectangle[2] * rectangle[3]);
  framebuffer->ActivateReadBuffer(0);
  glReadPixels(
    rectangle[0], rectangle[1], rectangle[2], rectangle[3], GL_RGBA, GL_FLOAT, vectors.data());
  framebuffer->DeactivateReadBuffer();
  return vectors;
}

void LICScreen::WriteVectors(const int rectangle[4], const std::vector<float>& vectors)
{
  this->Vectors->Activate();
  glTexSubImage2D(this->Vectors->GetTarget(), 0, rectangle[0], rectangle[1], rectangle[2],
    rectangle[3], GL_RGBA, GL_FLOAT, vectors.data());
  this->Vectors->Deactivate();
}

void LICScreen::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkSmartPointer<vtkTextureObject>* texture :
    { &this->Vectors, &this->Colors, &this->Depth, &this->Image, &this->Range })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
  this->Sources.Clear();
}

vtkTypeInt64 LICScreen::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const vtkSmartPointer<vtkTextureObject>* texture :
    { &this->Vectors, &this->Colors, &this->Depth, &this->Image })
  {
    if (*texture)
    {
      size += static_cast<vtkTypeInt64>((*texture)->GetWidth()) * (*texture)->GetHeight() * 4 *
        std::max((*texture)->GetComponents(), 1);
    }
  }
  return size;
}
}
