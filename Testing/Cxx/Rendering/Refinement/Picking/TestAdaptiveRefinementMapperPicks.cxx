// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on picking: vtkCellPicker finds the same point as on a vtkPolyDataMapper of the
// filter's output, for every surface, level, input, camera and matrix.
#include "RelevoDisplacements.h"
#include "RelevoPickers.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "vtkDistanceDepthTagMetric.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyDataMapper.h"

#include <functional>
#include <string>

namespace
{
using namespace RelevoMeshes;
using Builder = std::function<void(RelevoScene&)>;

class Pairs
{
public:
  explicit Pairs(RelevoCheck& check)
    : Check(check)
  {
  }

  void Compare(const std::string& name, const Builder& build, int lines = 60,
    const RelevoPickers::Tolerance& tolerance = RelevoPickers::Tolerance())
  {
    RelevoScene refining(RelevoScene::Refining);
    RelevoScene twin(RelevoScene::Twin);
    build(refining);
    build(twin);
    refining.ResetCameras();
    twin.UpdateFilters();
    twin.CopyCameras(refining);
    refining.Render();
    twin.Render();
    const int hits = RelevoPickers::Compare(refining, twin, lines, name, tolerance);
    if (hits < lines / 20)
    {
      this->Check.Fail(__FILE__, __LINE__, name + ": " + std::to_string(hits) + " hits");
    }
  }

private:
  RelevoCheck& Check;
};

vtkSmartPointer<vtkDisplacement> MakeWaves(double scale)
{
  vtkNew<RelevoHeights> waves;
  waves->FillWaves();
  return MakeDisplacement(waves, scale);
}

void TestSurfaces(Pairs& pairs)
{
  for (const auto& surface : RelevoMakeSurfaces(0.5))
  {
    pairs.Compare(surface.first,
      [&](RelevoScene& s)
      {
        Mesh mesh = Tagged(Sphere(9, 7), 4);
        AddRandomScalarTags(mesh, 5);
        s.Add(mesh, MakeRecipe(4, surface.second));
      });
    pairs.Compare(surface.first + ", displaced",
      [&](RelevoScene& s)
      {
        Mesh mesh = Tagged(Torus(), 3);
        AddRandomScalarTags(mesh, 5);
        s.Add(mesh, MakeRecipe(3, surface.second, MakeWaves(0.1)));
      });
  }
}

void TestMeshes(Pairs& pairs)
{
  pairs.Compare("level 0", [&](RelevoScene& s) { s.Add(Sphere(9, 7), MakeRecipe(0)); });
  pairs.Compare("split normals", [&](RelevoScene& s) { s.Add(Cube(), MakeRecipe(2)); });
  pairs.Compare("strips", [&](RelevoScene& s) { s.Add(Tagged(Strips(), 4), MakeRecipe(4)); });
  pairs.Compare("points of each triangle's own",
    [&](RelevoScene& s) { s.Add(Tagged(Explode(Sphere(9, 7)), 3), MakeRecipe(3)); });
  pairs.Compare("faces on both sides", [&](RelevoScene& s) { s.Add(Moebius(), MakeRecipe(2)); });
  pairs.Compare("slivers", [&](RelevoScene& s) { s.Add(Slivers(), MakeRecipe(3)); });
}

void TestHoles(Pairs& pairs)
{
  vtkNew<RelevoHeights> holes;
  holes->FillWavesWithHoles();
  pairs.Compare("holes",
    [&](RelevoScene& s)
    {
      Mesh mesh = Tagged(Plane(6, 5), 5);
      s.Add(mesh, MakeRecipe(5, nullptr, MakeDisplacement(holes, 0.2)));
    });
}

void TestLevels(Pairs& pairs)
{
  pairs.Compare("levels of the view, morphing",
    [&](RelevoScene& s)
    {
      auto recipe = MakeRecipe(5);
      vtkNew<vtkDistanceDepthTagMetric> metric;
      metric->SetMaximumDistance(4.0);
      recipe->SetMetric(metric);
      recipe->SetSurface(vtkNew<vtkPNTriangleSurface>());
      s.Add(Sphere(9, 7), recipe);
    });
  pairs.Compare("whole segments, moved levels",
    [&](RelevoScene& s)
    {
      auto recipe = MakeRecipe(4, nullptr, MakeWaves(0.1));
      recipe->SetSegmentPolicyToWholeNumbers();
      recipe->SetLevelOffset(-0.7);
      s.Add(Tagged(Torus(), 4), recipe);
    });
}

void AddTurned(RelevoScene& s, double scale)
{
  vtkActor* actor = s.Add(Tagged(Torus(), 3), MakeRecipe(3, nullptr, MakeWaves(0.1)));
  actor->SetScale(scale, 2.0, 0.5);
  actor->RotateX(40.0);
  actor->SetPosition(100.0, -20.0, 7.0);
}

void TestMatrices(Pairs& pairs)
{
  pairs.Compare("turned", [&](RelevoScene& s) { AddTurned(s, 1.5); });
  pairs.Compare("mirrored", [&](RelevoScene& s) { AddTurned(s, -1.5); });
}

void TestCameras(Pairs& pairs)
{
  pairs.Compare("parallel projection",
    [&](RelevoScene& s)
    {
      s.MoveCamera = [](vtkCamera* camera) { camera->ParallelProjectionOn(); };
      AddTurned(s, 1.0);
    });
  pairs.Compare("from inside",
    [&](RelevoScene& s)
    {
      s.MoveCamera = [](vtkCamera* camera)
      {
        camera->SetPosition(0.1, 0.05, 0.0);
        camera->SetFocalPoint(1.0, 0.3, 0.2);
      };
      s.Add(Tagged(TexturedSphere(9, 7), 4), MakeRecipe(4, nullptr, MakeWaves(0.05)));
    });
}

void TestFarFromOrigin(Pairs& pairs)
{
  pairs.Compare("far from the origin",
    [&](RelevoScene& s)
    {
      const double offset[3] = { 5e5, -4e6, 1e3 };
      s.Add(Moved(Tagged(Torus(), 3), 100.0, offset, VTK_DOUBLE),
        MakeRecipe(3, nullptr, MakeWaves(10.0)));
    });
}

// Rays pass through clipped parts and hit the surface behind.
void TestClipping(Pairs& pairs)
{
  pairs.Compare("clipped",
    [&](RelevoScene& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.1, 0.0, 0.0);
      plane->SetNormal(-0.3, 0.2, -1.0);
      vtkNew<vtkPlaneCollection> planes;
      planes->AddItem(plane);
      vtkActor* actor = s.Add(Tagged(Torus(), 3), MakeRecipe(3, nullptr, MakeWaves(0.1)));
      actor->GetMapper()->SetClippingPlanes(planes);
      actor->RotateX(10.0);
    });
}
}

int TestAdaptiveRefinementMapperPicks(int, char*[])
{
  RelevoCheck check;
  Pairs pairs(check);
  TestSurfaces(pairs);
  TestMeshes(pairs);
  TestHoles(pairs);
  TestLevels(pairs);
  TestMatrices(pairs);
  TestCameras(pairs);
  TestFarFromOrigin(pairs);
  TestClipping(pairs);
  return check.GetResult();
}
