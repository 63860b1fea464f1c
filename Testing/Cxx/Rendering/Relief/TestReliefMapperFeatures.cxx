// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefMapper promises the features of other mappers: colours, lights, opacity, clipping
// planes, culling, bounds, selections, and depth tests against other actors.
#include "RelevoCheck.h"
#include "RelevoReliefScene.h"

#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <iostream>

namespace
{
using relevo::ReliefProjection;
using Methods = vtkReliefMapper::MethodType;
constexpr int Width = 120;
constexpr int Height = 90;

vtkSmartPointer<vtkImageData> MakeHills()
{
  return RelevoMakeRelief(
    48, 40, ReliefProjection::Parallel, RelevoSmallTexels(), RelevoHillsWithHoles);
}

vtkSmartPointer<vtkImageData> MakeFlat(double depth)
{
  return RelevoMakeRelief(
    48, 40, ReliefProjection::Parallel, RelevoSmallTexels(), [depth](int, int) { return depth; });
}

using Color = std::array<int, 3>;

std::vector<Color> DrawColors(RelevoReliefScene& scene)
{
  scene.Window->Render();
  const int* size = scene.Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  std::vector<Color> colors;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    colors.push_back(
      { { pixels->GetValue(3 * i), pixels->GetValue(3 * i + 1), pixels->GetValue(3 * i + 2) } });
  }
  return colors;
}

Color GetMiddle(const std::vector<Color>& colors)
{
  return colors[Height / 2 * Width + Width / 2];
}

// Interpolated colours of texels where rays hit the surface.
void TestColors(RelevoCheck& check, Methods method)
{
  const auto relief = MakeHills();
  RelevoReliefScene scene(relief, Width, Height);
  scene.Mapper->SetMethod(method);
  scene.Actor->GetProperty()->SetColor(0.2, 0.3, 0.4); // the relief has its own colours
  const std::vector<Color> colors = DrawColors(scene);
  const std::vector<RelevoReliefHit> hits = scene.Cast(relief);
  int number = 0;
  int wrong = 0;
  for (size_t i = 0; i < hits.size(); ++i)
  {
    if (hits[i].IsHit && colors[i][2] > 0)
    {
      ++number;
      wrong += std::abs(colors[i][0] - 255.0 * hits[i].Column / 47.0) > 4.0 ||
          std::abs(colors[i][1] - 255.0 * hits[i].Row / 39.0) > 4.0 || colors[i][2] != 128
        ? 1
        : 0;
    }
  }
  std::cout << "colours by method " << method << ": " << wrong << " of " << number << " wrong\n";
  CHECK_GREATER(number, 1000);
  CHECK_LESS_EQUAL(wrong, number / 200);
}

// A plane relief is lit like a plane vtkPolyData.
void TestLit(RelevoCheck& check, Methods method)
{
  const auto relief = MakeFlat(1.0);
  relief->GetPointData()->GetArray("Color")->Fill(180.0);
  RelevoReliefScene scene(relief, Width, Height);
  scene.Mapper->SetMethod(method);
  scene.Mapper->SetShadingToLit();
  scene.Renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetPosition(3.0, 4.0, -5.0);
  scene.Renderer->AddLight(light);
  const Color lit = GetMiddle(DrawColors(scene));

  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.1);
  plane->SetPoint1(0.0, 3.9, 0.1);
  plane->SetPoint2(4.7, 0.0, 0.1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  scene.Actor->SetMapper(mapper);
  scene.Actor->GetProperty()->SetColor(180.0 / 255.0, 180.0 / 255.0, 180.0 / 255.0);
  const Color expected = GetMiddle(DrawColors(scene));
  std::cout << "lit by method " << method << ": " << lit[0] << ", expected " << expected[0] << "\n";
  CHECK(expected[0] > 50 && expected[0] < 175);
  CHECK_NEAR(lit[0], expected[0], 2);
  scene.Actor->SetMapper(scene.Mapper);
  scene.Mapper->SetShadingToCaptured();
  CHECK_EQUAL(GetMiddle(DrawColors(scene))[0], 180);
}

