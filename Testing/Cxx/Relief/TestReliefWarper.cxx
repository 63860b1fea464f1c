// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefWarper promises the relief as seen from a camera. The references are rays cast at the
// bilinear surface in double precision: each texel shows the visible point, none is missing, and
// none is added.
#include "RelevoCheck.h"
#include "RelevoWarpReference.h"
#include "RelevoWarpScenes.h"
#include "vtkReliefWarper.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

namespace
{
using relevo::dvec2;
using relevo::dvec3;
using relevo::ReliefProjection;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int Width = 31;
constexpr int Height = 23;
constexpr ReliefProjection Projections[] = { ReliefProjection::Parallel,
  ReliefProjection::Perspective };

struct View
{
  bool IsParallel;
  double X;
  double Y;
};
// The eye is 60 from the plane.
const View Views[] = { { true, 0, 0 }, { false, 0, 0 }, { true, 12, 0 }, { true, 0, -15 },
  { true, 20, 20 }, { false, -9, 14 }, { false, 25, -20 }, { false, 2, 45 } };

std::string Describe(const RelevoWarpScene& scene, ReliefProjection projection, const View& view)
{
  return scene.Name + (projection == ReliefProjection::Parallel ? ", parallel" : ", perspective") +
    " relief, " + (view.IsParallel ? "parallel" : "perspective") + " camera at " +
    std::to_string(view.X) + " " + std::to_string(view.Y);
}

// Whether the reference hits this point within half a texel, or any point if `point` is NaN. At its
// border, the surface reaches to the nearest texel.
bool IsAround(const RelevoWarpReference& reference, int column, int row, const dvec2& point)
{
  for (double x : { -0.501, 0.0, 0.501 })
  {
    for (double y : { -0.501, 0.0, 0.501 })
    {
      const dvec3 seen = reference.Cast(column + x, row + y);
      if (seen.z == seen.z && !(distance(point, dvec2(seen)) > 0.75))
      {
        return true;
      }
    }
  }
  return false;
}

struct Result
{
  int Seen = 0;    // texels where the reference hits the surface
  int Missing = 0; // those of them without surface
  int Wrong = 0;   // those of them that show a point more than 0.25 texels away
  int Beside = 0;  // texels that are more than half a texel away from the surface
};

Result Compare(const RelevoWarpReference& reference, vtkImageData* output)
{
  Result result;
  const auto* depths =
    vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("Depth"))->GetPointer(0);
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      const float depth = depths[row * Width + column];
      const dvec3 seen = reference.Cast(column, row);
      const bool isSeen = seen.z == seen.z;
      const bool isThere = depth == depth;
      result.Seen += isSeen;
      result.Missing += isSeen && !isThere;
      if (isSeen && isThere)
      {
        const dvec2 point(reference.GetPoint(column, row, reference.GetRelief().ToHeight(depth)));
        result.Wrong +=
          distance(point, dvec2(seen)) > 0.25 && !IsAround(reference, column, row, point);
      }
      result.Beside += !isSeen && isThere && !IsAround(reference, column, row, dvec2(NaN));
    }
  }
  return result;
}

void TestAgainstReference(RelevoCheck& check)
{
  for (const RelevoWarpScene& scene : RelevoMakeWarpScenes(Width, Height))
  {
    if (scene.Name == "single texels") // no surface between texels
    {
      continue;
    }
    for (ReliefProjection projection : Projections)
    {
      const auto image = RelevoMakeWarpRelief(scene, Width, Height, projection);
      for (const View& view : Views)
      {
        const auto camera =
          RelevoMakeWarpCamera(Width, Height, projection, view.IsParallel, view.X, view.Y);
        vtkNew<vtkReliefWarper> warper;
        warper->SetInputData(image);
        warper->SetCamera(camera);
        warper->Update();
        const Result result = Compare(RelevoWarpReference(image, camera), warper->GetOutput());
        // At folds, a ray that grazes the surface may hit or miss it.
        const int few = scene.IsFolded ? result.Seen / 100 + 2 : 0;
        if (!CHECK(warper->CanWarp() && result.Seen > Width * Height / 8 && result.Missing <= few &&
              result.Wrong <= 4 * few && result.Beside <= few))
        {
          std::cerr << Describe(scene, projection, view) << ": of " << result.Seen << ", "
                    << result.Missing << " missing, " << result.Wrong << " wrong; " << result.Beside
                    << " beside\n";
        }
      }
    }
  }
}

