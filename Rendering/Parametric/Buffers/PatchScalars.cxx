// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/PatchScalars.h"

#include "Arrays/NoDataTuples.h"
#include "Buffers/DirectColors.h"
#include "Mesh/PatchArrays.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
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

bool PatchScalars::Upload(vtkOpenGLRenderWindow* window, const Source& source)
{
  this->ReleaseGraphicsResources(window);
  vtkDataArray* nodes = PatchArrays::FindNodes(source.Mesh, source.Scalars);
  if (!nodes)
  {
    return true;
  }
  this->Rational = PatchArrays::HaveDifferentWeights(source.Mesh);
  const int type = source.Scalars->GetDataType();
  if (source.AreColors)
  {
    return this->UploadColors(window, nodes, type);
  }
  const vtkSmartPointer<vtkDataArray> values =
    WithoutNoData(source.Mesh, nodes, source.NoDataMagnitude);
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!this->Numbers.Upload(
        window, values, source.Table, source.Component, source.ByTexture, none, type))
  {
    return false;
  }
  const ScalarKind kind = this->Numbers.GetKind();
  this->Coloring = kind == BY_VALUE
    ? PatchColoring::TABLE
    : (kind == BY_TEXTURE ? PatchColoring::TEXTURE : PatchColoring::NONE);
  return true;
}

bool PatchScalars::UploadColors(vtkOpenGLRenderWindow* window, vtkDataArray* nodes, int type)
{
  const std::vector<float> colors = GetDirectColors(nodes, type);
  if (colors.empty())
  {
    return true; // VTK's colours of the corners are used
  }
  this->Coloring = PatchColoring::COLORS;
  return this->Colors.Upload(window, colors, 4);
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

bool PatchScalars::IsNumber() const
{
  const bool areColors = this->Coloring == PatchColoring::COLORS;
  return this->Coloring != PatchColoring::NONE && !areColors && this->Numbers.IsNumber();
}

void PatchScalars::Activate(vtkShaderProgram* program)
{
  if (this->Coloring == PatchColoring::TABLE || this->Coloring == PatchColoring::TEXTURE)
  {
    this->Numbers.Activate(program);
  }
  this->Colors.Activate(program, "relevoFieldColors");
}

void PatchScalars::Deactivate()
{
  this->Numbers.Deactivate();
  this->Colors.Deactivate();
}

vtkTypeInt64 PatchScalars::GetMemorySize() const
{
  return this->Numbers.GetMemorySize() + this->Colors.GetMemorySize();
}

void PatchScalars::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Coloring = PatchColoring::NONE;
  this->Numbers.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
}
}
