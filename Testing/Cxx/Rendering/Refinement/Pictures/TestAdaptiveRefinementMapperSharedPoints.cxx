// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves surfaces.md: a displaced mesh in pieces is drawn like the whole, with every method, bit
// for bit.
#include "RelevoDisplacements.h"
#include "RelevoMethods.h"
#include "RelevoPictures.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"

#include <cmath>
#include <string>

using namespace RelevoMeshes;

namespace
{
// A bent strip from first / 16 to last / 16, whose texture coordinate u goes back and forth.
Mesh MakeStrip(int first, int last)
{
  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> triangles;
  for (int i = first; i <= last; ++i)
  {
    const double angle = i / 8.0 - 1.0;
    for (int j = 0; j < 3; ++j)
    {
      points.push_back({ { std::sin(angle), 0.5 * j, std::cos(angle) } });
      if (i < last && j < 2)
      {
        const vtkIdType a = 3 * (i - first) + j;
        triangles.push_back({ { a, a + 3, a + 4 } });
        triangles.push_back({ { a, a + 4, a + 1 } });
      }
    }
  }
  Mesh mesh = FromTriangles(points, triangles);
  AddTextureCoordinates(mesh,
    [](const double* x) {
      return std::array<double, 2>{ { std::abs(std::atan2(x[0], x[2])), x[1] } };
    });
  return mesh;
}
}

int TestAdaptiveRefinementMapperSharedPoints(int, char*[])
{
  RelevoCheck check;
  vtkNew<RelevoHeights> heights;
  heights->Fill(64, 64, [](double u, double v) { return std::sin(9.0 * u) + std::cos(7.0 * v); });
  vtkNew<vtkPNTriangleSurface> pn;
  const Mesh whole = MakeStrip(0, 16);
  vtkNew<vtkAppendPolyData> pieces;
  pieces->AddInputData(MakeStrip(0, 8));
  pieces->AddInputData(MakeStrip(8, 16));
  pieces->Update();
  std::vector<int> methods = RelevoMethods::GetMethods();
  if (RelevoMethods::HasTessellation())
  {
    methods.push_back(vtkAdaptiveRefinementMapper::METHOD_HARDWARE_TESSELLATION);
  }
  for (int method : methods)
  {
    // The strip is flat at level 0 and curved at level 3.
    for (int level : { 0, 3 })
    {
      CHECK_CASE(level);
      const auto draw = [&](vtkPolyData* mesh)
      {
        RelevoScene scene(RelevoScene::Refining);
        scene.Add(
          mesh, MakeRecipe(level, level > 0 ? pn.Get() : nullptr, MakeDisplacement(heights, 0.15)));
        scene.GetMapper(0)->SetMethod(method);
        scene.ResetCameras();
        scene.Render();
        return RelevoPicture(scene.Window);
      };
      const RelevoPicture expected = draw(whole);
      CHECK_GREATER(expected.CountForeground(), 5000);
      if (!RelevoPictures::Equal(draw(pieces->GetOutput()), expected))
      {
        check.Fail(__FILE__, __LINE__,
          std::string(RelevoMethods::GetName(method)) + " at level " + std::to_string(level));
      }
    }
  }
  return check.GetResult();
}
