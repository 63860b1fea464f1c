// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceLineIntegralConvolution promises: each value is the mean of the noise along its
// streamline. References are lines that are known exactly.
#include "RelevoCheck.h"
#include "RelevoSurfaceLIC.h"

#include "Noise/SolidNoise.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace
{
using namespace RelevoVectors;

constexpr double Grain = 0.05;

// Noise is independent and uniform at lattice points, and interpolated between them.
void CheckNoise(RelevoCheck& check)
{
  const relevo::SolidNoise noise(0.5, 1);
  const relevo::SolidNoise other(0.5, 2);
  const int n = 40;
  std::vector<double> a;
  double product = 0.0;
  double neighbours = 0.0;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Vector x{ { 0.5 * (i % n - 20), 0.5 * (i / n % n), 0.5 * (i / n / n) - 1e6 } };
    const Vector next = x + Vector{ { 0.5, 0, 0 } };
    const Vector middle = x + Vector{ { 0.25, 0, 0 } };
    const double value = noise.GetValue(x.data());
    const double nextValue = noise.GetValue(next.data());
    CHECK_GREATER_EQUAL(value, 0.0);
    CHECK_LESS(value, 1.0);
    CHECK_NEAR(noise.GetValue(middle.data()), 0.5 * (value + nextValue), 1e-6);
    a.push_back(value);
    product += (value - 0.5) * (other.GetValue(x.data()) - 0.5);
    neighbours += (value - 0.5) * (nextValue - 0.5);
  }
  const double size = static_cast<double>(a.size());
  const double mean = std::accumulate(a.begin(), a.end(), 0.0) / size;
  double variance = 0.0;
  for (double value : a)
  {
    variance += (value - mean) * (value - mean) / size;
  }
  CHECK_NEAR(mean, 0.5, 0.01);
  CHECK_NEAR(variance, 1.0 / 12.0, 0.002);
  CHECK_NEAR(product / size, 0.0, 0.002);
  CHECK_NEAR(neighbours / size, 0.0, 0.002);
  for (double huge : { 1e9, -1e15, 1e300, -1e308 })
  {
    CHECK_CASE(huge);
    const double x[3] = { huge, 0.1, 0.0 };
    const float value = noise.GetValue(x);
    CHECK_GREATER_EQUAL(value, 0.0f);
    CHECK_LESS(value, 1.0f);
  }
}

// The square [-1/2, 1/2]^2 with a uniform field. `normal` tilts it away from the z axis.
struct UniformPlane
{
  UniformPlane()
  {
    this->Mesh = RelevoMeshes::Plane(40, 40);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPoints(); ++i)
    {
      Vector p;
      this->Mesh->GetPoint(i, p.data());
      points->InsertNextPoint((p[0] * this->Right + p[1] * this->Up).data());
    }
    this->Mesh->SetPoints(points);
    AddVelocity(this->Mesh, [this](const Vector&) { return this->Speed * this->Policy; });
  }

  // The weighted mean over the steps that stay on the plane.
  double GetExact(
    vtkIdType point, double step, int steps, const std::function<double(int)>& weight) const
  {
    const relevo::SolidNoise noise(Grain, 1);
    Vector start;
    this->Mesh->GetPoint(point, start.data());
    double sum = 0.0;
    double weights = 0.0;
    for (int k = -steps; k <= steps; ++k)
    {
      const Vector p = start + k * step * this->Policy;
      if (std::max(std::abs(dot(p, this->Right)), std::abs(dot(p, this->Up))) < 0.5 + 1e-7)
      {
        sum += weight(k) * noise.GetValue(p.data());
        weights += weight(k);
      }
    }
    return sum / weights;
  }

  const Vector Right = normalize({ { 0.6, 0.3, -0.5 } });
  const Vector Up = normalize(cross(Right, { { 0.1, 0.9, 0.2 } }));
  const Vector Policy = std::cos(0.3) * Right + std::sin(0.3) * Up;
  const double Speed = 2.5;
  RelevoMeshes::Mesh Mesh;
};

void CheckUniform(RelevoCheck& check)
{
  const UniformPlane plane;
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetGrainSize(Grain);
  const auto expect =
    [&](double step, int steps, const std::function<double(int)>& weight, vtkPolyData* mesh)
  {
    const RelevoSurfaceLIC lic(filter, mesh);
    CHECK(lic.IsValid() && lic.Values.size() == 41u * 41u);
    double spread = 0.0;
    for (vtkIdType point = 0; point < static_cast<vtkIdType>(lic.Values.size()); ++point)
    {
      const double exact = plane.GetExact(point, step, steps, weight);
      CHECK_NEAR(lic.Values[point], exact, 1e-4);
      CHECK_EQUAL(lic.Mask[point], 0);
      spread = std::max(spread, std::abs(exact - 0.5));
    }
    CHECK_GREATER(spread, 0.1);
  };
  const auto box = [](int) { return 1.0; };
  // The automatic step is one grain.
  expect(Grain, 20, box, plane.Mesh);
  filter->NormalizeVectorsOff();
  expect(Grain, 20, box, plane.Mesh);
  filter->SetStepSize(0.01);
  expect(0.01 * plane.Speed, 20, box, plane.Mesh);
  filter->NormalizeVectorsOn();
  filter->SetNumberOfSteps(7);
  expect(0.01, 7, box, plane.Mesh);
  filter->OrientedLICOn();
  expect(
    0.01, 7, [](int k) { return 0.5 - 0.5 * k / 8.0; }, plane.Mesh);
  filter->OrientedLICOff();
  // The same vectors as cell data give the same result.
  auto ofCells = RelevoMeshes::Make();
  ofCells->CopyStructure(plane.Mesh);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < ofCells->GetNumberOfCells(); ++cell)
  {
    vectors->InsertNextTuple(plane.Policy.data());
  }
  ofCells->GetCellData()->SetVectors(vectors);
  expect(0.01, 7, box, ofCells);
}

