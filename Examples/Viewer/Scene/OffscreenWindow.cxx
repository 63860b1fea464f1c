// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/OffscreenWindow.h"

#include "vtkHeightMap.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#ifdef VIEWER_HAS_EGL
#include "vtkEGLOffscreenRenderWindow.h"
#endif

#include <algorithm>

namespace
{
// All graphics cards with OpenGL 3.3 support this, so no context is needed to query the limit.
const int SmallestTextureLimit = 8192;

// Returns 0 if the file cannot be opened; reading it reports the cause.
int GetLongerSide(vtkHeightMap* raster)
{
  if (!raster->UpdateInformation())
  {
    return 0;
  }
  const int* size = raster->GetFullDimensions();
  return std::max(size[0], size[1]);
}

int GetLongerSide(const char* fileName)
{
  vtkNew<vtkHeightMap> raster;
  raster->SetFileName(fileName);
  return GetLongerSide(raster);
}

// Returns 0 without OpenGL; drawing reports this.
int GetTextureLimit()
{
  const auto window = NewOffscreenWindow();
  auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!context)
  {
    return 0;
  }
  window->SetSize(1, 1);
  context->Initialize();
  context->MakeCurrent();
  return context->IsCurrent() ? vtkTextureObject::GetMaximumTextureSize(context) : 0;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> NewOffscreenWindow()
{
#ifdef VIEWER_HAS_EGL
  return vtkSmartPointer<vtkEGLOffscreenRenderWindow>::New();
#else
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  return window;
#endif
}

//------------------------------------------------------------------------------
void FitIntoTexture(vtkHeightMap* heights, const char* picture)
{
  if (std::max(GetLongerSide(heights), *picture ? GetLongerSide(picture) : 0) <=
    SmallestTextureLimit)
  {
    return;
  }
  const int limit = GetTextureLimit();
  if (limit > 0 && limit < heights->GetMaximumDimension())
  {
    heights->SetMaximumDimension(limit);
  }
}
