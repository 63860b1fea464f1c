// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoSurfaceFields.h"

#include "vtkPointData.h"

std::array<double, 3> NormalOfSphere(const std::array<double, 3>& p)
{
  std::array<double, 3> normal = p;
  vtkMath::Normalize(normal.data());
  return normal;
}

std::array<double, 3> NormalOfTorus(const std::array<double, 3>& p)
{
  const double radius = std::hypot(p[0], p[1]);
  std::array<double, 3> normal{ { p[0] - p[0] / radius, p[1] - p[1] / radius, p[2] } };
  vtkMath::Normalize(normal.data());
  return normal;
}

RelevoSurfaceField TangentOf(const RelevoSurfaceField& field, const RelevoSurfaceField& normal)
{
  return [=](const std::array<double, 3>& p)
  {
    std::array<double, 3> v = field(p);
    const std::array<double, 3> n = normal(p);
    const double height = vtkMath::Dot(v, n);
    for (int i = 0; i < 3; ++i)
    {
      v[i] -= height * n[i];
    }
    return v;
  };
}

std::vector<RelevoNamedSurfaceField> MakeSurfaceFields(const RelevoSurfaceField& normal)
{
  using Vector = std::array<double, 3>;
  const auto uniform = [](const Vector&) { return Vector{ { 0.9, 0.3, 0.3 } }; };
  const auto vortex = [](const Vector& p)
  {
    const double axis[3] = { 0.3, 0.2, 0.9 };
    Vector v;
    vtkMath::Cross(axis, p.data(), v.data());
    return v;
  };
  const auto saddle = [](const Vector& p) { return Vector{ { p[0], -p[1], 0.3 * p[2] } }; };
  const auto dipole = [](const Vector& p)
  {
    Vector v{ { 0.0, 0.0, 0.0 } };
    for (double sign : { 1.0, -1.0 })
    {
      const Vector d{ { p[0] + 0.7 * sign, p[1] - 0.2, p[2] + 0.3 } };
      for (int i = 0; i < 3; ++i)
      {
        v[i] += sign * d[i] / std::pow(vtkMath::Dot(d, d), 1.5);
      }
    }
    return v;
  };
  return { { "uniform", TangentOf(uniform, normal) }, { "vortex", TangentOf(vortex, normal) },
    { "saddle", TangentOf(saddle, normal) }, { "dipole", TangentOf(dipole, normal) } };
}

RelevoMeshes::Mesh WithField(vtkPolyData* mesh, const RelevoSurfaceField& field)
{
  RelevoMeshes::Mesh result = RelevoMeshes::Make();
  result->ShallowCopy(mesh);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Flow");
  RelevoMeshes::FillVectors(result, field, vectors);
  result->GetPointData()->SetVectors(vectors);
  return result;
}

RelevoMeshes::Mesh WithNormals(vtkPolyData* mesh, const RelevoSurfaceField& normal)
{
  RelevoMeshes::Mesh result = RelevoMeshes::Make();
  result->ShallowCopy(mesh);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  RelevoMeshes::FillVectors(result, normal, normals);
  result->GetPointData()->SetNormals(normals);
  return result;
}

RelevoScreen::RelevoScreen(vtkRenderer* renderer)
{
  std::copy_n(renderer->GetSize(), 2, this->Size);
  this->ToScreen->DeepCopy(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), 0.0, 1.0));
  vtkMatrix4x4::Invert(this->ToScreen, this->ToWorld);
}

std::array<double, 3> RelevoScreen::Find(int column, int row, double depth) const
{
  return Transform(this->ToWorld,
    { { 2.0 * (column + 0.5) / this->Size[0] - 1.0, 2.0 * (row + 0.5) / this->Size[1] - 1.0,
      depth } });
}

void RelevoScreen::Project(
  const std::array<double, 3>& place, const std::array<double, 3>& velocity, double* v) const
{
  const double time = 1e-5;
  std::array<double, 3> before = place;
  std::array<double, 3> after = place;
  for (int i = 0; i < 3; ++i)
  {
    before[i] -= time * velocity[i];
    after[i] += time * velocity[i];
  }
  before = Transform(this->ToScreen, before);
  after = Transform(this->ToScreen, after);
  for (int i = 0; i < 2; ++i)
  {
    v[i] = 0.5 * this->Size[i] * (after[i] - before[i]) / (2.0 * time);
  }
}

std::array<double, 3> RelevoScreen::Transform(vtkMatrix4x4* matrix, const std::array<double, 3>& p)
{
  const double in[4] = { p[0], p[1], p[2], 1.0 };
  double out[4];
  matrix->MultiplyPoint(in, out);
  return { { out[0] / out[3], out[1] / out[3], out[2] / out[3] } };
}

RelevoDeviations MeasureStreaks(const RelevoLICPicture& picture, vtkRenderer* renderer,
  const RelevoSurfaceField& field, const RelevoSurfaceField& normal)
{
  const RelevoScreen screen(renderer);
  double eye[3];
  renderer->GetActiveCamera()->GetPosition(eye);
  constexpr int Margin = 8; // where the border affects the orientation
  return MeasureDeviations(RelevoOrientation(picture.GetFilled()),
    [&](int column, int row, double* vector)
    {
      if (!picture.HasLIC(column, row, Margin))
      {
        return false;
      }
      const std::array<double, 3> place = screen.Find(column, row, picture.GetDepth(column, row));
      double sight[3] = { eye[0] - place[0], eye[1] - place[1], eye[2] - place[2] };
      vtkMath::Normalize(sight);
      const std::array<double, 3> v = field(place);
      screen.Project(place, v, vector);
      return std::abs(vtkMath::Dot(normal(place).data(), sight)) > 0.35 &&
        vtkMath::Norm(v.data()) > 0.2;
    });
}
