// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeographicVectors promises which vectors it uses, those of the mesh or of an image, and how it
// treats missing ones.
#include "RelevoCheck.h"
#include "RelevoGeographicMesh.h"

#include "vtkGeographicVectors.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

// An image of 4 x 3 points with vectors (column, 10 row) at texel centres.
vtkSmartPointer<vtkImageData> MakeRaster()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(5, 8, -1, 1, 2, 2);
  image->SetOrigin(100.0, 200.0, 300.0);
  std::vector<std::vector<double>> tuples;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      tuples.push_back({ static_cast<double>(column), 10.0 * row });
    }
  }
  image->GetPointData()->AddArray(RelevoMakeArray("Raster", tuples));
  return image;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<std::vector<double>>& coordinates)
{
  const auto mesh =
    RelevoMakePoints(std::vector<std::array<double, 2>>(coordinates.size(), { 0.0, 0.0 }));
  mesh->GetPointData()->SetTCoords(RelevoMakeArray("TextureCoordinates", coordinates));
  return mesh;
}

void TestBilinear(RelevoCheck& check)
{
  const std::vector<std::vector<double>> coordinates = { { 0.125, 1.0 / 6.0 }, { 0.875, 5.0 / 6.0 },
    { 0.25, 0.5 }, { 0.5, 1.0 / 3.0 }, { 0.0, 0.0 }, { 1.0, 1.0 }, { -3.0, 0.5 }, { NaN, 0.5 } };
  const double expected[][2] = { { 0.0, 0.0 }, { 3.0, 20.0 }, { 0.5, 10.0 }, { 1.5, 5.0 },
    { 0.0, 0.0 }, { 3.0, 20.0 }, { 0.0, 10.0 } };
  vtkNew<vtkGeographicVectors> filter;
  filter->SetInputData(MakeMesh(coordinates));
  filter->SetRasterData(MakeRaster());
  filter->Update();
  for (vtkIdType i = 0; i < 7; ++i)
  {
    const auto vector = RelevoVectorOf(filter->GetOutput(), i, "Raster");
    CHECK_NEAR(vector[0], expected[i][0], 1e-5);
    CHECK_NEAR(vector[1], expected[i][1], 1e-5);
    CHECK_EQUAL(vector[2], 0.0);
  }
  CHECK(std::isnan(RelevoVectorOf(filter->GetOutput(), 7, "Raster")[0]));
  CHECK_NOT_EQUAL(filter->GetOutput()->GetPointData()->GetTCoords(), nullptr);
}

// A missing sample affects only points that interpolate it.
void TestNoDataInRaster(RelevoCheck& check)
{
  const std::vector<std::vector<double>> coordinates = { { 0.375, 0.5 }, { 0.3, 0.5 },
    { 0.45, 0.6 }, { 0.125, 0.5 }, { 0.6251, 0.5 }, { 0.375, 0.1 } };
  vtkNew<vtkGeographicVectors> filter;
  filter->SetInputData(MakeMesh(coordinates));
  for (const double bad : { NaN, Infinity, -1e9, 1e8, 1e20 })
  {
    const auto raster = MakeRaster();
    raster->GetPointData()->GetArray("Raster")->SetComponent(5, 1, bad); // column 1, row 1
    filter->SetRasterData(raster);
    filter->Update();
    for (vtkIdType i = 0; i < 6; ++i)
    {
      const auto vector = RelevoVectorOf(filter->GetOutput(), i, "Raster");
      const bool isData = i >= 3;
      CHECK_EQUAL(std::isnan(vector[0]), !isData);
      CHECK(std::isnan(vector[1]) == !isData && std::isnan(vector[2]) == !isData);
    }
  }
  const auto raster = MakeRaster();
  raster->AllocatePointGhostArray()->SetValue(5, vtkDataSetAttributes::HIDDENPOINT);
  filter->SetRasterData(raster);
  filter->Update();
  CHECK(std::isnan(RelevoVectorOf(filter->GetOutput(), 0, "Raster")[0]));
  CHECK(!std::isnan(RelevoVectorOf(filter->GetOutput(), 3, "Raster")[0]));
  // This value is large, but valid.
  raster->GetPointData()->GetArray("Raster")->SetComponent(0, 0, -9.9e7);
  raster->GetPointData()->GetArray("Raster")->Modified();
  raster->Modified();
  filter->SetInputData(MakeMesh({ { 0.1, 0.1 } }));
  filter->Update();
  CHECK_NEAR(RelevoVectorOf(filter->GetOutput(), 0, "Raster")[0], -9.9e7, 10.0);
}

