// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that face culling hides no face with a visible refined triangle, and that it hides most
// faces that are out of view.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoTestMeshes.h"

#include "Evaluation/FaceCulling.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkG1Surface.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkPolyDataNormals.h"
#include "vtkProceduralSurface.h"
#include "vtkReverseSense.h"
#include "vtkTransform.h"

#include <iostream>
#include <random>

namespace
{
using namespace RelevoMeshes;

constexpr double Aspect = 1.5;

double Uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
}

// Whether a triangle, given in clip coordinates, reaches between the frustum's sides and faces the
// eye.
bool IsSeen(const double clip[3][4], bool anyFace)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    for (double sign : { -1.0, 1.0 })
    {
      bool out = true;
      for (int i = 0; i < 3; ++i)
      {
        out = out && sign * clip[i][axis] > clip[i][3];
      }
      if (out)
      {
        return false;
      }
    }
  }
  if (clip[0][3] <= 0.0 && clip[1][3] <= 0.0 && clip[2][3] <= 0.0)
  {
    return false;
  }
  // The sign of this determinant is the winding, even if the triangle is partly behind the eye.
  const auto at = [&clip](int i, int c) { return clip[i][c == 2 ? 3 : c]; };
  const double determinant = at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
    at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
    at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  return anyFace || determinant > 0.0;
}

struct Counts
{
  int Hidden = 0;
  int Unseen = 0;
  int Wrong = 0; // hidden although visible
};

// Views the mesh from a random camera.
Counts Look(vtkPolyData* input, vtkAdaptiveRefinement* recipe, std::mt19937& random, bool inside)
{
  relevo::RefinementMesh mesh;
  mesh.Build(input, recipe->GetSurface(), recipe->GetDisplacement());
  relevo::FaceCulling culling;
  culling.Build(mesh, recipe);
  Mesh refined = Refine(input, recipe);
  auto* cells =
    vtkIdTypeArray::SafeDownCast(refined->GetCellData()->GetAbstractArray("vtkOriginalCellIds"));

  vtkNew<vtkTransform> placement;
  placement->Translate(Uniform(random, -3, 3), Uniform(random, -3, 3), Uniform(random, -3, 3));
  placement->RotateWXYZ(Uniform(random, 0, 360), 1, Uniform(random, -1, 1), 0.5);
  placement->Scale(Uniform(random, 0.5, 2), 1, Uniform(random, 0.5, 2));
  double bounds[6];
  input->GetBounds(bounds);
  double target[3];
  double size = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    target[c] = Uniform(random, bounds[2 * c], bounds[2 * c + 1]);
    size = std::max(size, bounds[2 * c + 1] - bounds[2 * c]);
  }
  placement->TransformPoint(target, target);
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(target);
  const double distance = inside ? 0.2 : Uniform(random, 0.5, 3.0);
  camera->SetPosition(target[0] + Uniform(random, -1, 1) * distance * size,
    target[1] + Uniform(random, -1, 1) * distance * size,
    target[2] + Uniform(random, -1, 1) * distance * size);
  camera->SetViewUp(0.1, 0.9, 0.3);
  camera->SetViewAngle(Uniform(random, 10, 60));
  camera->SetParallelProjection(random() % 4 == 0);
  camera->SetParallelScale(Uniform(random, 0.1, 1.0) * size);
  camera->SetClippingRange(0.01, 1000.0);

  const relevo::CullingView view(camera, Aspect, placement->GetMatrix(), mesh.Origin);
  std::vector<unsigned char> hidden;
  Counts counts;
  counts.Hidden = culling.FindHidden(view, true, hidden);
  const bool backsHidden = culling.IsClosed() && culling.IsUncut(view);

  vtkNew<vtkMatrix4x4> toClip;
  vtkMatrix4x4::Multiply4x4(
    camera->GetCompositeProjectionTransformMatrix(Aspect, -1, 1), placement->GetMatrix(), toClip);
  // All cells of the input are triangles, so faces and cells have the same numbers.
  std::vector<bool> seen(static_cast<size_t>(input->GetNumberOfCells()), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < refined->GetNumberOfCells(); ++t)
  {
    refined->GetCellPoints(t, ids);
    double clip[3][4];
    for (int i = 0; i < 3; ++i)
    {
      double point[4] = { 0, 0, 0, 1 };
      refined->GetPoint(ids->GetId(i), point);
      toClip->MultiplyPoint(point, clip[i]);
    }
    if (IsSeen(clip, !backsHidden))
    {
      seen[static_cast<size_t>(cells->GetValue(t))] = true;
    }
  }
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const bool isSeen = seen[static_cast<size_t>(mesh.Faces[f].Cell)];
    counts.Unseen += isSeen ? 0 : 1;
    counts.Wrong += isSeen && hidden[f] ? 1 : 0;
  }
  return counts;
}
}