void TestOpacity(RelevoCheck& check)
{
  const auto relief = MakeFlat(1.0);
  relief->GetPointData()->GetArray("Color")->Fill(200.0);
  RelevoReliefScene scene(relief, Width, Height);
  for (Methods method : { vtkReliefMapper::METHOD_WARP, vtkReliefMapper::METHOD_RAY_MARCH,
         vtkReliefMapper::METHOD_REFINEMENT, vtkReliefMapper::METHOD_AUTOMATIC })
  {
    scene.Mapper->SetMethod(method);
    for (bool peeling : { false, true })
    {
      CHECK_CASE(peeling);
      scene.Renderer->SetUseDepthPeeling(peeling);
      scene.Actor->GetProperty()->SetOpacity(0.5);
      CHECK_NEAR(GetMiddle(DrawColors(scene))[0], 100, 1.0);
      scene.Actor->GetProperty()->SetOpacity(1.0);
      CHECK_EQUAL(GetMiddle(DrawColors(scene))[0], 200);
    }
  }
  // Opacity is the colours' fourth component.
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(relief->GetNumberOfPoints());
  colors->Fill(51.0);
  relief->GetPointData()->AddArray(colors);
  CHECK_NEAR(GetMiddle(DrawColors(scene))[0], 0.2 * 51.0, 1.0);
  CHECK(scene.Mapper->HasTranslucentPolygonalGeometry());
}

void TestClipping(RelevoCheck& check, Methods method)
{
  const auto relief = MakeHills();
  RelevoReliefScene scene(relief, Width, Height);
  scene.Mapper->SetMethod(method);
  scene.GetCamera()->Azimuth(60.0); // shows hills behind the clipped ones
  scene.Renderer->ResetCameraClippingRange();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(scene.Actor->GetCenter());
  plane->SetNormal(0.2, 0.1, 1.0);
  scene.Mapper->AddClippingPlane(plane);
  const RelevoReliefComparison result = scene.Compare(relief, 8.0, 0.5,
    [&](const RelevoReliefHit& hit)
    {
      double point[3] = { hit.Point[0], hit.Point[1], hit.Point[2] };
      return plane->EvaluateFunction(point) >= 0.0;
    });
  std::cout << "clipped by method " << method << ": " << result.NumberOfHits << " hits, "
            << result.NumberOfMisses << " missed, " << result.NumberOfWrong << " wrong\n";
  CHECK_GREATER(result.NumberOfHits, 300);
  CHECK_LESS_EQUAL(result.NumberOfMisses + result.NumberOfWrong, result.NumberOfHits / 100);
}

void TestCulling(RelevoCheck& check, Methods method)
{
  const auto count = [](RelevoReliefScene& scene)
  {
    const std::vector<float> depths = scene.DrawDepths();
    return std::count_if(depths.begin(), depths.end(), [](float depth) { return depth < 1.0f; });
  };
  RelevoReliefScene scene(MakeFlat(1.0), Width, Height);
  scene.Mapper->SetMethod(method);
  const auto all = count(scene);
  scene.Actor->GetProperty()->BackfaceCullingOn();
  CHECK_EQUAL(count(scene), all);
  CHECK_GREATER(all, 1000);
  scene.Actor->GetProperty()->FrontfaceCullingOn();
  scene.Actor->GetProperty()->BackfaceCullingOff();
  CHECK_EQUAL(count(scene), 0);
  scene.GetCamera()->Azimuth(180.0);
  scene.Renderer->ResetCameraClippingRange();
  CHECK_GREATER(count(scene), 1000);
  scene.Actor->GetProperty()->BackfaceCullingOn();
  scene.Actor->GetProperty()->FrontfaceCullingOff();
  CHECK_EQUAL(count(scene), 0);
}

void TestBounds(RelevoCheck& check)
{
  vtkNew<vtkReliefMapper> mapper;
  mapper->SetInputData(RelevoMakeRelief(40, 30, ReliefProjection::Parallel, RelevoSmallTexels(),
    [](int column, int row)
    {
      const bool isInside = column >= 10 && column <= 20 && row >= 5 && row <= 9;
      return isInside || (column == 0 && row == 0) ? 3.0 + 0.1 * column : std::nan("");
    }));
  const double expected[6] = { 1.0, 2.0, 0.5, 0.9, 0.4, 0.5 }; // a single texel is not a surface
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(mapper->GetBounds()[i], expected[i], 1e-6);
  }
}