void TestMeshArrays(RelevoCheck& check)
{
  const auto mesh = MakeMesh(std::vector<std::vector<double>>(4, { 0.5, 0.5 }));
  mesh->GetPointData()->SetNormals(
    RelevoMakeArray("Normals", std::vector<std::vector<double>>(4, { 0.0, 0.0, 1.0 })));
  mesh->GetPointData()->AddArray(RelevoMakeArray("Speed", { { 1.0 }, { 2.0 }, { 3.0 }, { 4.0 } }));
  mesh->GetPointData()->AddArray(
    RelevoMakeArray("Wind", { { 1.0, 2.0 }, { NaN, 0.0 }, { 0.0, -1e9 }, { 0.0, 0.0 } }));
  mesh->GetPointData()->AddArray(RelevoMakeArray(
    "Drift", { { 1.0, 2.0, 3.0 }, { 1.0, 1.0, 1e20 }, { 4.0, 5.0, 6.0 }, { 0.0, 0.0, -2.0 } }));

  // The first suitable array is used.
  vtkNew<vtkGeographicVectors> filter;
  filter->SetInputData(mesh);
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  CHECK(data->GetVectors() && std::string(data->GetVectors()->GetName()) == "Wind");
  CHECK_EQUAL(data->GetNumberOfArrays(), mesh->GetPointData()->GetNumberOfArrays());
  CHECK_EQUAL(data->GetArray("Drift"), mesh->GetPointData()->GetArray("Drift"));
  const auto wind = [&](vtkIdType i) { return RelevoVectorOf(filter->GetOutput(), i, "Wind"); };
  CHECK((wind(0) == std::array<double, 3>{ 1.0, 2.0, 0.0 }));
  CHECK(std::isnan(wind(1)[0]) && std::isnan(wind(1)[1]) && std::isnan(wind(1)[2]));
  CHECK(std::isnan(wind(2)[0]) && std::isnan(wind(2)[1]));
  CHECK((wind(3) == std::array<double, 3>{ 0.0, 0.0, 0.0 }));
  CHECK_EQUAL(
    mesh->GetPointData()->GetArray("Wind")->GetNumberOfComponents(), 2); // the input's array

  // The active vectors have precedence.
  mesh->GetPointData()->SetActiveVectors("Drift");
  filter->SetExaggeration(-2.0);
  filter->Update();
  const auto drift = [&](vtkIdType i) { return RelevoVectorOf(filter->GetOutput(), i, "Drift"); };
  CHECK((drift(0) == std::array<double, 3>{ 1.0, 2.0, -6.0 }));
  CHECK(std::isnan(drift(1)[0]));
  CHECK((drift(3) == std::array<double, 3>{ 0.0, 0.0, 4.0 }));

  // A selected array has precedence, in an image or, despite an image, in the mesh.
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Wind");
  filter->SetRasterData(MakeRaster());
  filter->Update();
  CHECK((wind(0) == std::array<double, 3>{ 1.0, 2.0, 0.0 }));
  CHECK(!filter->GetOutput()->GetPointData()->HasArray("Raster"));
  filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Raster");
  filter->SetOutputArrayName("Drift"); // replaces the array
  filter->Update();
  CHECK_NEAR(drift(0)[0], 1.5, 1e-6);
  CHECK_NEAR(drift(0)[1], 10.0, 1e-6);

  // Uses connections. An array without a name gets a name.
  vtkNew<vtkGeographicVectors> connected;
  vtkNew<vtkTrivialProducer> image;
  const auto raster = MakeRaster();
  raster->GetPointData()->GetArray(0)->SetName(nullptr);
  image->SetOutput(raster);
  connected->SetInputData(mesh);
  connected->SetRasterConnection(image->GetOutputPort());
  connected->Update();
  CHECK_NEAR(RelevoVectorOf(connected->GetOutput(), 0, "Vectors")[0], 1.5, 1e-6);
}
}

int TestGeographicVectorsRaster(int, char*[])
{
  RelevoCheck check;
  TestBilinear(check);
  TestNoDataInRaster(check);
  TestMeshArrays(check);
  return check.GetResult();
}
