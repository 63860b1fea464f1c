// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves flow.md on missing data: vtkSurfaceLineIntegralConvolution masks zero and missing vectors,
// works on degenerate meshes, and reports errors.
#include "RelevoCheck.h"
#include "RelevoSurfaceLIC.h"

#include "Noise/SolidNoise.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <random>

namespace
{
using namespace RelevoVectors;

using Filter = vtkSurfaceLineIntegralConvolution;

constexpr double Grain = 0.05;

vtkSmartPointer<vtkSurfaceLineIntegralConvolution> MakeFilter()
{
  auto filter = vtkSmartPointer<vtkSurfaceLineIntegralConvolution>::New();
  filter->SetGrainSize(Grain);
  return filter;
}

// A plane whose central disk has `something` in place of the field's values.
RelevoMeshes::Mesh PlaneWith(double something)
{
  auto plane = RelevoMeshes::Plane(40, 40);
  AddVelocity(plane,
    [=](const Vector& p) {
      return length(p) < 0.2 ? Vector{ { something, 0.5, 0 } } : Vector{ { 1.0, 0.3 + p[0], 0 } };
    });
  return plane;
}

// Masked points keep the noise, and the values stored there affect no other point.
void CheckNoData(RelevoCheck& check)
{
  const auto filter = MakeFilter();
  const relevo::SolidNoise noise(Grain, 1);
  auto plane = PlaneWith(std::numeric_limits<double>::quiet_NaN());
  const RelevoSurfaceLIC lic(filter, plane);
  CHECK(lic.IsValid());
  double others = 0.0;
  for (vtkIdType point = 0; point < plane->GetNumberOfPoints(); ++point)
  {
    Vector p;
    plane->GetPoint(point, p.data());
    if (length(p) < 0.2)
    {
      CHECK_EQUAL(lic.Mask[point], 1);
      CHECK_EQUAL(lic.Values[point], noise.GetValue(p.data()));
    }
    else if (length(p) > 0.24)
    {
      CHECK_EQUAL(lic.Mask[point], 0);
      others = std::max<double>(others, std::abs(lic.Values[point] - noise.GetValue(p.data())));
    }
  }
  CHECK_GREATER(others, 0.1);
  for (double sentinel : { -1e9, 1e20, 1e8, -std::numeric_limits<double>::infinity() })
  {
    CHECK_CASE(sentinel);
    const RelevoSurfaceLIC same(filter, PlaneWith(sentinel));
    CHECK_EQUAL(same.Values, lic.Values);
    CHECK_EQUAL(same.Mask, lic.Mask);
  }
  CHECK_NOT_EQUAL(RelevoSurfaceLIC(filter, PlaneWith(9e7)).Mask, lic.Mask);
  filter->SetNoDataMagnitude(1e3);
  const RelevoSurfaceLIC same(filter, PlaneWith(2e3));
  CHECK_EQUAL(same.Values, lic.Values);
  CHECK_EQUAL(same.Mask, lic.Mask);
  // A line along y ends at the disk, so vectors inside the disk and beyond it have no effect.
  auto below = PlaneWith(1e4);
  auto changed = PlaneWith(1e4);
  for (vtkPolyData* mesh : { below.Get(), changed.Get() })
  {
    vtkDataArray* vectors = mesh->GetPointData()->GetVectors();
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      const double* p = mesh->GetPoint(point);
      if (p[0] * p[0] + p[1] * p[1] >= 0.04)
      {
        const bool bends = p[1] > 0 && mesh == changed;
        vectors->SetTuple3(point, bends ? 1 : 0, bends ? 0 : 1, 0); // all have the same length
      }
    }
  }
  const RelevoSurfaceLIC up(filter, below);
  const RelevoSurfaceLIC bent(filter, changed);
  CHECK_NOT_EQUAL(up.Values, bent.Values);
  int shadowed = 0;
  for (vtkIdType point = 0; point < below->GetNumberOfPoints(); ++point)
  {
    const double* p = below->GetPoint(point);
    if (std::abs(p[0]) < 0.1 && p[1] < 0.0)
    {
      ++shadowed;
      CHECK_EQUAL(up.Values[point], bent.Values[point]);
    }
  }
  CHECK_GREATER(shadowed, 50);
}