// A selection returns ids of the image.
void TestSelection(RelevoCheck& check, Methods method, bool points)
{
  const auto relief = MakeHills();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, relief);
  RelevoReliefScene scene(blocks, Width, Height);
  scene.Mapper->SetMethod(method);
  scene.Window->Render();
  const std::vector<RelevoReliefHit> hits = scene.Cast(relief);
  const int x = Width / 2 - 12;
  const int y = Height / 2 + 7;
  const RelevoReliefHit& hit = hits[y * Width + x];
  if (!CHECK(hit.IsHit))
  {
    return;
  }
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(x, y, x, y);
  selector->SetFieldAssociation(
    points ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  if (!CHECK_EQUAL(selection->GetNumberOfNodes(), 1))
  {
    return;
  }
  vtkSelectionNode* node = selection->GetNode(0);
  CHECK_EQUAL(node->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor);
  CHECK_EQUAL(node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()), 2);
  auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
  const int column = static_cast<int>(points ? std::lround(hit.Column) : hit.Column);
  const int row = static_cast<int>(points ? std::lround(hit.Row) : hit.Row);
  CHECK_EQUAL(ids->GetNumberOfValues(), 1);
  CHECK_EQUAL(ids->GetValue(0), row * (points ? 48 : 47) + column);
}

// The surface is dark where it lies between a point and the light, as rays find it.
void TestSelfShadow(RelevoCheck& check, Methods method, bool isPositional)
{
  const auto relief = RelevoMakeRelief(60, 50, ReliefProjection::Parallel, RelevoSmallTexels(),
    [](int column, int row)
    {
      const double ball = 100.0 - std::pow(column - 25.0, 2.0) - std::pow(row - 25.0, 2.0);
      return 20.0 - (ball > 0.0 ? std::sqrt(ball) : 0.0);
    });
  RelevoReliefScene scene(relief, Width, Height);
  scene.Mapper->SetMethod(method);
  scene.Mapper->SetShadingToLit();
  scene.Renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  const RelevoVectors::Vector lamp = { { -6.0, 3.5, -3.0 } };
  const RelevoVectors::Vector focus = { { 2.5, 2.5, 2.0 } };
  light->SetPosition(lamp.data());
  light->SetFocalPoint(focus.data());
  light->SetPositional(isPositional);
  light->SetConeAngle(180.0);
  scene.Renderer->AddLight(light);
  const std::vector<Color> unshadowed = DrawColors(scene);
  scene.Mapper->SelfShadowOn();
  const std::vector<Color> colors = DrawColors(scene);
  const RelevoReliefRays rays(relief);
  const std::vector<RelevoReliefHit> hits = scene.Cast(relief);
  int dark = 0;
  int wrong = 0;
  using namespace RelevoVectors;
  for (size_t i = 0; i < hits.size(); ++i)
  {
    if (hits[i].IsHit && unshadowed[i][2] > 20)
    {
      const Vector along = normalize(isPositional ? lamp - hits[i].Point : lamp - focus);
      const bool isDark = rays.Cast(hits[i].Point, along, 0.025, 20.0).IsHit;
      dark += isDark ? 1 : 0;
      wrong += isDark != (colors[i][2] == 0) ? 1 : 0;
    }
  }
  std::cout << "shadow by method " << method << ": " << dark << " dark, " << wrong << " wrong\n";
  CHECK_GREATER(dark, 100);
  CHECK_LESS_EQUAL(wrong, dark / 20);
}

