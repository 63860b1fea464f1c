// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: cell projection splits cells of all kinds. With a linear field it equals
// vtkVolumeRayCastFilter, which does not split; with bent faces, the lengths of rays are compared.
#include "RelevoCheck.h"
#include "RelevoMixedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

namespace
{
constexpr int NumberOfModes = 6;
constexpr int Width = 160;
constexpr int Height = 120;

vtkSmartPointer<vtkUnstructuredGrid> MakeCells(double share, const RelevoField& field)
{
  auto mesh = MakeMixedCells(4, 3, share);
  vtkNew<vtkDoubleArray> scalars;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    scalars->InsertNextValue(field(at));
  }
  mesh->GetPointData()->SetScalars(scalars);
  return mesh;
}

void TestLinearField(RelevoCheck& check)
{
  const auto property = MakeBusyProperty(0.3);
  property->GetIsoSurfaceValues()->SetValue(0, 0.41);
  property->GetIsoSurfaceValues()->SetValue(1, 0.63);
  RelevoVolumeScene scene(MakeCells(0.0, GetLinearField), property);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  mapper->IsoSurfacesOn();
  const auto compare = [&](int mode)
  {
    mapper->SetBlendMode(mode);
    // On a silhouette, a ray may hit a cell that another one misses.
    return scene.Compare(0.0005,
      [=](vtkVolumeRayCastFilter* filter)
      {
        filter->SetBlendMode(mode);
        filter->IsoSurfacesOn();
      });
  };
  for (bool isShaded : { false, true })
  {
    CHECK_CASE(isShaded);
    property->SetShade(isShaded);
    for (int mode = 0; mode < NumberOfModes; ++mode)
    {
      CHECK_NEAR(compare(mode), 0.0, 1.0);
    }
  }
  vtkNew<vtkPiecewiseFunction> gradients;
  gradients->AddPoint(0.0, 0.0);
  gradients->AddPoint(1.0, 1.0);
  property->SetGradientOpacity(gradients);
  CHECK_NEAR(compare(0), 0.0, 1.0);
  CHECK_NEAR(compare(4), 0.0, 1.0);
}

// Faces are split alike on both sides, so there are no gaps and overlaps: the sum over all cells is
// the length of the ray.
void TestBentFaces(RelevoCheck& check)
{
  const auto property = MakeVolumeProperty(1.0, 1.0, 2.0);
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  RelevoVolumeScene scene(
    MakeCells(0.2, [](const RelevoPoint&) { return 0.5; }), property, Width, Height);
  scene.GetMapper()->SetBlendModeToAdditive();
  const auto drawn = scene.Draw();
  std::vector<RelevoColor> expected;
  for (int i = 0; i < Width * Height; ++i)
  {
    const RelevoRay ray(scene.GetCamera(), i % Width, i / Width, Width, Height);
    double begin;
    double end;
    const double depth =
      ray.CutBox(0.0, 1.0, begin, end) ? std::min(0.5 * (end - begin), 1.0) : 0.0;
    expected.push_back({ { depth, depth, depth, 0.0 } });
  }
  CHECK_NEAR(RelevoVolumeScene::Compare(drawn, expected, 0.0005), 0.0, 1.0);
}
}

int TestGPUUnstructuredGridVolumeMapperProjectionCells(int, char*[])
{
  RelevoVolumeScene::SetMethod(vtkGPUUnstructuredGridVolumeMapper::CELL_PROJECTION);
  RelevoCheck check;
  TestLinearField(check);
  TestBentFaces(check);
  return check.GetResult();
}