double Correlate(const std::vector<float>& a, const std::vector<float>& b, int columns, int shift)
{
  // Correlation of `a` at a column with `b` at the column `shift` to the right, away from the
  // border.
  const int n = 41;
  double sums[5] = { 0, 0, 0, 0, 0 };
  int count = 0;
  for (int j = 0; j < n; ++j)
  {
    for (int i = columns; i < n - columns; ++i, ++count)
    {
      const double x = a[j * n + i];
      const double y = b[j * n + i + shift];
      sums[0] += x;
      sums[1] += y;
      sums[2] += x * x;
      sums[3] += y * y;
      sums[4] += x * y;
    }
  }
  return (sums[4] - sums[0] * sums[1] / count) /
    std::sqrt((sums[2] - sums[0] * sums[0] / count) * (sums[3] - sums[1] * sums[1] / count));
}

// The pattern moves downstream and returns to its start after one period.
void CheckPhase(RelevoCheck& check)
{
  auto plane = RelevoMeshes::Plane(40, 40);
  AddVelocity(plane, [](const Vector&) { return Vector{ { 1, 0, 0 } }; });
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetGrainSize(Grain);
  filter->SetStepSize(0.5 / 40);
  filter->SetNumberOfSteps(20); // the period is 61 steps, with two steps per column
  const auto at = [&](double phase)
  {
    filter->SetPhase(phase);
    return RelevoSurfaceLIC(filter, plane).Values;
  };
  const auto still = at(0.0);
  CHECK_EQUAL(at(1.0), still);
  CHECK_EQUAL(at(-3.0), still);
  const auto moved = at(4.0 / 61.0);
  CHECK_NOT_EQUAL(moved, still);
  const double downstream = Correlate(still, moved, 12, 2);
  const double upstream = Correlate(still, moved, 12, -2);
  CHECK_GREATER(downstream, 0.9);
  CHECK_GREATER(downstream, upstream + 0.05);
  // The pattern never jumps, not even at the end of the period.
  auto before = at(0.0);
  for (int i = 1; i <= 61; ++i)
  {
    const auto after = at(i / 61.0);
    for (std::size_t point = 0; point < after.size(); ++point)
    {
      CHECK_NEAR(after[point], before[point], 0.1f);
    }
    before = after;
  }
}

RelevoMeshes::Mesh SwirlingTorus()
{
  auto torus = RelevoMeshes::Torus(40, 25);
  torus->SetVerts(nullptr); // the vertices of collapsed triangles
  torus->SetLines(nullptr);
  AddVelocity(torus,
    [](const Vector& p) {
      return Vector{ { -p[1], p[0] + std::sin(5 * p[2]), 0.4 + std::cos(4 * p[0]) } };
    });
  return torus;
}

void CheckSameResult(RelevoCheck& check)
{
  auto torus = SwirlingTorus();
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetGrainSize(0.1);
  vtkSMPTools::Initialize(1);
  const RelevoSurfaceLIC one(filter, torus);
  filter->Modified();
  const RelevoSurfaceLIC again(filter, torus);
  vtkSMPTools::Initialize(2);
  filter->Modified();
  const RelevoSurfaceLIC two(filter, torus);
  vtkSMPTools::Initialize();
  CHECK(one.IsValid());
  CHECK_EQUAL(one.Values, again.Values);
  CHECK_EQUAL(one.Values, two.Values);
  CHECK_EQUAL(one.Mask, again.Mask);
  CHECK_EQUAL(one.Mask, two.Mask);
  filter->SetNoiseGeneratorSeed(7);
  CHECK_NOT_EQUAL(RelevoSurfaceLIC(filter, torus).Values, one.Values);
  // A mesh of twice the size has the same pattern at twice the scale.
  filter->SetNoiseGeneratorSeed(1);
  filter->SetGrainSize(0.2);
  const double nowhere[3] = { 0, 0, 0 };
  auto twice = RelevoMeshes::Moved(torus, 2.0, nowhere, VTK_FLOAT);
  twice->GetPointData()->ShallowCopy(torus->GetPointData());
  const RelevoSurfaceLIC large(filter, twice);
  CHECK_EQUAL(large.Values, one.Values);
}

