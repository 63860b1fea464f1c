// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/QuadBatches.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLBufferObject.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
constexpr int QuadsPerBatch = 16384; // corners have 16-bit indices
}

QuadBatches::QuadBatches() = default;
QuadBatches::~QuadBatches() = default;

bool QuadBatches::Bind()
{
  if (this->Corners)
  {
    return this->Corners->Bind();
  }
  std::vector<unsigned short> corners;
  corners.reserve(6 * static_cast<size_t>(QuadsPerBatch));
  for (int quad = 0; quad < QuadsPerBatch; ++quad)
  {
    for (int corner : { 0, 1, 2, 0, 2, 3 })
    {
      corners.push_back(static_cast<unsigned short>(4 * quad + corner));
    }
  }
  this->Corners = vtkSmartPointer<vtkOpenGLBufferObject>::New();
  this->Corners->SetType(vtkOpenGLBufferObject::ElementArrayBuffer);
  return this->Corners->Upload(corners, vtkOpenGLBufferObject::ElementArrayBuffer);
}

void QuadBatches::Draw(int numberOfQuads)
{
  if (!this->Bind())
  {
    return;
  }
  for (int first = 0; first < numberOfQuads; first += QuadsPerBatch)
  {
    glDrawElementsBaseVertex(GL_TRIANGLES, 6 * std::min(QuadsPerBatch, numberOfQuads - first),
      GL_UNSIGNED_SHORT, nullptr, 4 * first);
  }
  this->Corners->Release();
}

void QuadBatches::ReleaseGraphicsResources()
{
  if (this->Corners)
  {
    this->Corners->ReleaseGraphicsResources();
    this->Corners = nullptr;
  }
}
}