void CheckThreshold(RelevoCheck& check)
{
  const auto filter = MakeFilter();
  auto plane = RelevoMeshes::Plane(40, 40);
  AddVelocity(plane, [](const Vector& p) { return Vector{ { std::max(p[0], 0.0), 0, 0 } }; });
  const auto countMasked = [&](double threshold)
  {
    filter->SetMaskThreshold(threshold);
    const RelevoSurfaceLIC lic(filter, plane);
    CHECK(lic.IsValid());
    int masked = 0;
    for (vtkIdType point = 0; point < plane->GetNumberOfPoints(); ++point)
    {
      CHECK_EQUAL(lic.Mask[point], (std::max(plane->GetPoint(point)[0], 0.0) <= threshold));
      masked += lic.Mask[point];
    }
    return masked;
  };
  CHECK_EQUAL(countMasked(0.0), 21 * 41);
  CHECK_EQUAL(countMasked(0.26), 31 * 41);
  CHECK_EQUAL(countMasked(-1.0), 0);
  // Lines pass through points that are masked by the length of their vectors.
  filter->SetMaskThreshold(0.26);
  const RelevoSurfaceLIC masked(filter, plane);
  filter->SetMaskThreshold(0.0);
  const RelevoSurfaceLIC all(filter, plane);
  for (std::size_t i = 0; i < all.Values.size(); ++i)
  {
    CHECK(masked.Mask[i] || masked.Values[i] == all.Values[i]);
  }
  // With cell data, a point is masked if all its cells are.
  auto ofCells = RelevoMeshes::Plane(10, 10);
  vtkNew<vtkIntArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(100);
  vectors->Fill(0);
  vectors->SetTuple3(0, 1, 1, 0);
  vectors->SetTuple3(99, 1000000000, 1, 0);
  ofCells->GetCellData()->AddArray(vectors);
  const RelevoSurfaceLIC lic(filter, ofCells);
  CHECK(lic.IsValid());
  for (std::size_t i = 0; i < lic.Mask.size(); ++i)
  {
    CHECK_EQUAL(lic.Mask[i], !(i == 0 || i == 1 || i == 11 || i == 12));
  }
}

void CheckOddMeshes(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<RelevoMeshes::Mesh> meshes{ RelevoMeshes::Mixed(), RelevoMeshes::NonManifold(),
    RelevoMeshes::Moebius(), RelevoMeshes::Slivers(), RelevoMeshes::Strips(), RelevoMeshes::Cube(),
    RelevoMeshes::TexturedSphere(9, 7) };
  meshes.push_back(RelevoMeshes::FromTriangles(
    { { { nan, 0, 0 } }, { { 1, infinity, 0 } }, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } },
      { { 0, 0, 0 } }, { { 1e30, 1e30, 0 } }, { { 0, 1, 0 } } },
    { { { 0, 1, 2 } }, { { 2, 3, 4 } }, { { 2, 5, 3 } }, { { 2, 3, 6 } }, { { 2, 3, 99 } },
      { { 2, 3, 7 } }, { { 3, 2, 7 } } }));
  std::mt19937 random(4);
  const auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  for (vtkPolyData* mesh : meshes)
  {
    for (int round = 0; round < 3; ++round)
    {
      AddVelocity(mesh,
        [&](const Vector&)
        {
          return random() % 8 ? Vector{ { number(), number(), number() } }
                              : Vector{ { round ? 0.0 : nan, 0, 0 } };
        });
      vtkNew<vtkSurfaceLineIntegralConvolution> filter;
      filter->SetNormalizeVectors(round < 2);
      filter->SetEnhanceContrast(round % 2);
      const RelevoSurfaceLIC lic(filter, mesh);
      CHECK(lic.IsValid());
      filter->SetStepSize(1e6);
      CHECK(RelevoSurfaceLIC(filter, mesh).IsValid());
      filter->SetStepSize(1e-9);
      CHECK(RelevoSurfaceLIC(filter, mesh).IsValid());
    }
  }
}

// Whether the output is empty and an error contains `words`.
bool Fails(Filter* filter, vtkPolyData* mesh, const char* words)
{
  RelevoErrors errors(filter);
  RelevoErrors ofExecutive(filter->GetExecutive());
  const RelevoSurfaceLIC lic(filter, mesh);
  return errors.Said(words) && lic.Values.empty() && filter->GetOutput()->GetNumberOfPoints() == 0;
}

// Whether a setting gives an error at once and changes nothing.
bool Rejects(const std::function<void(Filter*)>& set, const char* words)
{
  const auto plane = PlaneWith(1.0);
  const auto filter = MakeFilter();
  const RelevoSurfaceLIC before(filter, plane);
  const vtkMTimeType time = filter->GetMTime();
  RelevoErrors errors(filter);
  set(filter);
  const bool said = errors.Said(words) && filter->GetMTime() == time;
  filter->Modified();
  const RelevoSurfaceLIC after(filter, plane);
  return said && errors.None() && after.IsValid() && after.Values == before.Values;
}

