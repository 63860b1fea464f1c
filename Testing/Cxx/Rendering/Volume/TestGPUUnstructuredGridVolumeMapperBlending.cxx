// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: blend modes, isosurfaces and clipping planes equal those of
// vtkVolumeRayCastFilter, with both methods.
#include "RelevoBusyVolumes.h"
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>

namespace
{
constexpr int NumberOfModes = 6;

double CompareMode(RelevoVolumeScene& scene, int mode, double share = 0.0)
{
  scene.GetMapper()->SetBlendMode(mode);
  return scene.Compare(share, [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); });
}

void LookInside(vtkCamera* camera)
{
  camera->SetPosition(0.2, 0.1, 0.0);
  camera->SetFocalPoint(1.0, 0.5, 0.1);
  camera->SetViewAngle(70.0);
  camera->SetClippingRange(0.01, 10.0);
}

void TestModes(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  scene.GetVolume()->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 0.45);
  for (bool isInside : { false, true })
  {
    CHECK_CASE(isInside);
    if (isInside)
    {
      LookInside(scene.GetCamera());
    }
    for (int mode = 0; mode < NumberOfModes; ++mode)
    {
      CHECK_NEAR(CompareMode(scene, mode), 0.0, 1.0);
    }
  }
}

// For a field linear in space, the ends of a ray determine the result.
void TestLinearField(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 60, 50);
  const auto map = [](double s) -> RelevoColor
  {
    const double opacity = 0.2 + 0.8 * s;
    return { { (1.0 - s) * opacity, 0.0, s * opacity, 0.0 } };
  };
  for (int mode = 1; mode <= 3; ++mode)
  {
    scene.GetMapper()->SetBlendMode(mode);
    const auto drawn = scene.Draw();
    std::vector<RelevoColor> expected;
    for (int i = 0; i < 60 * 50; ++i)
    {
      const RelevoRay ray(scene.GetCamera(), i % 60, i / 60, 60, 50);
      double begin;
      double end;
      RelevoColor color = {};
      if (ray.CutBox(0.0, 1.0, begin, end))
      {
        const double a = GetLinearField(ray.At(begin));
        const double b = GetLinearField(ray.At(end));
        color = map(mode == 1 ? std::max(a, b) : mode == 2 ? std::min(a, b) : 0.5 * (a + b));
      }
      expected.push_back(color);
    }
    CHECK_NEAR(255.0 * FindLargestDifference(drawn, expected), 0.0, 1.0);
  }
}

void SetValues(vtkVolumeProperty* property, const std::vector<double>& values)
{
  vtkContourValues* contours = property->GetIsoSurfaceValues();
  contours->SetNumberOfContours(static_cast<int>(values.size()));
  for (size_t i = 0; i < values.size(); ++i)
  {
    contours->SetValue(static_cast<int>(i), values[i]);
  }
}

double CompareSurfaces(RelevoVolumeScene& scene, double share = 0.0)
{
  scene.GetMapper()->SetBlendModeToComposite();
  scene.GetMapper()->IsoSurfacesOn();
  return scene.Compare(share, [](vtkVolumeRayCastFilter* filter) { filter->IsoSurfacesOn(); });
}

void TestIsoSurfaces(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  vtkVolumeProperty* property = scene.GetVolume()->GetProperty();
  SetValues(property, { 0.7, 0.2, 0.35, 0.36 });
  // A ray that grazes a surface may hit it twice or not at all.
  CHECK_NEAR(CompareSurfaces(scene, 0.0002), 0.0, 1.0);
  CHECK_NEAR(CompareMode(scene, 5, 0.0002), 0.0, 1.0);
  LookInside(scene.GetCamera());
  CHECK_NEAR(CompareSurfaces(scene, 0.0002), 0.0, 1.0);
  CHECK_NEAR(CompareMode(scene, 5, 0.0002), 0.0, 1.0);
  SetValues(property, {});
  CHECK_EQUAL(CompareMode(scene, 5), 0.0);
  CHECK_NEAR(CompareSurfaces(scene), 0.0, 1.0);
}

