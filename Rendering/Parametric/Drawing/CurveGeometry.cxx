// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurveGeometry.h"

#include "OpenGL/ShaderUniforms.h"

#include "Actors/ActorView.h"
#include "Curves/CurveFrames.h"
#include "Curves/CurveRadii.h"
#include "View/CullingView.h"
#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSet.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
bool CurveGeometry::SetCurves(vtkPointSet* input)
{
  Dependencies source;
  source.AddObject(input);
  if (!this->InputSource.Update(source))
  {
    return false;
  }
  this->Input = input;
  this->Mesh.Build(input);
  this->Selection.SetCurves(input, this->Mesh);
  this->PointBox = FiniteBox();
  for (const dvec4& point : this->Mesh.GetPoints())
  {
    this->PointBox.Add(&point.x);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = this->PointBox.GetMiddle(axis);
  }
  this->NeedsCurves = true;
  this->NeedsRadii = true;
  this->NeedsFrames = true;
  this->ShapeSource.Clear();
  return true;
}

bool CurveGeometry::SetShape(const Shape& shape)
{
  const Dependencies source =
    Dependencies::On(shape.Sides > 1, shape.Radius, shape.RadiusArrayName);
  this->Current = shape;
  if (!this->ShapeSource.Update(source))
  {
    return false;
  }
  this->RadiusError.clear();
  this->Radii.assign(1, shape.Sides > 1 ? shape.Radius : 0.0);
  if (shape.Sides > 1 && !shape.RadiusArrayName.empty())
  {
    if (vtkDataArray* radii = FindCurveRadii(this->Input, shape.RadiusArrayName, this->RadiusError))
    {
      this->Radii = this->Mesh.ComputeCoefficients(radii);
    }
  }
  this->NeedsRadii = true;
  this->Selection.SetReaches(this->Radii, this->Origin);
  return true;
}

void CurveGeometry::GetBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  if (this->Mesh.GetNumberOfCurves() > 0)
  {
    const double reach = this->Radii.empty()
      ? 0.0
      : std::abs(*std::max_element(this->Radii.begin(), this->Radii.end(),
          [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = this->PointBox.Low[axis] - reach;
      bounds[2 * axis + 1] = this->PointBox.High[axis] + reach;
    }
  }
}

std::string CurveGeometry::Select(
  vtkAdaptiveRefinement* recipe, vtkRenderer* renderer, vtkActor* actor, bool isCulled)
{
  vtkProperty* property = actor->GetProperty();
  const CullingView culling(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(),
    actor->GetMatrix(), &this->Origin.x,
    GetViewMargins(renderer, std::max(property->GetLineWidth(), property->GetPointSize())));
  this->Eye = dvec4(culling.Eye[0], culling.Eye[1], culling.Eye[2], culling.Parallel ? 0.0 : 1.0);
  std::string error;
  this->Selection.Update(recipe, MakeActorView(renderer, actor),
    isCulled && !MovesVertices(actor) ? &culling : nullptr, error);
  return error;
}

bool CurveGeometry::Upload(vtkOpenGLRenderWindow* window, bool withCells)
{
  if (this->NeedsCurves)
  {
    ++this->NumberOfUploads;
    if (!this->Buffers.Upload(window, this->Mesh, this->Origin))
    {
      return false;
    }
    this->NeedsCurves = false;
  }
  const bool hasSides = this->Current.Sides > 1;
  if (hasSides && this->NeedsRadii)
  {
    ++this->NumberOfUploads;
    if (!this->Buffers.UploadRadii(
          window, this->Radii.size() > 1 ? this->Radii : std::vector<double>()))
    {
      return false;
    }
    this->NeedsRadii = false;
  }
  if (hasSides && this->NeedsFrames)
  {
    ++this->NumberOfUploads;
    CurveFrames frames;
    frames.Build(this->Mesh);
    if (!this->Buffers.UploadFrames(window, frames))
    {
      return false;
    }
    this->NeedsFrames = false;
  }
  return (!withCells || this->Buffers.UploadCells(window, this->Mesh)) &&
    this->Instances.Upload(
      window, 0, this->Selection.GetMembers(), this->Selection.GetGroupsTime());
}

void CurveGeometry::Activate(vtkShaderProgram* program)
{
  this->Buffers.Activate(program);
  if (program->IsUniformUsed("relevoEye"))
  {
    SetVector(program, "relevoEye", this->Eye);
  }
  if (program->IsUniformUsed("relevoRadius"))
  {
    program->SetUniformf("relevoRadius", static_cast<float>(this->Radii.front()));
  }
}

void CurveGeometry::Deactivate()
{
  this->Instances.Deactivate();
  this->Buffers.Deactivate();
}

vtkTypeInt64 CurveGeometry::GetMemorySize() const
{
  return this->Buffers.GetMemorySize() + this->Instances.GetMemorySize();
}

void CurveGeometry::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.ReleaseGraphicsResources(window);
  this->Instances.ReleaseGraphicsResources(window);
  this->NeedsCurves = true;
  this->NeedsRadii = true;
  this->NeedsFrames = true;
}
}
