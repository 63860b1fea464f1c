// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementFaceColors.h"

#include "Buffers/RefinementLevelTable.h"
#include "Buffers/RefinementPatternBuffer.h"
#include "Evaluation/EdgeTags.h"
#include "Mesh/RefinementMesh.h"
#include "State/ViewSelection.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <map>

namespace relevo
{
namespace
{
// Return tags per point, or per face and sorted edge.
std::vector<float> GetTags(const RefinementMesh& mesh, const EdgeTags& tags, float highest)
{
  if (tags.GetKind() == EdgeTags::PER_POINT)
  {
    return std::vector<float>(tags.GetValues(), tags.GetValues() + tags.GetNumberOfValues());
  }
  std::vector<float> values(3 * mesh.Faces.size(), highest);
  if (tags.GetKind() == EdgeTags::PER_EDGE)
  {
    for (size_t i = 0; i < values.size(); ++i)
    {
      values[i] = tags.GetValues()[tags.GetFaceEdges()[i]];
    }
  }
  return values;
}
}

bool RefinementFaceColors::UploadPatterns(vtkOpenGLRenderWindow* window, int mode,
  bool wholeNumbers, const RefinementPatternBuffer& patterns, vtkScalarsToColors* table)
{
  Dependencies dependencies = Dependencies::On(patterns.GetUploadTime(), mode, wholeNumbers);
  dependencies.AddObject(table);
  if (dependencies == this->ColorDependencies)
  {
    return true;
  }
  std::vector<float> colors;
  for (const auto& pattern : patterns.GetPatterns())
  {
    const std::array<float, 4> color =
      ColorTable::GetColor(table, RefinementLevelTable::GetValue(mode, wholeNumbers, *pattern));
    colors.insert(colors.end(), color.begin(), color.end());
  }
  return this->UploadColors(window, colors, dependencies);
}

bool RefinementFaceColors::UploadColors(
  vtkOpenGLRenderWindow* window, const std::vector<float>& colors, const Dependencies& dependencies)
{
  if (!colors.empty() && !this->Colors.Upload(window, colors, 4))
  {
    return false;
  }
  this->ColorDependencies = dependencies;
  return true;
}

bool RefinementFaceColors::UploadFaces(vtkOpenGLRenderWindow* window, int mode, bool wholeNumbers,
  const ViewSelection& selection, vtkScalarsToColors* table)
{
  Dependencies dependencies = Dependencies::On(mode, wholeNumbers);
  dependencies.AddObject(table);
  dependencies.AddObject(&selection, selection.GetLevelsTime());
  if (dependencies == this->ColorDependencies)
  {
    return true;
  }
  const PatternSelection& faces = selection.GetSelection();
  std::map<const RefinementPattern*, std::array<float, 4>> known;
  std::vector<float> colors;
  for (int face = 0; face < faces.GetNumberOfFaces(); ++face)
  {
    const RefinementPattern* pattern = faces.GetFacePattern(face).Pattern;
    auto color = known.find(pattern);
    if (color == known.end())
    {
      color = known
                .insert({ pattern,
                  ColorTable::GetColor(
                    table, RefinementLevelTable::GetValue(mode, wholeNumbers, *pattern)) })
                .first;
    }
    colors.insert(colors.end(), color->second.begin(), color->second.end());
  }
  return this->UploadColors(window, colors, dependencies);
}

bool RefinementFaceColors::UploadTags(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
  const ViewSelection& selection, double offset, int highest, vtkScalarsToColors* table)
{
  this->Offset = static_cast<float>(offset);
  this->Highest = static_cast<float>(highest);
  Dependencies tableDependencies = Dependencies::On(highest);
  tableDependencies.AddObject(table);
  if (this->TableDependencies != tableDependencies)
  {
    const double range[2] = { 0.0, static_cast<double>(highest) };
    if (!this->Table.Upload(window, table, 0.0, range))
    {
      return false;
    }
    this->TableDependencies = tableDependencies;
  }
  Dependencies tagDependencies;
  tagDependencies.AddObject(&selection, selection.GetLevelsTime());
  if (this->TagDependencies != tagDependencies)
  {
    const EdgeTags& tags = selection.GetTags();
    this->PerEdge = tags.GetKind() != EdgeTags::PER_POINT;
    if (!this->Tags.Upload(window, GetTags(mesh, tags, this->Highest), this->PerEdge ? 3 : 1))
    {
      return false;
    }
    this->TagDependencies = tagDependencies;
  }
  return true;
}

void RefinementFaceColors::Activate(vtkShaderProgram* program)
{
  this->Colors.Activate(program, "relevoFaceColors");
  if (program->IsUniformUsed("relevoTags"))
  {
    this->Tags.Activate(program, "relevoTags");
    this->Table.Activate(program);
    program->SetUniformi("relevoTagsPerEdge", this->PerEdge ? 1 : 0);
    program->SetUniformf("relevoTagOffset", this->Offset);
    program->SetUniformf("relevoHighestTag", this->Highest);
  }
}

void RefinementFaceColors::Deactivate()
{
  this->Colors.Deactivate();
  this->Tags.Deactivate();
  this->Table.Deactivate();
}

vtkTypeInt64 RefinementFaceColors::GetMemorySize() const
{
  return this->Colors.GetMemorySize() + this->Tags.GetMemorySize() + this->Table.GetMemorySize();
}

void RefinementFaceColors::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Colors.ReleaseGraphicsResources(window);
  this->Tags.ReleaseGraphicsResources(window);
  this->Table.ReleaseGraphicsResources(window);
  this->ColorDependencies.Clear();
  this->TagDependencies.Clear();
  this->TableDependencies.Clear();
}
}