int TestFaceCulling(int, char*[])
{
  RelevoCheck check;
  std::mt19937 random(3);
  vtkNew<vtkPNTriangleSurface> curved;
  vtkNew<vtkPhongSurface> phong;
  phong->SetAlpha(0.8);
  vtkNew<vtkProceduralSurface> fur;
  fur->SetAmplitude(0.2);
  vtkNew<vtkG1Surface> g1;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(17, 13, 4);
  auto displacement = MakeDisplacement(heights, 0.4);
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputData(Sphere(16, 12));
  reversed->ReverseCellsOn();
  reversed->Update();

  struct Case
  {
    const char* Name;
    Mesh Input;
    vtkRefinementSurface* Surface;
    vtkDisplacement* Displacement;
    bool Closed;
    double MinimumShare; // the smallest allowed share of invisible faces that are hidden
  };
  const Case cases[] = {
    { "sphere", Sphere(16, 12), nullptr, nullptr, true, 0.8 },
    { "curved sphere", Sphere(16, 12), curved, nullptr, true, 0.5 },
    { "Phong sphere", Sphere(16, 12), phong, nullptr, true, 0.5 },
    { "furry sphere", Sphere(16, 12), fur, nullptr, true, 0.3 },
    { "G1 sphere", Sphere(16, 12), g1, nullptr, true, 0.3 },
    { "sphere of single triangles", Explode(Sphere(16, 12)), nullptr, nullptr, true, 0.8 },
    { "sphere inside out", reversed->GetOutput(), nullptr, nullptr, false, 0.3 },
    { "displaced", TexturedSphere(16, 12), nullptr, displacement, false, 0.05 },
    { "non-manifold", NonManifold(), nullptr, nullptr, false, 0.0 },
    { "Moebius", Moebius(), curved, nullptr, false, 0.0 },
  };
  for (const Case& c : cases)
  {
    CHECK_CASE(c.Name);
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetMaximumLevel(3);
    recipe->SetSurface(c.Surface);
    recipe->SetDisplacement(c.Displacement);
    relevo::RefinementMesh mesh;
    CHECK(mesh.Build(c.Input, recipe->GetSurface(), recipe->GetDisplacement()));
    relevo::FaceCulling culling;
    culling.Build(mesh, recipe);
    CHECK_EQUAL(culling.IsClosed(), c.Closed);
    Counts sum;
    for (int i = 0; i < 60; ++i)
    {
      const Counts counts = Look(c.Input, recipe, random, i % 6 == 5);
      sum.Hidden += counts.Hidden;
      sum.Unseen += counts.Unseen;
      sum.Wrong += counts.Wrong;
    }
    std::cout << c.Name << ": " << sum.Hidden << " faces culled of " << sum.Unseen
              << " that are not visible\n";
    CHECK_EQUAL(sum.Wrong, 0);
    CHECK_LESS_EQUAL(sum.Hidden, sum.Unseen);
    CHECK_GREATER_EQUAL(sum.Hidden, c.MinimumShare * sum.Unseen);
  }

  // Nothing is hidden for cameras without a direction and flattening matrices.
  relevo::RefinementMesh mesh;
  vtkNew<vtkAdaptiveRefinement> recipe;
  CHECK(mesh.Build(Sphere(8, 6), recipe->GetSurface(), recipe->GetDisplacement()));
  relevo::FaceCulling culling;
  culling.Build(mesh, recipe);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkMatrix4x4> flat;
  flat->SetElement(0, 0, 0.0);
  std::vector<unsigned char> hidden;
  CHECK_EQUAL(
    culling.FindHidden(relevo::CullingView(camera, 1.0, flat, mesh.Origin), true, hidden), 0);
  CHECK_EQUAL(hidden.size(), mesh.Faces.size());
  return check.GetResult();
}
