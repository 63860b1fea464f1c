// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatchSurface.h"

#include "Mesh/PatchArrays.h"
#include "Patches/PatchField.h"
#include "Patches/PatchTables.h"
#include "vtkObjectFactory.h"

#include "relevoPatch.h"
#include "relevoPatchSurface.h"

#include <algorithm>

using relevo::PatchCorners;
using relevo::PatchFace;

vtkStandardNewMacro(vtkPatchSurface);

vtkPatchSurface::vtkPatchSurface() = default;
vtkPatchSurface::~vtkPatchSurface() = default;

bool vtkPatchSurface::BuildTables(
  vtkPolyData* mesh, const double origin[3], Tables& tables, std::string& error)
{
  return relevo::BuildPatchTables(mesh, origin, tables, error);
}

bool vtkPatchSurface::SplitsNormals(const Face&)
{
  return true;
}

void vtkPatchSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  PatchFace patch(face);
  const glm::vec3 w = PatchCorners::Load(weights);
  relevo::store(patch.surfacePosition(w), position);
  relevo::store(patch.surfaceNormal(w), normal);
}

void vtkPatchSurface::EvaluateDirection(
  const Face& face, const float weights[3], float direction[3])
{
  PatchFace patch(face);
  relevo::store(patch.surfaceDirection(PatchCorners::Load(weights)), direction);
}

vtkDataArray* vtkPatchSurface::FindCoefficients(vtkPolyData* mesh, vtkDataArray* pointArray)
{
  return relevo::PatchArrays::FindNodes(mesh, pointArray);
}

void vtkPatchSurface::EvaluateField(
  const Face& face, const float weights[3], vtkDataArray* coefficients, double* tuple)
{
  relevo::EvaluatePatchField(face, weights, coefficients, tuple);
}

void vtkPatchSurface::ExtendBox(const Face& face, double low[3], double high[3])
{
  PatchFace faceOfPatch(face);
  const PatchFace::PatchShape shape = faceOfPatch.facePatch().Shape;
  const relevo::Patch patch{ shape.IsTriangle, shape.Degrees, shape.First };
  for (int i = 0; i < patch.GetNumberOfPoints(); ++i)
  {
    const glm::vec4 point = faceOfPatch.tablePoint(shape.First + i);
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min<double>(low[c], point[c]);
      high[c] = std::max<double>(high[c], point[c]);
    }
  }
}

std::string vtkPatchSurface::GetShaderSource()
{
  return std::string("vec4 patchPoint(int i);\n") + relevoPatch + relevoPatchSurface;
}

void vtkPatchSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
