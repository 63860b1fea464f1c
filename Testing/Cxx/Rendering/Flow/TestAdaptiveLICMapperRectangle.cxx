// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that convolving only the rectangle of the viewport that the surface's bounds cover gives
// the same picture as the whole viewport.
#include "RelevoSurfaceFields.h"

#include "vtkAdaptiveLICMapper.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDisplacement.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
constexpr int Width = 140;
constexpr int Height = 100;

// Two invisible slivers far away on both sides make the bounds cover the viewport.
RelevoMeshes::Mesh WithFarSlivers(vtkPolyData* mesh)
{
  auto wide = RelevoMeshes::Make();
  wide->DeepCopy(mesh);
  vtkPointData* data = wide->GetPointData();
  for (const double side : { -1.0, 1.0 })
  {
    const double place = side * 40.0;
    vtkIdType ids[3];
    for (vtkIdType& id : ids)
    {
      id = wide->GetPoints()->InsertNextPoint(place, place, place);
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        data->GetArray(i)->InsertNextTuple(0, mesh->GetPointData()->GetArray(i));
      }
    }
    wide->GetPoints()->SetPoint(ids[1], place + 1e-5, place, place);
    wide->GetPoints()->SetPoint(ids[2], place, place + 1e-5, place);
    wide->GetPolys()->InsertNextCell(3, ids);
  }
  return wide;
}

class Scene : public RelevoLICScene
{
public:
  explicit Scene(vtkPolyData* mesh)
    : RelevoLICScene(Width, Height)
  {
    this->Heights->FillWaves();
    vtkNew<vtkDisplacement> displacement;
    displacement->SetHeightMap(this->Heights);
    displacement->SetScale(0.3); // far beyond the coarse points
    vtkNew<vtkPNTriangleSurface> surface;
    const auto recipe = RelevoMeshes::MakeRecipe(2, surface, displacement);
    this->Mapper = this->Add(mesh, recipe);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -3.0, 4.0);
    camera->SetClippingRange(0.1, 12.0);
  }

  vtkNew<RelevoHeights> Heights;
  vtkAdaptiveLICMapper* Mapper = nullptr;
};

struct View
{
  std::string Name;
  std::function<void(Scene&)> Set;
};

std::vector<View> MakeViews()
{
  return { { "whole", [](Scene& s) { s.Renderer->GetActiveCamera()->Zoom(0.6); } },
    { "parallel",
      [](Scene& s)
      {
        s.Renderer->GetActiveCamera()->ParallelProjectionOn();
        s.Renderer->GetActiveCamera()->SetParallelScale(4.0);
      } },
    { "cut off by the window", [](Scene& s) { s.Renderer->GetActiveCamera()->Yaw(20.0); } },
    { "around the camera",
      [](Scene& s)
      {
        s.Renderer->GetActiveCamera()->SetPosition(0.0, -1.1, 0.9);
        s.Renderer->GetActiveCamera()->SetClippingRange(0.01, 12.0);
      } },
    { "moved and scaled",
      [](Scene& s)
      {
        s.Actor->SetPosition(1.0, 0.5, 0.0);
        s.Actor->SetScale(0.5, 0.7, 0.3);
      } },
    { "part of the window", [](Scene& s) { s.Renderer->SetViewport(0.3, 0.2, 0.9, 0.8); } },
    { "smoothed",
      [](Scene& s)
      {
        s.Renderer->GetActiveCamera()->Zoom(0.5);
        s.Mapper->SetAntiAlias(2);
        s.Mapper->SetEnhanceContrastToLIC();
      } } };
}

void Test(RelevoCheck& check, vtkPolyData* mesh, vtkPolyData* wide, const View& view)
{
  std::vector<RelevoPicture> pictures;
  for (vtkPolyData* drawn : { mesh, wide })
  {
    Scene scene(drawn);
    view.Set(scene);
    scene.Window->Render();
    pictures.emplace_back(scene.Window);
  }
  const std::size_t streaks = RelevoLICPicture(pictures[0]).CountLIC();
  std::size_t different = 0;
  for (std::size_t i = 0; i < pictures[0].Colors.size(); ++i)
  {
    // Faces that the window's border clips may differ in the last bits.
    different += std::abs(pictures[0].Colors[i] - pictures[1].Colors[i]) > 2 ? 1 : 0;
  }
  std::cout << view.Name << ": " << streaks << " pixels of LIC, " << different
            << " values differ\n";
  CHECK_GREATER(streaks, 300);
  CHECK_EQUAL(different, 0);
}
}

int TestAdaptiveLICMapperRectangle(int, char*[])
{
  RelevoCheck check;
  const auto mesh = WithField(RelevoMeshes::Torus(), MakeSurfaceFields(NormalOfTorus)[1].Field);
  const auto wide = WithFarSlivers(mesh);
  for (const View& view : MakeViews())
  {
    Test(check, mesh, wide, view);
  }
  return check.GetResult();
}