void CheckSettings(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int steps : { 0, -1, 100001 })
  {
    CHECK_CASE(steps);
    CHECK(Rejects([=](Filter* f) { f->SetNumberOfSteps(steps); }, "NumberOfSteps"));
  }
  for (double bad : { -0.1, nan, static_cast<double>(HUGE_VAL) })
  {
    CHECK_CASE(bad);
    CHECK(Rejects([=](Filter* f) { f->SetStepSize(bad); }, "StepSize"));
    CHECK(Rejects([=](Filter* f) { f->SetGrainSize(bad); }, "GrainSize"));
  }
  CHECK(Rejects([=](Filter* f) { f->SetPhase(nan); }, "Phase"));
  CHECK(Rejects([=](Filter* f) { f->SetMaskThreshold(nan); }, "MaskThreshold"));
  CHECK(Rejects([=](Filter* f) { f->SetNoDataMagnitude(0.0); }, "NoDataMagnitude"));
  CHECK(Rejects([=](Filter* f) { f->SetNoDataMagnitude(nan); }, "NoDataMagnitude"));
  CHECK(Rejects([=](Filter* f) { f->SetEnhanceContrast(2); }, "EnhanceContrast"));
  CHECK(Rejects([=](Filter* f) { f->SetLowLICContrastEnhancementFactor(-1.1); }, "Low"));
  CHECK(Rejects([=](Filter* f) { f->SetHighLICContrastEnhancementFactor(1.1); }, "High"));
  CHECK(Rejects([=](Filter* f) { f->SetTextureSize(0, 5); }, "TextureSize"));
  CHECK(Rejects([=](Filter* f) { f->SetTextureSize(5, 20000); }, "TextureSize"));
}

void CheckRange(RelevoCheck& check, Filter* filter, vtkPolyData* plane)
{
  filter->SetHighLICContrastEnhancementFactor(1.0); // no range would remain
  CHECK(Fails(filter, plane, "High"));
  filter->SetHighLICContrastEnhancementFactor(0.0);
}

void CheckInputs(RelevoCheck& check, Filter* filter, vtkPolyData* plane)
{
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, vtkNew<vtkUnstructuredGrid>());
    const auto ofBlocks = MakeFilter();
    RelevoErrors errors(ofBlocks);
    RelevoErrors ofExecutive(ofBlocks->GetExecutive());
    ofBlocks->SetInputDataObject(blocks);
    ofBlocks->Update();
    CHECK(errors.Said("The input is a vtkUnstructuredGrid; a vtkPolyData is needed."));
  }
  CHECK(Fails(filter, RelevoMeshes::Plane(3, 3), "no array of 3 components"));
  CHECK(Fails(filter, RelevoMeshes::Make(), "no array of 3 components"));
  auto lines = RelevoMeshes::Make();
  lines->SetPoints(plane->GetPoints());
  lines->GetPointData()->ShallowCopy(plane->GetPointData());
  CHECK(Fails(filter, lines, "no polygons"));
  lines->SetLines(vtkSmartPointer<vtkCellArray>::New());
  lines->GetLines()->InsertNextCell({ 0, 1 });
  CHECK(Fails(filter, lines, "no polygons"));
}

void CheckNamedArrays(RelevoCheck& check, Filter* filter, vtkPolyData* plane)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "no such array");
  CHECK(Fails(filter, plane, "\"no such array\""));
  vtkNew<vtkFloatArray> pairs;
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(plane->GetNumberOfPoints());
  plane->GetPointData()->AddArray(pairs);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "pairs");
  CHECK(Fails(filter, plane, "tuples of 2"));
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(plane->GetNumberOfPoints());
  plane->GetPointData()->AddArray(words);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "words");
  CHECK(Fails(filter, plane, "\"words\""));
  vtkNew<vtkFloatArray> few;
  few->SetName("few");
  few->SetNumberOfComponents(3);
  few->SetNumberOfTuples(7);
  plane->GetPointData()->AddArray(few);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "few");
  CHECK(Fails(filter, plane, "7 tuples of 3"));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Velocity");
  CHECK(Fails(filter, plane,
    "has no cell array \"Velocity\", but a point array of that name. Use "
    "SetInputArrayToProcess(0, 0, 0, "
    "vtkDataObject::FIELD_ASSOCIATION_POINTS, \"Velocity\")."));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  CHECK(RelevoSurfaceLIC(filter, plane).IsValid());
}

// Without a name, the filter takes the first suitable array that does not contain normals.
void CheckFirstArray(RelevoCheck& check)
{
  auto plane = PlaneWith(1.0);
  plane->GetPointData()->SetActiveVectors(nullptr);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(plane->GetNumberOfPoints());
  normals->Fill(1.0);
  auto withNormals = RelevoMeshes::Plane(40, 40);
  withNormals->GetPointData()->Initialize();
  withNormals->GetPointData()->SetNormals(normals);
  CHECK(Fails(MakeFilter(), withNormals, "no array of 3 components"));
  withNormals->GetPointData()->AddArray(plane->GetPointData()->GetArray("Velocity"));
  CHECK_EQUAL(RelevoSurfaceLIC(MakeFilter(), withNormals).Values,
    RelevoSurfaceLIC(MakeFilter(), PlaneWith(1.0)).Values);
}

void CheckErrors(RelevoCheck& check)
{
  CheckSettings(check);
  const auto filter = MakeFilter();
  auto plane = PlaneWith(1.0);
  CheckRange(check, filter, plane);
  CheckInputs(check, filter, plane);
  CheckNamedArrays(check, filter, plane); // checks too that the filter works again
  CheckFirstArray(check);
}
}

int TestSurfaceLineIntegralConvolutionMasks(int, char*[])
{
  RelevoCheck check;
  CheckNoData(check);
  CheckThreshold(check);
  CheckOddMeshes(check);
  CheckErrors(check);
  return check.GetResult();
}
