// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceLineIntegralConvolution promises a texture that shows the same LIC as its points.
#include "RelevoCheck.h"
#include "RelevoSurfaceLIC.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <iostream>

namespace
{
using namespace RelevoVectors;

Vector Swirl(const Vector& p)
{
  return { { -p[1], p[0] + std::sin(5 * p[2]), 0.4 + std::cos(4 * p[0]) } };
}

vtkImageData* GetTexture(vtkSurfaceLineIntegralConvolution* filter)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(1));
}

// Returns a value in [0, 255].
double GetTexel(vtkImageData* texture, int i, int j)
{
  return texture->GetScalarComponentAsDouble(i, j, 0, 0);
}

// On this plane, points lie at the centres of texels.
void CheckPoints(RelevoCheck& check)
{
  const int n = 33;
  auto plane = RelevoMeshes::Plane(n - 1, n - 1);
  AddVelocity(plane, Swirl);
  RelevoMeshes::AddTextureCoordinates(plane,
    [=](const double* p)
    {
      return std::array<double, 2>{ { ((p[0] + 0.5) * (n - 1) + 0.5) / n,
        ((p[1] + 0.5) * (n - 1) + 0.5) / n } };
    });
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetTextureSize(n, n);
  for (int contrast : { 0, 1 })
  {
    filter->SetEnhanceContrast(contrast);
    const RelevoSurfaceLIC lic(filter, plane);
    vtkImageData* texture = GetTexture(filter);
    CHECK(texture->GetDimensions()[0] == n && texture->GetDimensions()[1] == n &&
      texture->GetDimensions()[2] == 1);
    CHECK_EQUAL(texture->GetScalarType(), VTK_UNSIGNED_CHAR);
    CHECK_EQUAL(texture->GetNumberOfScalarComponents(), 1);
    int differ = 0;
    for (int point = 0; point < n * n; ++point)
    {
      const double texel = GetTexel(texture, point % n, point / n);
      differ += std::abs(texel - 255.0 * lic.Values[point]) > 0.6;
    }
    // Next to the swirl's centre, the result depends on rounding.
    CHECK_LESS_EQUAL(differ, 1);
  }
}

// The texture of a coarse mesh equals the point values of a fine one, also across the seam.
void CheckFineness(RelevoCheck& check)
{
  const auto make = [](int n)
  {
    auto sphere = RelevoMeshes::TexturedSphere(2 * n, n);
    AddVelocity(sphere, [](const Vector& p) { return cross({ { 0.3, 0.5, 0.8 } }, normalize(p)); });
    return sphere;
  };
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetGrainSize(0.06);
  auto fine = make(64);
  const RelevoSurfaceLIC lic(filter, fine);
  filter->SetTextureSize(384, 192);
  filter->SetInputData(make(24));
  filter->Update();
  vtkImageData* texture = GetTexture(filter);
  vtkDataArray* coordinates = fine->GetPointData()->GetTCoords();
  double squares = 0.0;
  double variance = 0.0;
  int count = 0;
  for (vtkIdType point = 0; point < fine->GetNumberOfPoints(); ++point)
  {
    const double* uv = coordinates->GetTuple(point);
    if (uv[1] < 0.1 || uv[1] > 0.9)
    {
      continue; // texels about the poles are narrow
    }
    const int i = std::min(static_cast<int>(384 * uv[0]), 383);
    const int j = std::min(static_cast<int>(192 * uv[1]), 191);
    const double texel = GetTexel(texture, i, j) / 255.0;
    squares += std::pow(texel - lic.Values[point], 2.0);
    variance += std::pow(lic.Values[point] - 0.5, 2.0);
    ++count;
  }
  std::cout << "texture of 1104 triangles, points of " << fine->GetNumberOfCells() << ": differ by "
            << std::sqrt(squares / count) << ", deviate by " << std::sqrt(variance / count) << "\n";
  CHECK_LESS(squares, 0.15 * variance);
  // The first and last columns lie on the two sides of the seam.
  double across = 0.0;
  double along = 0.0;
  for (int j = 20; j < 172; ++j)
  {
    across += std::abs(GetTexel(texture, 0, j) - GetTexel(texture, 383, j));
    along += std::abs(GetTexel(texture, 0, j) - GetTexel(texture, 1, j));
  }
  CHECK_LESS(across, 1.5 * along + 152.0);
}

// Texels that no triangle covers take a neighbour's value.
void CheckBorder(RelevoCheck& check)
{
  auto plane = RelevoMeshes::Plane(20, 20);
  AddVelocity(plane, Swirl);
  // The triangles cover half of the texture's width and height, in its middle.
  RelevoMeshes::AddTextureCoordinates(plane,
    [](const double* p) {
      return std::array<double, 2>{ { 0.5 + 0.5 * p[0], 0.5 + 0.5 * p[1] } };
    });
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetTextureSize(64, 64);
  filter->SetInputData(plane);
  filter->Update();
  vtkImageData* texture = GetTexture(filter);
  const auto inside = [](int i) { return std::min(std::max(i, 16), 47); };
  double spread = 0.0;
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      CHECK_EQUAL(GetTexel(texture, i, j), GetTexel(texture, inside(i), inside(j)));
      spread = std::max(spread, std::abs(GetTexel(texture, i, j) - 127.5));
    }
  }
  CHECK_GREATER(spread, 20);
}

void CheckErrors(RelevoCheck& check)
{
  auto plane = RelevoMeshes::Plane(20, 20);
  AddVelocity(plane, Swirl);
  plane->GetPointData()->SetTCoords(nullptr);
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetTextureSize(64, 64);
  filter->SetInputData(plane);
  RelevoErrors errors(filter);
  RelevoErrors ofExecutive(filter->GetExecutive());
  filter->Update();
  CHECK(errors.Said("texture coordinates"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(GetTexture(filter)->GetNumberOfPoints(), 0);
  for (double far : { 1.5, -3.0, 1e300, static_cast<double>(HUGE_VAL), std::nan("") })
  {
    CHECK_CASE(far);
    RelevoMeshes::AddTextureCoordinates(plane,
      [=](const double* p) {
        return std::array<double, 2>{ { far + 0.1 * p[0], 0.5 } };
      });
    filter->Update();
    CHECK(errors.Said("No texel"));
  }
  // With random, overlapping coordinates each texel still has some triangle's value.
  RelevoMeshes::AddRandomTextureCoordinates(plane, 3);
  filter->Update();
  CHECK(errors.None());
  CHECK_EQUAL(GetTexture(filter)->GetNumberOfPoints(), 64 * 64);
  filter->SetTextureSize(0, 0);
  filter->Update();
  CHECK(errors.None());
  CHECK_EQUAL(GetTexture(filter)->GetNumberOfPoints(), 0);
}
}

int TestSurfaceLineIntegralConvolutionTexture(int, char*[])
{
  RelevoCheck check;
  CheckPoints(check);
  CheckFineness(check);
  CheckBorder(check);
  CheckErrors(check);
  return check.GetResult();
}
