// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/PatchScalars.h"

#include "Arrays/NoDataTuples.h"
#include "Mesh/PatchArrays.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace relevo
{
namespace
{
// If one of its nodes has no data, a patch has none.
vtkSmartPointer<vtkDataArray> WithoutNoData(
  vtkPolyData* mesh, vtkDataArray* nodes, double noDataMagnitude)
{
  const NoDataTuples noData(nodes, noDataMagnitude);
  PatchArrays patches;
  std::string error;
  if (noData.IsEmpty() || !patches.Take(mesh, error))
  {
    return nodes;
  }
  auto result = vtkSmartPointer<vtkDoubleArray>::New();
  result->DeepCopy(nodes);
  const std::vector<double> nothing(
    static_cast<size_t>(nodes->GetNumberOfComponents()), vtkMath::Nan());
  for (int i = 0; i < patches.GetNumberOfPatches(); ++i)
  {
    const Patch patch = patches.GetPatch(i);
    const auto first = noData.GetMarks().begin() + patch.FirstPoint;
    const auto end = first + patch.GetNumberOfPoints();
    for (int k = 0; std::find(first, end, 1) != end && k < patch.GetNumberOfPoints(); ++k)
    {
      result->SetTuple(patch.FirstPoint + k, nothing.data());
    }
  }
  return result;
}
}

bool PatchScalars::Upload(
  vtkOpenGLRenderWindow* window, vtkPolyData* mesh, const FieldScalars& scalars)
{
  vtkDataArray* nodes = PatchArrays::FindNodes(mesh, scalars.Array);
  if (!nodes)
  {
    this->ReleaseGraphicsResources(window);
    return true;
  }
  this->Rational = PatchArrays::HaveDifferentWeights(mesh);
  Dependencies source;
  source.AddObject(nodes);
  source.AddObject(mesh);
  return this->Coefficients.Upload(window, source, scalars, nodes,
    [&] { return WithoutNoData(mesh, nodes, scalars.NoDataMagnitude); });
}

std::string PatchScalars::DescribeMisfit(vtkPolyData* mesh, vtkDataArray* scalars)
{
  const std::string name =
    std::string(PatchNodesPrefix) + (scalars->GetName() ? scalars->GetName() : "");
  vtkAbstractArray* nodes = mesh->GetFieldData()->GetAbstractArray(name.c_str());
  vtkAbstractArray* points = mesh->GetFieldData()->GetAbstractArray(PatchPointsName);
  std::ostringstream text;
  if (nodes && !PatchArrays::FindNodes(mesh, scalars))
  {
    text << "Cannot evaluate scalars at every pixel: the array " << name << " has "
         << nodes->GetNumberOfTuples() << " tuples of " << nodes->GetNumberOfComponents()
         << " components, but " << (points ? points->GetNumberOfTuples() : 0) << " tuples of "
         << scalars->GetNumberOfComponents() << " are needed. The scalars are interpolated.";
  }
  return text.str();
}

void PatchScalars::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Coefficients.ReleaseGraphicsResources(window);
}
}