// VTK's pickers find the same.
void TestPickers(RelevoCheck& check, bool isComposite)
{
  const auto relief = MakeHills();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, relief);
  RelevoReliefScene scene(
    isComposite ? static_cast<vtkDataObject*>(blocks) : relief.Get(), Width, Height);
  scene.Window->Render();
  const std::vector<RelevoReliefHit> hits = scene.Cast(relief);
  vtkNew<vtkCellPicker> cells;
  cells->SetTolerance(0.0);
  vtkNew<vtkPropPicker> props;
  int number = 0;
  for (int y = 5; y < Height; y += 20)
  {
    for (int x = 5; x < Width; x += 20)
    {
      const RelevoReliefHit& hit = hits[y * Width + x];
      const bool isPicked = cells->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer) != 0;
      CHECK_EQUAL(isPicked, hit.IsHit);
      CHECK_EQUAL((props->PickProp(x, y, scene.Renderer) != 0), hit.IsHit);
      if (isPicked && hit.IsHit)
      {
        ++number;
        CHECK_NEAR(
          cells->GetCellId(), (static_cast<int>(hit.Row) * 47 + static_cast<int>(hit.Column)), 48);
        const RelevoVectors::Vector place = { { cells->GetPickPosition()[0],
          cells->GetPickPosition()[1], cells->GetPickPosition()[2] } };
        CHECK_LESS(RelevoVectors::length(RelevoVectors::operator-(place, hit.Point)), 0.05);
      }
    }
  }
  CHECK_GREATER(number, 4);
}

// Two halves look like the whole, also where they touch. Another actor hides the relief and is
// hidden by it.
void TestTogether(RelevoCheck& check, Methods method)
{
  const auto whole =
    RelevoMakeRelief(48, 40, ReliefProjection::Parallel, RelevoSmallTexels(), RelevoHills);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 2; ++i)
  {
    auto half = vtkSmartPointer<vtkImageData>::New();
    half->DeepCopy(whole);
    vtkDataArray* depths = half->GetPointData()->GetArray("Depth");
    for (vtkIdType point = 0; point < depths->GetNumberOfTuples(); ++point)
    {
      if (i == 0 ? point % 48 > 21 : point % 48 < 21)
      {
        depths->SetComponent(point, 0, std::nan(""));
      }
    }
    blocks->SetBlock(i, half);
  }
  RelevoReliefScene scene(blocks, Width, Height);
  scene.Mapper->SetMethod(method);
  const RelevoReliefComparison result = scene.Compare(whole);
  std::cout << "halves by method " << method << ": " << result.NumberOfMisses << " missed, "
            << result.NumberOfWrong << " wrong\n";
  CHECK_LESS_EQUAL(result.NumberOfMisses, 2);
  CHECK_LESS_EQUAL(result.NumberOfWrong, result.NumberOfHits / 200);

  const std::vector<float> alone = scene.DrawDepths();
  vtkNew<vtkPlaneSource> plane;
  const double* bounds = scene.Actor->GetBounds();
  const double middle = 0.5 * (bounds[4] + bounds[5]);
  plane->SetOrigin(bounds[0], bounds[2], middle);
  plane->SetPoint1(bounds[1], bounds[2], middle);
  plane->SetPoint2(bounds[0], bounds[3], middle);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  const std::vector<float> together = scene.DrawDepths();
  scene.Renderer->RemoveActor(scene.Actor);
  const std::vector<float> other = scene.DrawDepths();
  int inFront = 0;
  int behind = 0;
  bool isNearest = true;
  for (size_t i = 0; i < alone.size(); ++i)
  {
    isNearest = isNearest && together[i] == std::min(alone[i], other[i]);
    inFront += alone[i] < other[i] && other[i] < 1.0f ? 1 : 0;
    behind += other[i] < alone[i] && alone[i] < 1.0f ? 1 : 0;
  }
  CHECK(isNearest);
  CHECK_GREATER(inFront, 500);
  CHECK_GREATER(behind, 500);
}
}

int TestReliefMapperFeatures(int, char*[])
{
  RelevoCheck check;
  for (Methods method : { vtkReliefMapper::METHOD_RAY_MARCH, vtkReliefMapper::METHOD_REFINEMENT })
  {
    TestColors(check, method);
    TestLit(check, method);
    TestClipping(check, method);
    TestCulling(check, method);
    TestSelection(check, method, false);
    TestSelection(check, method, true);
    TestTogether(check, method);
    TestSelfShadow(check, method, method == vtkReliefMapper::METHOD_RAY_MARCH);
  }
  TestLit(check, vtkReliefMapper::METHOD_WARP);
  TestPickers(check, false);
  TestPickers(check, true);
  TestOpacity(check);
  TestBounds(check);
  return check.GetResult();
}