// The isovalue lies in planes of corners shared by cells, and on the mesh's border.
void TestSurfacesInFaces(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto mesh =
      MakeTetrahedra(i == 0 ? 4 : 6, [=](const RelevoPoint& at) { return i + at[0]; });
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      double x[3];
      mesh->GetPoint(point, x);
      mesh->GetPoints()->SetPoint(point, x[0] + i, x[1], x[2]);
    }
    blocks->SetBlock(i, mesh);
  }
  auto property = MakeVolumeProperty(0.2, 0.6);
  SetValues(property, { 0.0, 0.25, 0.5, 1.0, 1.5, 2.0 });
  RelevoVolumeScene scene(blocks, property);
  CHECK_NEAR(CompareMode(scene, 5, 0.001), 0.0, 1.0);
  CHECK_NEAR(CompareSurfaces(scene, 0.001), 0.0, 1.0);
  scene.GetCamera()->Azimuth(130.0);
  scene.GetRenderer()->ResetCameraClippingRange();
  CHECK_NEAR(CompareMode(scene, 5, 0.001), 0.0, 1.0);
}

// Cell scalars support all modes. Isosurfaces are those of averages at points.
void TestCellScalars(RelevoCheck& check)
{
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(MakeBall(200));
  toCells->Update();
  auto property = MakeBusyProperty(0.3);
  SetValues(property, { 0.3, 0.5 });
  RelevoVolumeScene scene(toCells->GetOutput(), property);
  for (int mode = 0; mode < NumberOfModes; ++mode)
  {
    CHECK_NEAR(CompareMode(scene, mode, 0.0002), 0.0, 1.0);
  }
  CHECK_GREATER(FindLargestDifference(scene.Draw(), std::vector<RelevoColor>(160 * 120)), 0.1);
  CHECK_NEAR(CompareSurfaces(scene, 0.0002), 0.0, 1.0);
}

vtkSmartPointer<vtkPlane> MakePlane(const RelevoPoint& origin, const RelevoPoint& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  return plane;
}

void TestClipping(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  const auto compare = [&]
  {
    return scene.Compare(0.0,
      [=](vtkVolumeRayCastFilter* filter)
      { filter->SetClippingPlanes(mapper->GetClippingPlanes()); });
  };
  const auto whole = scene.Draw();
  const auto plane = MakePlane({ { 0.1, 0.0, 0.0 } }, { { -1.0, 0.3, 0.2 } });
  mapper->AddClippingPlane(plane);
  CHECK_NEAR(compare(), 0.0, 1.0);
  mapper->AddClippingPlane(MakePlane({ { 0.0, 0.2, 0.0 } }, { { 0.0, -2.0, 1.0 } }));
  CHECK_NEAR(compare(), 0.0, 1.0);
  CHECK_GREATER(FindLargestDifference(scene.Draw(), whole), 0.3);
  plane->SetOrigin(-0.3, 0.0, 0.0);
  CHECK_NEAR(compare(), 0.0, 1.0);
  LookInside(scene.GetCamera());
  CHECK_NEAR(compare(), 0.0, 1.0);
  // Planes may be parallel to the rays.
  mapper->RemoveAllClippingPlanes();
  scene.GetCamera()->ParallelProjectionOn();
  scene.GetCamera()->SetPosition(0.0, 0.0, 4.0);
  scene.GetCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  scene.GetCamera()->SetParallelScale(1.0);
  mapper->AddClippingPlane(MakePlane({ { 0.1001, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }));
  CHECK_NEAR(compare(), 0.0, 1.0);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 1);
  mapper->AddClippingPlane(plane);
  mapper->SetMethodToCellProjection();
  CHECK_LESS_EQUAL(compare(), 1.0);
}

// Clipping planes are in world coordinates, while a matrix moves the volume far from its points.
void TestClippedPlaces(RelevoCheck& check)
{
  RelevoVolumeScene near(MakeBall(200), MakeBusyProperty(0.3));
  near.GetMapper()->AddClippingPlane(MakePlane({ { 0.1, 0.0, 0.0 } }, { { -1.0, 0.3, 0.2 } }));
  RelevoVolumeScene far(MakeBall(200, 1e7), MakeBusyProperty(0.3));
  vtkNew<vtkMatrix4x4> back;
  for (int i = 0; i < 3; ++i)
  {
    back->SetElement(i, 3, -1e7);
  }
  far.GetVolume()->SetUserMatrix(back);
  far.GetMapper()->AddClippingPlane(MakePlane({ { 0.1, 0.0, 0.0 } }, { { -1.0, 0.3, 0.2 } }));
  far.GetCamera()->DeepCopy(near.GetCamera());
  CHECK_LESS_EQUAL(FindLargestDifference(near.Draw(), far.Draw()), 1.5 / 255.0);
}

