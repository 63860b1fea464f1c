// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves surfaces.md on missing values: scalars and vectors are coloured as vtkPolyDataMapper
// colours the filter's output, or the input at level 0. Values beyond the float range give the
// filter's error, and nothing is drawn.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDisplacement.h"
#include "vtkLookupTable.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace RelevoMeshes;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
// A refined vertex between two colours may get either, see TestAdaptiveRefinementMapperLife.
const RelevoTolerance Close{ 3, 2e-6, 60 };

Mesh MakeMesh(int components, const std::array<double, 3>& marker)
{
  Mesh mesh = Sphere(10, 8);
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      const bool isMarked = i % 9 == 4;
      values->SetComponent(i, c, isMarked ? marker[static_cast<size_t>(c)] : mesh->GetPoint(i)[c]);
    }
  }
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

void SetColors(RelevoScene& scene, bool interpolated, bool magnitude)
{
  vtkMapper* mapper = scene.GetActor(0)->GetMapper();
  vtkNew<vtkLookupTable> table;
  table->SetRange(magnitude ? 0.0 : -0.6, 0.6);
  table->SetNanColor(1.0, 0.0, 1.0, 1.0);
  table->UseBelowRangeColorOn();
  table->SetBelowRangeColor(0.0, 0.0, 0.0, 1.0);
  table->UseAboveRangeColorOn();
  table->SetAboveRangeColor(1.0, 1.0, 1.0, 1.0);
  table->Build();
  if (magnitude)
  {
    table->SetVectorModeToMagnitude();
  }
  else
  {
    table->SetVectorModeToComponent();
  }
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetInterpolateScalarsBeforeMapping(interpolated);
}

void TestColors(RelevoComparison& comparison)
{
  const std::array<double, 3> markers[] = { { { -1e9, 0.0, 0.0 } }, { { NaN, NaN, NaN } },
    { { Infinity, 0.0, 0.0 } } };
  const char* names[] = { "Marker", "NaN", "Infinity" };
  for (int m = 0; m < 3; ++m)
  {
    for (int components : { 1, 3 })
    {
      for (bool magnitude : { false, true })
      {
        if ((components == 1 && magnitude) || (components == 1 && m == 0))
        {
          continue; // single numbers have no marker
        }
        for (bool interpolated : { false, true })
        {
          const std::string name = std::string("NoData.") + names[m] + std::to_string(components) +
            (magnitude ? "Magnitude" : "") + (interpolated ? "Interpolated" : "");
          const auto build = [&](int level)
          {
            return [&, level](RelevoScene& scene)
            {
              scene.Window->SetSize(150, 150);
              scene.Add(MakeMesh(components, markers[m]), level ? MakeRecipe(level) : nullptr);
              scene.GetActor(0)->GetProperty()->LightingOff();
              SetColors(scene, interpolated, magnitude);
            };
          };
          comparison.Compare(name + "0", Close, build(0));
          // TestInterpolated() tests magnitudes with textures.
          if (!(interpolated && magnitude))
          {
            comparison.Compare(name + "3", Close, build(3));
          }
        }
      }
    }
  }
}

size_t CountColor(const RelevoPicture& picture, const std::array<unsigned char, 3>& color)
{
  size_t count = 0;
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    count += std::equal(color.begin(), color.end(), &picture.Colors[3 * i]) ? 1 : 0;
  }
  return count;
}

// Magnitudes as texture coordinates. NoDataMagnitude takes effect.
void TestInterpolated(RelevoCheck& check)
{
  for (double limit : { 1e8, Infinity })
  {
    CHECK_CASE(limit);
    RelevoScene scene(RelevoScene::Refining);
    scene.Window->SetSize(150, 150);
    auto recipe = MakeRecipe(3);
    recipe->SetNoDataMagnitude(1e8);
    scene.Add(MakeMesh(3, { { -1e9, 0.0, 0.0 } }), recipe);
    scene.GetActor(0)->GetProperty()->LightingOff();
    SetColors(scene, true, true);
    scene.ResetCameras();
    scene.Render();
    recipe->SetNoDataMagnitude(limit);
    scene.Render();
    const RelevoPicture picture(scene.Window);
    const size_t none = CountColor(picture, { { 255, 0, 255 } });
    const size_t above = CountColor(picture, { { 255, 255, 255 } });
    CHECK(limit == 1e8 ? none > 1000 && above < 10 : none == 0 && above > 1000);
  }
}

void TestRange(RelevoCheck& check)
{
  vtkNew<vtkDisplacement> displacement;
  vtkNew<vtkPNTriangleSurface> surface;
  RelevoScene scene(RelevoScene::Refining);
  scene.Window->SetSize(80, 80);
  auto recipe = MakeRecipe(2, nullptr, displacement);
  scene.Add(Sphere(12, 9), recipe);
  vtkAdaptiveRefinementMapper* mapper = scene.GetMapper(0);
  RelevoErrors errors(mapper);
  scene.ResetCameras();
  scene.Render();
  const size_t drawn = RelevoPicture(scene.Window).CountForeground();
  CHECK(drawn > 500 && errors.None());
  const auto isRefused = [&](const std::string& words)
  {
    double bounds[6];
    mapper->GetBounds(bounds);
    CHECK(std::all_of(bounds, bounds + 6, [](double b) { return std::isfinite(b); }));
    scene.Render();
    CHECK(errors.Said(words));
    scene.Render();
    CHECK(errors.None()); // reported once
    CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), 0);
    CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  };
  displacement->SetOffset(1e38);
  isRefused("lower Scale or Offset");
  displacement->SetOffset(0.0);
  scene.Render();
  CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), drawn);

  recipe->SetDisplacement(nullptr);
  recipe->SetSurface(surface);
  const double none[3] = { 0.0, 0.0, 0.0 };
  Mesh large = Moved(Sphere(12, 9), 1e35, none, VTK_FLOAT);
  mapper->SetInputData(large);
  isRefused("scale the mesh down");
}
}

int TestAdaptiveRefinementMapperNoData(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestColors(comparison);
  TestInterpolated(check);
  TestRange(check);
  return check.GetResult();
}
