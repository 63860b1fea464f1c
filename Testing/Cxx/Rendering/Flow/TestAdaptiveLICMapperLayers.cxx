// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves limits.md on streaks and translucent layers, and that edges are drawn over the LIC.
#include "RelevoLICView.h"
#include "RelevoTestMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkProperty.h"

#include <cmath>
#include <string>

namespace
{
using namespace RelevoMeshes;
using Color = RelevoLICView::Color;

// A square of side 2 at height z.
Mesh Square(double z)
{
  const double offset[3] = { 0, 0, z };
  Mesh mesh = Moved(Plane(4, 4), 2.0, offset, VTK_FLOAT);
  RelevoLICVectors::AddVectors(mesh,
    [](const double* p) {
      return std::array<double, 3>{ { 1.0 - p[1], p[0], 0.0 } };
    });
  return mesh;
}

// Edges are drawn over the LIC.
void TestEdges(RelevoCheck& check)
{
  RelevoLICView view;
  vtkActor* actor = view.Add(Square(0.0));
  view.LookDown(1.1, 160);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetEdgeColor(1, 0, 0);
  view.Mapper->SetLICIntensity(1.0);
  const RelevoPicture picture = view.Draw();
  size_t red = 0;
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const Color color = RelevoLICView::At(picture, i);
    red += color[0] > color[1] + 0.25 ? 1 : 0;
  }
  CHECK_GREATER(red, 800);
}

RelevoPicture Mix(const RelevoPicture& behind, const RelevoPicture& front)
{
  RelevoPicture result = front;
  for (size_t i = 0; i < front.Colors.size(); ++i)
  {
    result.Colors[i] =
      static_cast<unsigned char>(std::lround(0.5 * (behind.Colors[i] + front.Colors[i])));
  }
  return result;
}

// Translucent layers, blended or peeled.
struct Layers
{
  RelevoComparison& Comparison;
  const bool Peeling;

  void SetUp(RelevoLICView& view) const
  {
    view.Scene->Renderer->SetUseDepthPeeling(this->Peeling);
    view.Scene->Renderer->SetMaximumNumberOfPeels(12);
    view.Scene->Renderer->SetOcclusionRatio(0.0);
    view.LookDown(1.1, 160);
  }

  void Compare(const std::string& name, const RelevoPicture& actual, RelevoPicture expected)
  {
    expected.Depths = actual.Depths; // translucent layers write no depths
    const std::string suffix = this->Peeling ? "Peeled" : "Blended";
    this->Comparison.Compare("LICLayers." + name + suffix, { 2, 0.0, 0 }, actual, expected);
  }
};

// Each mesh has a LIC, in front of an opaque layer and of a translucent one.
void TestLayersOfMeshes(Layers& layers, int contrast)
{
  RelevoLICView view;
  vtkActor* back = view.Scene->Add(Square(0.0), MakeRecipe(1));
  vtkActor* front = view.Add(Square(1.0), MakeRecipe(2));
  for (vtkActor* actor : { back, front })
  {
    RelevoLICVectors::GetMapper(actor)->SetEnhanceContrast(contrast);
  }
  front->GetProperty()->SetColor(1.0, 0.6, 0.2);
  layers.SetUp(view);
  const RelevoPicture fore = view.Draw();
  front->VisibilityOff();
  const RelevoPicture behind = view.Draw();
  front->VisibilityOn();
  front->GetProperty()->SetOpacity(0.5);
  const std::string number = std::to_string(contrast);
  layers.Compare("OverLIC" + number, view.Draw(), Mix(behind, fore));
  if (!layers.Peeling)
  {
    return; // blending several layers has no defined order
  }
  back->GetProperty()->SetOpacity(0.5);
  front->VisibilityOff();
  const RelevoPicture translucent = view.Draw();
  front->VisibilityOn();
  layers.Compare("TwoLayers" + number, view.Draw(), Mix(translucent, fore));
}

// Of one mesh, only the front layer has a LIC.
void TestLayersOfOneMesh(RelevoCheck& check, Layers& layers)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(Square(0.0));
  append->AddInputData(Square(1.0));
  append->Update();
  RelevoLICView view;
  vtkActor* actor = view.Add(append->GetOutput(), MakeRecipe(1));
  layers.SetUp(view);
  const RelevoPicture fore = view.Draw();
  view.Mapper->EnableOff();
  const RelevoPicture plain = view.Draw();
  actor->VisibilityOff();
  const RelevoPicture empty = view.Draw();
  actor->VisibilityOn();
  view.Mapper->EnableOn();
  actor->GetProperty()->SetOpacity(0.5);
  layers.Compare("OneMesh", view.Draw(), Mix(Mix(empty, plain), fore));
  CHECK_LESS_EQUAL(view.Mapper->GetNumberOfConvolutions(), 2);
}

void TestTranslucentLayers(RelevoCheck& check, RelevoComparison& comparison)
{
  for (const bool peeling : { false, true })
  {
    CHECK_CASE(peeling);
    Layers layers{ comparison, peeling };
    for (const int contrast : { 0, 1, 3, 4 })
    {
      TestLayersOfMeshes(layers, contrast);
    }
    if (peeling)
    {
      TestLayersOfOneMesh(check, layers);
    }
  }
}
}

int TestAdaptiveLICMapperLayers(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestEdges(check);
  TestTranslucentLayers(check, comparison);
  return check.GetResult();
}
