// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SceneProbe.h"

#include "Scene/ViewerScene.h"
#include "Window/PixelProbe.h"

#include "vtkRenderer.h"

//------------------------------------------------------------------------------
void SceneProbe::Point(ViewerScene& scene, const std::optional<WindowPixel>& pixel)
{
  this->Text = pixel ? DescribeVisible(scene, pixel->data()) : "";
}

//------------------------------------------------------------------------------
bool SceneProbe::Keep(ViewerScene& scene, const WindowPixel& pixel)
{
  const auto point = FindVisiblePoint(scene, pixel.data());
  const std::string text = DescribeVisible(scene, pixel.data());
  if (!point || text.empty())
  {
    return false;
  }
  this->KeptPoint = *point;
  this->KeptText = text;
  return true;
}

//------------------------------------------------------------------------------
void SceneProbe::Forget()
{
  this->KeptText.clear();
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> SceneProbe::FindKeptPixel(ViewerScene& scene) const
{
  vtkRenderer* renderer = scene.GetRenderer();
  double x = this->KeptPoint[0];
  double y = this->KeptPoint[1];
  double z = this->KeptPoint[2];
  if (this->KeptText.empty())
  {
    return std::nullopt;
  }
  renderer->WorldToView(x, y, z);
  const bool isInView = x > -1.0 && x < 1.0 && y > -1.0 && y < 1.0 && z > -1.0 && z < 1.0;
  return isInView ? std::optional<std::array<double, 2>>({ 0.5 * (x + 1.0) * renderer->GetSize()[0],
                      0.5 * (y + 1.0) * renderer->GetSize()[1] })
                  : std::nullopt;
}