// Each single texel appears where its line meets the plane, unless a nearer one covers it.
void TestSingleTexels(RelevoCheck& check)
{
  const RelevoWarpScene scene = RelevoMakeWarpScenes(Width, Height).back();
  for (ReliefProjection projection : Projections)
  {
    const auto image = RelevoMakeWarpRelief(scene, Width, Height, projection);
    for (const View& view : Views)
    {
      const auto camera =
        RelevoMakeWarpCamera(Width, Height, projection, view.IsParallel, view.X, view.Y);
      vtkNew<vtkReliefWarper> warper;
      warper->SetInputData(image);
      warper->SetCamera(camera);
      warper->Update();
      vtkPointData* output = warper->GetOutput()->GetPointData();
      const RelevoWarpReference reference(image, camera);
      int inside = 0;
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const double depth = image->GetPointData()->GetArray("Depth")->GetComponent(i, 0);
        const dvec2 place =
          reference.Project(static_cast<int>(i % Width), static_cast<int>(i / Width));
        const dvec2 texel(std::floor(place.x + 0.5), std::floor(place.y + 0.5));
        // Places without a depth are NaN.
        if (depth == depth && texel.x >= 0.0 && texel.x < Width && texel.y >= 0.0 &&
          texel.y < Height)
        {
          const int column = static_cast<int>(texel.x);
          const int row = static_cast<int>(texel.y);
          const vtkIdType there = row * Width + column;
          const double found = output->GetArray("Depth")->GetComponent(there, 0);
          CHECK(found == depth || found < depth);
          CHECK(found < depth ||
            output->GetArray("Color")->GetComponent(there, 0) ==
              image->GetPointData()->GetArray("Color")->GetComponent(i, 0));
          ++inside;
        }
      }
      int seen = 0;
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const double depth = output->GetArray("Depth")->GetComponent(i, 0);
        seen += depth == depth;
      }
      CHECK_GREATER(inside, 20);
      CHECK_LESS_EQUAL(seen, inside);
    }
  }
}

// Rows that are too far apart for a surface between them: texels appear, but nothing between them.
void TestRows(RelevoCheck& check)
{
  const RelevoWarpScene scene{ "rows", [](int, int row) { return row % 2 == 0 ? 0.0 : -40.0; },
    false };
  const auto image = RelevoMakeWarpRelief(scene, Width, Height, ReliefProjection::Parallel);
  for (const View& view : Views)
  {
    const auto camera = RelevoMakeWarpCamera(
      Width, Height, ReliefProjection::Parallel, view.IsParallel, view.X, view.Y);
    vtkNew<vtkReliefWarper> warper;
    warper->SetInputData(image);
    warper->SetCamera(camera);
    warper->Update();
    const RelevoWarpReference reference(image, camera);
    std::vector<bool> isNear(image->GetNumberOfPoints(), false); // within 0.501 of a texel
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const dvec2 place =
        reference.Project(static_cast<int>(i % Width), static_cast<int>(i / Width));
      for (double x : { -0.501, 0.501 })
      {
        for (double y : { -0.501, 0.501 })
        {
          const int column =
            static_cast<int>(x < 0.0 ? std::ceil(place.x + x) : std::floor(place.x + x));
          const int row =
            static_cast<int>(y < 0.0 ? std::ceil(place.y + y) : std::floor(place.y + y));
          if (column >= 0 && column < Width && row >= 0 && row < Height)
          {
            isNear[row * Width + column] = true;
          }
        }
      }
    }
    int seen = 0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double depth =
        warper->GetOutput()->GetPointData()->GetArray("Depth")->GetComponent(i, 0);
      seen += depth == depth;
      CHECK(depth != depth || isNear[i]);
    }
    CHECK_GREATER(seen, Width * Height / 8);
  }
}

