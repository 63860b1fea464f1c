// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReliefScene.h"

#include "BenchmarkView.h"
#include "Data/Relief.h"

#include "vtkReliefCapture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;

// A point of the ring: u from 0 to 1 runs around it, v around its tube.
vtkVector3d GetPoint(double u, double v)
{
  const double a = 2.0 * Pi * u;
  const double b = 2.0 * Pi * v;
  const double tube = 0.45 + 0.02 * std::sin(24.0 * a) * std::sin(10.0 * b);
  const double radius = 1.0 + tube * std::cos(b);
  return { radius * std::cos(a), radius * std::sin(a), tube * std::sin(b) };
}

vtkVector3d GetNormal(double u, double v)
{
  constexpr double step = 1e-5;
  const vtkVector3d alongU = GetPoint(u + step, v) - GetPoint(u - step, v);
  const vtkVector3d alongV = GetPoint(u, v + step) - GetPoint(u, v - step);
  return alongU.Cross(alongV).Normalized();
}

unsigned char GetByte(double phase)
{
  return static_cast<unsigned char>(std::lround(160.0 + 90.0 * std::sin(phase)));
}
}

BenchmarkReliefScene::BenchmarkReliefScene(double triangles)
  : Mesh(vtkSmartPointer<vtkPolyData>::New())
{
  const int rings = std::max(3, static_cast<int>(std::ceil(std::sqrt(triangles / 6.0))));
  const int sectors = 3 * rings;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> faces;
  const auto id = [=](int sector, int ring) -> vtkIdType
  { return static_cast<vtkIdType>(sector % sectors) * rings + ring % rings; };
  for (int sector = 0; sector < sectors; ++sector)
  {
    for (int ring = 0; ring < rings; ++ring)
    {
      const double u = static_cast<double>(sector) / sectors;
      const double v = static_cast<double>(ring) / rings;
      points->InsertNextPoint(GetPoint(u, v).GetData());
      normals->InsertNextTuple(GetNormal(u, v).GetData());
      const unsigned char color[3] = { GetByte(2.0 * Pi * 12.0 * u), GetByte(2.0 * Pi * 5.0 * v),
        GetByte(2.0 * Pi * (7.0 * u + 3.0 * v)) };
      colors->InsertNextTypedTuple(color);
      const vtkIdType corners[] = { id(sector, ring), id(sector + 1, ring),
        id(sector + 1, ring + 1), id(sector, ring + 1) };
      faces->InsertNextCell({ corners[0], corners[1], corners[2] });
      faces->InsertNextCell({ corners[0], corners[2], corners[3] });
    }
  }
  this->Mesh->SetPoints(points);
  this->Mesh->SetPolys(faces);
  this->Mesh->GetPointData()->SetNormals(normals);
  this->Mesh->GetPointData()->SetScalars(colors);
}

BenchmarkReliefScene::~BenchmarkReliefScene() = default;

vtkSmartPointer<vtkPolyDataMapper> BenchmarkReliefScene::MakeMapper() const
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(this->Mesh);
  return mapper;
}

void BenchmarkReliefScene::SetUp(BenchmarkView& view) const
{
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(2.0, -3.0, 5.0);
  view.GetRenderer()->RemoveAllLights(); // the headlight
  view.GetRenderer()->AddLight(lamp);
  view.LookAt(this->Mesh->GetBounds());
}

vtkSmartPointer<vtkMultiBlockDataSet> BenchmarkReliefScene::Capture(
  BenchmarkView& view, int size) const
{
  const auto actor = view.AddActor(this->MakeMapper());
  vtkNew<vtkReliefCapture> capture;
  capture->SetRenderer(view.GetRenderer());
  capture->SetResolution(size, size);
  for (const double angle : { 0.0, 20.0, 40.0, -20.0 })
  {
    vtkNew<vtkCamera> camera;
    camera->DeepCopy(view.GetRenderer()->GetActiveCamera());
    camera->Azimuth(angle);
    // The view is wider than high, but a relief is square: texels are about as large as pixels.
    camera->UseHorizontalViewAngleOn();
    camera->SetViewAngle(30.0);
    capture->AddCamera(camera);
  }
  capture->Update();
  view.GetRenderer()->RemoveActor(actor);
  return capture->GetOutput();
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeWavyReliefs(int size)
{
  auto result = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < 4; ++i)
  {
    vtkNew<vtkImageData> relief;
    relief->SetDimensions(size, size, 1);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(relevo::Relief::GetColorName());
    colors->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> depths;
    depths->SetName(relevo::Relief::GetDepthName());
    for (int texel = 0; texel < size * size; ++texel)
    {
      const double x = 2.0 * Pi * (texel % size) / size;
      const double y = 2.0 * Pi * (texel / size) / size;
      depths->InsertNextValue(static_cast<float>(std::sin(9.0 * x) * std::cos(7.0 * y)));
      const unsigned char color[3] = { GetByte(5.0 * x), GetByte(3.0 * y), GetByte(x + y) };
      colors->InsertNextTypedTuple(color);
    }
    relief->GetPointData()->AddArray(colors);
    relief->GetPointData()->AddArray(depths);
    // Four tiles of a square from -1 to 1.
    relevo::dmat4 matrix(1.0);
    matrix[0][0] = matrix[1][1] = 1.0 / (size - 1);
    matrix[2][2] = -0.02;
    matrix[3] = relevo::dvec4(i % 2 - 1.0, i / 2 - 1.0, 0.0, 1.0);
    relevo::Relief::Describe(relief, relevo::ReliefProjection::Parallel, matrix);
    result->SetBlock(i, relief);
  }
  return result;
}

std::vector<vtkSmartPointer<vtkImageData>> GetReliefs(vtkMultiBlockDataSet* reliefs)
{
  std::vector<vtkSmartPointer<vtkImageData>> result;
  for (unsigned int i = 0; i < reliefs->GetNumberOfBlocks(); ++i)
  {
    if (auto* relief = vtkImageData::SafeDownCast(reliefs->GetBlock(i)))
    {
      result.emplace_back(relief);
    }
  }
  return result;
}