// A translucent square lies in the middle of the volume. The picture shows the volume in front of
// it, the square, and the volume behind it.
void TestPeeling(RelevoCheck& check)
{
  auto property = MakeVolumeProperty(0.2, 1.0, 0.4);
  SetValues(property, { 0.4, 0.6 });
  property->ShadeOn();
  property->SetAmbient(0.3);
  property->SetDiffuse(0.7);
  RelevoVolumeScene scene(MakeTetrahedra(4, GetLinearField), property, 60, 60);
  vtkCamera* camera = scene.GetCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(0.5, 0.5, 4.0);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetParallelScale(0.45);
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(-1.0, -1.0, 0.5);
  square->SetPoint1(2.0, -1.0, 0.5);
  square->SetPoint2(-1.0, 2.0, 0.5);
  vtkNew<vtkPolyDataMapper> squareMapper;
  squareMapper->SetInputConnection(square->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(squareMapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.2, 1.0, 0.4);
  actor->GetProperty()->SetOpacity(0.5);
  scene.GetRenderer()->AddActor(actor);
  scene.GetRenderer()->ResetCameraClippingRange();
  scene.GetRenderer()->UseDepthPeelingOn();
  scene.GetRenderer()->UseDepthPeelingForVolumesOn();
  for (bool isSurface : { false, true })
  {
    scene.GetMapper()->IsoSurfacesOn();
    scene.GetMapper()->SetBlendMode(isSurface ? 5 : 0);
    std::vector<RelevoColor> parts[2];
    for (int side = 0; side < 2; ++side)
    {
      parts[side] = scene.Cast(
        [=](vtkVolumeRayCastFilter* filter)
        {
          filter->IsoSurfacesOn();
          filter->SetBlendMode(isSurface ? 5 : 0);
          const double up = side == 0 ? 1.0 : -1.0;
          filter->AddClippingPlane(MakePlane({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, up } }));
        });
    }
    const auto drawn = scene.Draw();
    std::vector<RelevoColor> expected = parts[0];
    const RelevoColor middle = { { 0.1, 0.5, 0.2, 0.5 } };
    for (size_t i = 0; i < expected.size(); ++i)
    {
      for (size_t c = 0; c < 4; ++c)
      {
        expected[i][c] += (1.0 - parts[0][i][3]) * (middle[c] + 0.5 * parts[1][i][c]);
      }
    }
    // The square may hide a surface that it touches.
    CHECK_NEAR(RelevoVolumeScene::Compare(drawn, expected, 0.03), 0.0, 2.0);
  }
}

void TestBadSettings(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(2, GetLinearField), MakeLinearProperty());
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  RelevoErrors errors(mapper);
  mapper->SetBlendModeToAdditive();
  mapper->SetBlendMode(6);
  CHECK(errors.Said("BlendMode must be one of"));
  mapper->SetBlendMode(-1);
  CHECK(errors.Said("BlendMode must be one of"));
  CHECK_EQUAL(mapper->GetBlendMode(), vtkGPUUnstructuredGridVolumeMapper::ADDITIVE_BLEND);
  for (int i = 0; i < 33; ++i)
  {
    mapper->AddClippingPlane(MakePlane({ { 0.01 * i, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }));
  }
  scene.Draw();
  CHECK(errors.Said("33 clipping planes; the first 32 are used"));
  scene.Draw();
  CHECK(errors.None()); // reported once
}
}

int TestGPUUnstructuredGridVolumeMapperBlending(int, char*[])
{
  RelevoCheck check;
  RelevoVolumeScene::ForBothMethods(
    [&]
    {
      TestModes(check);
      TestLinearField(check);
      TestIsoSurfaces(check);
      TestSurfacesInFaces(check);
      TestCellScalars(check);
      TestClipping(check);
      TestClippedPlaces(check);
      TestPeeling(check);
      TestBadSettings(check);
    });
  return check.GetResult();
}
