// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshErrorDepthTagMetric promises that the mapper draws the stored surface within
// ScreenSpaceError pixels, with and without geomorphing. Depths of the picture are compared with
// those of all displacements, drawn by VTK's mapper, under a parallel projection.
#include "RelevoCheck.h"
#include "RelevoMethods.h"
#include "RelevoMicroMeshes.h"
#include "RelevoScene.h"

#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkMicroMeshSurface.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace RelevoMicroMeshes;

namespace
{
// Between the centres of pixels, depths are interpolated.
constexpr double Slack = 0.75;

void MoveCamera(vtkCamera* camera)
{
  camera->Azimuth(25.0);
  camera->Elevation(20.0);
  camera->ParallelProjectionOn();
}

// The part of the covered pixels whose depth is not among those around it in the other picture,
// with a margin of `pixels`. At the silhouette, where depths change quickly, one must be covered.
double GetShareOutside(
  const RelevoPicture& picture, const RelevoPicture& other, double pixels, double depthOfPixel)
{
  const int width = picture.Size[0];
  const int height = picture.Size[1];
  const int reach = static_cast<int>(std::ceil(pixels));
  const double most = (pixels + Slack) * depthOfPixel;
  std::size_t covered = 0;
  std::size_t outside = 0;
  for (int y = reach; y < height - reach; ++y)
  {
    for (int x = reach; x < width - reach; ++x)
    {
      const double depth = picture.Depths[static_cast<std::size_t>(y * width + x)];
      if (depth >= 1.0)
      {
        continue;
      }
      double low = 2.0;
      double high = -1.0;
      bool isAtSilhouette = false;
      for (int j = y - reach; j <= y + reach; ++j)
      {
        for (int i = x - reach; i <= x + reach; ++i)
        {
          const double around = other.Depths[static_cast<std::size_t>(j * width + i)];
          low = around < 1.0 ? std::min(low, around) : low;
          high = around < 1.0 ? std::max(high, around) : high;
          isAtSilhouette = isAtSilhouette || around >= 1.0;
        }
      }
      ++covered;
      const bool isOutside =
        isAtSilhouette ? high < 0.0 : depth < low - most || depth > high + most;
      outside += isOutside ? 1 : 0;
    }
  }
  return double(outside) / double(std::max<std::size_t>(1, covered));
}

struct Setting
{
  std::string Name;
  int Method;
  int Geomorphing;
  double Error;
};

// The share of pixels that are farther from the stored surface than `pixels`.
double Measure(RelevoCheck& check, vtkPolyData* micro, const Setting& setting, double pixels)
{
  vtkNew<vtkMicroMeshSurface> surface;
  vtkNew<vtkMicroMeshErrorDepthTagMetric> metric;
  metric->SetScreenSpaceError(setting.Error);
  const auto recipe = RelevoMeshes::MakeRecipe(5, surface);
  recipe->SetMetric(metric);
  recipe->SetLevelRuleToPerEdge();
  recipe->SetGeomorphing(setting.Geomorphing);
  RelevoScene drawn(RelevoScene::Refining);
  drawn.MoveCamera = MoveCamera;
  drawn.Add(micro, recipe);
  drawn.GetMapper(0)->SetMethod(setting.Method);
  drawn.ResetCameras();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Decode(micro, 5));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  RelevoScene stored(RelevoScene::Twin);
  stored.Renderer->AddActor(actor);
  stored.CopyCameras(drawn);
  drawn.Render();
  stored.Render();
  const RelevoPicture picture(drawn.Window);
  const RelevoPicture expected(stored.Window);
  CHECK_GREATER(picture.CountForeground(), 10000);
  vtkCamera* camera = drawn.Renderer->GetActiveCamera();
  const double* range = camera->GetClippingRange();
  CHECK_EQUAL(range[1], stored.Renderer->GetActiveCamera()->GetClippingRange()[1]);
  const double depthOfPixel =
    2.0 * camera->GetParallelScale() / picture.Size[1] / (range[1] - range[0]);
  return std::max(GetShareOutside(picture, expected, pixels, depthOfPixel),
    GetShareOutside(expected, picture, pixels, depthOfPixel));
}
}

int TestMicroMeshPixelError(int, char*[])
{
  RelevoCheck check;
  const Mesh micro = Encode(ReliefSphere(96, 60), 0.002, 5, 0.99);
  using Mapper = vtkAdaptiveRefinementMapper;
  for (const Setting& setting : {
         Setting{ "ARKFPI", Mapper::METHOD_ARKFPI, vtkAdaptiveRefinement::GEOMORPHING_OFF, 1.0 },
         Setting{ "morphing", Mapper::METHOD_ARKFPI, vtkAdaptiveRefinement::GEOMORPHING_ON, 1.0 },
         Setting{ "ARK", Mapper::METHOD_ARK, vtkAdaptiveRefinement::GEOMORPHING_OFF, 1.0 },
       })
  {
    CHECK_CASE(setting.Name);
    CHECK_LESS(Measure(check, micro, setting, 1.0), 0.001);
    // A higher limit uses less detail.
    Setting coarse = setting;
    coarse.Error = 12.0;
    CHECK_GREATER(Measure(check, micro, coarse, 1.0), 0.02);
  }
  return check.GetResult();
}