// Lines cross seams where points coincide but are not shared.
void CheckSeams(RelevoCheck& check)
{
  auto torus = SwirlingTorus();
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  filter->SetGrainSize(0.1);
  const RelevoSurfaceLIC whole(filter, torus);
  auto split = RelevoMeshes::Explode(torus);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  std::vector<float> expected;
  for (vtkIdType cell = 0; cell < torus->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> points;
    torus->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      vectors->InsertNextTuple(points->GetId(i), torus->GetPointData()->GetVectors());
      expected.push_back(whole.Values[points->GetId(i)]);
    }
  }
  split->GetPointData()->SetVectors(vectors);
  CHECK_EQUAL(RelevoSurfaceLIC(filter, split).Values, expected);

  // Two adjacent blocks join without a seam.
  const auto half = [](double left)
  {
    auto mesh = RelevoMeshes::Plane(20, 40);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      mesh->GetPoints()->SetPoint(i, 0.5 * p[0] + left, p[1], 0.0);
    }
    return mesh;
  };
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(half(-0.25));
  append->AddInputData(half(0.25));
  append->Update();
  auto blocks = RelevoMeshes::Make();
  blocks->ShallowCopy(append->GetOutput());
  auto plane = RelevoMeshes::Plane(40, 40);
  for (vtkPolyData* mesh : { plane.Get(), blocks.Get() })
  {
    AddVelocity(mesh, [](const Vector& p) { return Vector{ { 1, 2 * p[0], 0 } }; });
  }
  const RelevoSurfaceLIC joined(filter, blocks);
  const RelevoSurfaceLIC one(filter, plane);
  CHECK_EQUAL(joined.Values.size(), 2u * 21u * 41u);
  for (std::size_t i = 0; i < joined.Values.size(); ++i)
  {
    const std::size_t block = i / (21 * 41);
    const std::size_t row = i % (21 * 41) / 21;
    const std::size_t column = i % 21 + 20 * block;
    CHECK_NEAR(joined.Values[i], one.Values[row * 41 + column], 1e-4);
  }
}

void CheckContrast(RelevoCheck& check)
{
  auto torus = SwirlingTorus();
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  const auto plain = RelevoSurfaceLIC(filter, torus).Values;
  filter->SetEnhanceContrastToLIC();
  const auto stretched = RelevoSurfaceLIC(filter, torus).Values;
  const auto range = std::minmax_element(plain.begin(), plain.end());
  const float width = *range.second - *range.first;
  CHECK_GREATER(width, 0.1f);
  CHECK_LESS(width, 0.9f);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    CHECK_NEAR(stretched[i], (plain[i] - *range.first) / width, 1e-5);
  }
  filter->SetLowLICContrastEnhancementFactor(0.25);
  filter->SetHighLICContrastEnhancementFactor(0.25);
  const auto more = RelevoSurfaceLIC(filter, torus).Values;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    CHECK_NEAR(more[i], std::min(std::max(2.0f * stretched[i] - 0.5f, 0.0f), 1.0f), 1e-5);
  }
}

// The input is not modified, and its data pass to the output.
void CheckPassing(RelevoCheck& check)
{
  auto mixed = RelevoMeshes::Mixed();
  AddVelocity(mixed, [](const Vector&) { return Vector{ { 1, 0.3, 0 } }; });
  vtkNew<vtkSurfaceLineIntegralConvolution> filter;
  const RelevoSurfaceLIC lic(filter, mixed);
  vtkPolyData* output = filter->GetOutput();
  CHECK(lic.IsValid());
  CHECK_EQUAL(mixed->GetPointData()->GetNumberOfArrays(), 1);
  CHECK_EQUAL(output->GetPoints(), mixed->GetPoints());
  CHECK_EQUAL(output->GetPolys(), mixed->GetPolys());
  CHECK_EQUAL(output->GetNumberOfCells(), mixed->GetNumberOfCells());
  CHECK_EQUAL(output->GetPointData()->GetVectors(), mixed->GetPointData()->GetVectors());
  CHECK_EQUAL(output->GetPointData()->GetScalars(), output->GetPointData()->GetArray("LIC"));
  CHECK(vtkFloatArray::SafeDownCast(output->GetPointData()->GetScalars()));
  CHECK(vtkUnsignedCharArray::SafeDownCast(output->GetPointData()->GetArray("LICMask")));
  CHECK_EQUAL(vtkImageData::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
  // One of these points belongs to no cell, the other only to lines.
  CHECK(lic.Mask[23] == 1 && lic.Mask[22] == 1 && lic.Mask[0] == 0);
}
}

int TestSurfaceLineIntegralConvolution(int, char*[])
{
  RelevoCheck check;
  CheckNoise(check);
  CheckUniform(check);
  CheckPhase(check);
  CheckSameResult(check);
  CheckSeams(check);
  CheckContrast(check);
  CheckPassing(check);
  return check.GetResult();
}