// Seen from its original eye, the picture equals the relief.
void TestIdentity(RelevoCheck& check)
{
  for (const RelevoWarpScene& scene : RelevoMakeWarpScenes(Width, Height))
  {
    CHECK_CASE(scene.Name);
    for (ReliefProjection projection : Projections)
    {
      const auto image = RelevoMakeWarpRelief(scene, Width, Height, projection);
      RelevoAddWarpNormals(image);
      vtkNew<vtkReliefWarper> warper;
      warper->SetInputData(image);
      warper->SetCamera(RelevoMakeWarpCamera(
        Width, Height, projection, projection == ReliefProjection::Parallel, 0.0, 0.0));
      warper->Update();
      int different = 0;
      for (const char* name : { "Color", "Depth", "Normals" })
      {
        vtkDataArray* expected = image->GetPointData()->GetArray(name);
        vtkDataArray* found = warper->GetOutput()->GetPointData()->GetArray(name);
        for (vtkIdType i = 0; i < expected->GetNumberOfValues(); ++i)
        {
          const int components = expected->GetNumberOfComponents();
          const vtkIdType texel = i / components;
          const double depth = image->GetPointData()->GetArray("Depth")->GetComponent(texel, 0);
          const double value = found->GetComponent(texel, static_cast<int>(i % components));
          const double wanted = expected->GetComponent(texel, static_cast<int>(i % components));
          const bool isDepth = std::string(name) == "Depth";
          different += depth == depth ? value != wanted : (isDepth ? value == value : value != 0.0);
        }
      }
      if (!CHECK_EQUAL(different, 0))
      {
        std::cerr << scene.Name << ": " << different << " values differ\n";
      }
    }
  }
}

// The field arrays give the position of each texel of the output.
void TestPlaces(RelevoCheck& check)
{
  const auto image = RelevoMakeWarpRelief(
    RelevoMakeWarpScenes(Width, Height)[2], Width, Height, ReliefProjection::Perspective);
  const auto camera =
    RelevoMakeWarpCamera(Width, Height, ReliefProjection::Perspective, false, 10.0, 5.0);
  vtkNew<vtkReliefWarper> warper;
  warper->SetInputData(image);
  warper->SetCamera(camera);
  warper->Update();
  const RelevoWarpReference reference(image, camera);
  vtkFieldData* fields = warper->GetOutput()->GetFieldData();
  CHECK_EQUAL(fields->GetArray("ReliefProjection")->GetComponent(0, 0), 1.0);
  CHECK_EQUAL(fields->GetArray("ReliefMatrix")->GetNumberOfValues(), 16);
  double warp[4];
  for (int i = 0; i < 4; ++i)
  {
    warp[i] = fields->GetArray("ReliefWarp")->GetComponent(i, 0);
  }
  const double height = 0.98 * warp[3];
  const double above = height - warp[3];
  const dvec3 expected = reference.GetPoint(7, 4, height);
  CHECK_NEAR(7.0 * (1.0 + warp[2] * above) - warp[0] * above, expected.x, 1e-9);
  CHECK_NEAR(4.0 * (1.0 + warp[2] * above) - warp[1] * above, expected.y, 1e-9);
  CHECK_NOT_EQUAL(
    relevo::Relief().Read(warper->GetOutput()).find("vtkReliefWarper"), std::string::npos);
}

// Reliefs may have one row, one column or one texel.
void TestThin(RelevoCheck& check)
{
  for (const auto& size : { relevo::ivec2(40, 1), relevo::ivec2(1, 40), relevo::ivec2(1, 1) })
  {
    const auto image = RelevoMakeRelief(size.x, size.y, ReliefProjection::Parallel,
      relevo::dmat4(1.0), [](int, int) { return 10.0; });
    vtkNew<vtkReliefWarper> warper;
    warper->SetInputData(image);
    // Moves by 3 texels along the line and a third across.
    auto camera = RelevoMakeWarpCamera(size.x, size.y, ReliefProjection::Parallel, true,
      size.x > 1 ? 18.0 : 2.0, size.x > 1 ? 2.0 : 18.0);
    const int shift = size.x * size.y > 1 ? 3 : 0;
    if (shift == 0)
    {
      camera = RelevoMakeWarpCamera(1, 1, ReliefProjection::Parallel, true, 2.0, 2.0);
    }
    warper->SetCamera(camera);
    warper->Update();
    vtkDataArray* depths = warper->GetOutput()->GetPointData()->GetArray("Depth");
    const vtkIdType number = depths->GetNumberOfTuples();
    CHECK_EQUAL(number, image->GetNumberOfPoints());
    int seen = 0;
    for (vtkIdType i = 0; i < number; ++i)
    {
      seen += depths->GetComponent(i, 0) == 10.0;
    }
    CHECK_EQUAL(seen, number - shift);
  }
}
}

int TestReliefWarper(int, char*[])
{
  RelevoCheck check;
  TestAgainstReference(check);
  TestSingleTexels(check);
  TestRows(check);
  TestIdentity(check);
  TestPlaces(check);
  TestThin(check);
  return check.GetResult();
}
