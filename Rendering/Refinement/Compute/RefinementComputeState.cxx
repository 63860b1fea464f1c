// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Compute/RefinementComputeState.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Buffers/RefinementPatternBuffer.h"
#include "Evaluation/EdgeTags.h"
#include "Evaluation/FaceCulling.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/PatternFamily.h"
#include "Patterns/PatternLibrary.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace relevo
{
namespace
{
// For powers of two, steps are levels.
bool IsWithin(const std::array<unsigned char, 3>& steps, int maximumLevel)
{
  return *std::max_element(steps.begin(), steps.end()) <= maximumLevel;
}

std::vector<PatternGroup> GetAllGroups(const PatternFamily& family, const std::vector<int>& keys)
{
  std::vector<PatternGroup> groups;
  groups.reserve(keys.size());
  for (int key : keys)
  {
    groups.push_back({ family.GetPattern(key), PatternFamily::IsMirrored(key), 0, 0 });
  }
  return groups;
}

RefinementComputeSelector::Pattern MakePattern(
  const RefinementPatternBuffer::Range& range, bool mirrored)
{
  const int firstIndex = range.FirstIndex + (mirrored ? range.NumberOfIndices * range.Copies : 0);
  RefinementComputeSelector::Pattern pattern;
  pattern.Copies = static_cast<unsigned int>(range.Copies);
  pattern.NumberOfIndices = static_cast<unsigned int>(range.NumberOfIndices);
  pattern.FirstIndex = static_cast<unsigned int>(firstIndex);
  pattern.FirstVertex = static_cast<unsigned int>(range.FirstVertex);
  pattern.NumberOfVertices = static_cast<unsigned int>(range.NumberOfVertices);
  pattern.FirstLineVertex = static_cast<unsigned int>(range.FirstLineVertex);
  pattern.NumberOfLineVertices = static_cast<unsigned int>(range.NumberOfLineVertices);
  return pattern;
}

// Return the family's table of levels up to the highest, with keys replaced by their indices in
// `keys`.
std::vector<unsigned int> MakeTable(
  const PatternFamily& family, const std::vector<int>& keys, int maximumLevel)
{
  std::vector<unsigned int> places(static_cast<size_t>(family.GetNumberOfKeys()), 0);
  for (size_t i = 0; i < keys.size(); ++i)
  {
    places[keys[i]] = static_cast<unsigned int>(i);
  }
  std::vector<unsigned int> table;
  for (int order = 0; order < 6; ++order)
  {
    for (int a = 0; a <= maximumLevel; ++a)
    {
      for (int b = 0; b <= maximumLevel; ++b)
      {
        for (int c = 0; c <= maximumLevel; ++c)
        {
          const unsigned int entry = family.GetEntry(order, a, b, c);
          table.push_back(places[entry >> 3] << 3 | (entry & 7u));
        }
      }
    }
  }
  return table;
}

// Return all dependencies of a camera's view.
Dependencies GetSight(const CullingView* view, bool hideBackFaces)
{
  Dependencies sight;
  if (view && view->Valid)
  {
    sight.Add(hideBackFaces);
    view->AddTo(sight);
  }
  return sight;
}

RefinementComputeSelector::Camera MakeCamera(const CullingView& view, bool hideBackFaces)
{
  RefinementComputeSelector::Camera camera;
  static_assert(
    RefinementComputeSelector::Camera::NumberOfPlanes == CullingView::NumberOfPlanes, "the same");
  std::copy_n(view.Planes[0], 4 * CullingView::NumberOfPlanes, camera.Planes[0]);
  std::copy_n(view.Eye, 3, camera.Eye);
  camera.Parallel = view.Parallel;
  camera.HidesBackFaces = hideBackFaces;
  return camera;
}
}

bool RefinementComputeState::CanChooseFrom(const PatternFamily& family)
{
  return !family.AreWholeNumbers();
}

bool RefinementComputeState::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool RefinementComputeState::UpdateMesh(const RefinementMesh& mesh, vtkMTimeType time)
{
  if (this->MeshTime == time)
  {
    return true;
  }
  std::vector<unsigned char> orders;
  orders.reserve(mesh.Faces.size());
  for (const RefinementFace& face : mesh.Faces)
  {
    orders.push_back(face.Order);
  }
  if (!this->Selector.UploadOrders(orders))
  {
    return this->Fail(this->Selector.GetError());
  }
  if (!this->Tags.UploadMesh(mesh))
  {
    return this->Fail(this->Tags.GetError());
  }
  this->MeshTime = time;
  return true;
}

bool RefinementComputeState::UpdateCulling(const FaceCulling& culling, vtkMTimeType time)
{
  if (this->CullingTime == time)
  {
    return true;
  }
  if (!this->Selector.UploadCulling(culling.GetData()))
  {
    return this->Fail(this->Selector.GetError());
  }
  this->CullingTime = time;
  return true;
}

bool RefinementComputeState::UpdatePatterns(const PatternLibrary& library,
  const std::shared_ptr<const PatternFamily>& family, int maximumLevel,
  RefinementPatternBuffer& patterns, bool withLines)
{
  this->WithLines = this->WithLines || withLines;
  const auto dependencies = [&]
  {
    return Dependencies::On(
      family->GetMTime(), maximumLevel, patterns.GetUploadTime(), this->WithLines);
  };
  if (this->PatternDependencies == dependencies())
  {
    return true;
  }
  this->Keys.clear();
  for (int key = 0; key < family->GetNumberOfKeys(); ++key)
  {
    if (IsWithin(family->GetSteps(key), maximumLevel))
    {
      this->Keys.push_back(key);
    }
  }
  const std::vector<PatternGroup> groups = GetAllGroups(*family, this->Keys);
  patterns.Load(library, groups, this->WithLines);
  std::vector<RefinementComputeSelector::Pattern> described;
  for (const PatternGroup& group : groups)
  {
    described.push_back(MakePattern(patterns.GetRange(group), group.Mirrored));
  }
  if (!this->Selector.UploadPatterns(described, MakeTable(*family, this->Keys, maximumLevel),
        maximumLevel, family->IsMorphing()))
  {
    return this->Fail(this->Selector.GetError());
  }
  this->Family = family;
  this->PatternDependencies = dependencies();
  this->PatternsTime.Modified();
  return true;
}

bool RefinementComputeState::UpdateTags(const EdgeTags& tags)
{
  if (tags.GetKind() == EdgeTags::PER_EDGE && this->FaceEdgesTime != this->MeshTime)
  {
    if (!this->FaceEdges.Upload(tags.GetFaceEdges()))
    {
      return this->Fail(RefinementComputeBuffer::GetTooLarge());
    }
    this->FaceEdgesTime = this->MeshTime;
  }
  const MetricShader* shader = tags.GetShader();
  if (!shader)
  {
    return this->Values.Upload(
             tags.GetValues(), sizeof(float) * static_cast<size_t>(tags.GetNumberOfValues())) ||
      this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  const bool perEdge = tags.GetKind() == EdgeTags::PER_EDGE;
  const bool needsEdges = perEdge || !shader->TagsPoints;
  return ((!needsEdges || this->Tags.UploadEdges(*tags.GetEdges())) &&
           this->Tags.Evaluate(*shader, perEdge)) ||
    this->Fail(this->Tags.GetError());
}

bool RefinementComputeState::Select(
  View& view, const EdgeTags& tags, float offset, const Targets& targets)
{
  if (!this->UpdateTags(tags))
  {
    return false;
  }
  RefinementComputeSelector::Tags input = { RefinementComputeSelector::UNIFORM,
    tags.GetShader() ? this->Tags.GetTags() : this->Values.GetHandle(), targets.Faces, 4, offset };
  if (tags.GetKind() == EdgeTags::PER_POINT)
  {
    input.Kind = RefinementComputeSelector::PER_POINT;
  }
  else if (tags.GetKind() == EdgeTags::PER_EDGE)
  {
    input.Kind = RefinementComputeSelector::PER_EDGE;
    input.Elements = this->FaceEdges.GetHandle();
    input.Stride = 3;
  }
  return this->Selector.Select(view.Selection, input, targets.MorphTags) ||
    this->Fail(this->Selector.GetError());
}

bool RefinementComputeState::UpdateView(vtkOpenGLRenderWindow* window, int slot,
  const EdgeTags& tags, float offset, vtkMTimeType levelsTime, const CullingView* camera,
  bool hideBackFaces, const Targets& targets)
{
  View& view = this->Views[slot];
  const Dependencies levels = Dependencies::On(levelsTime, this->PatternsTime, targets.Instances);
  const bool select = view.LevelDependencies != levels;
  Dependencies sight = GetSight(camera, hideBackFaces);
  sight.Add(this->CullingTime);
  if (!select && view.SightDependencies == sight)
  {
    return true;
  }
  RefinementComputeProgram::Begin(window);
  const bool valid = !select || this->Select(view, tags, offset, targets);
  if (valid)
  {
    const bool culled = camera && camera->Valid;
    const RefinementComputeSelector::Camera eye =
      culled ? MakeCamera(*camera, hideBackFaces) : RefinementComputeSelector::Camera();
    this->Selector.Group(view.Selection, culled ? &eye : nullptr, targets.Instances);
    view.LevelDependencies = levels;
    view.SightDependencies = sight;
    view.GroupsTime.Modified();
  }
  RefinementComputeProgram::End();
  return valid;
}

vtkMTimeType RefinementComputeState::GetTime(int slot) const
{
  const auto view = this->Views.find(slot);
  return view == this->Views.end() ? 0 : view->second.GroupsTime.GetMTime();
}

std::vector<unsigned int> RefinementComputeState::ReadEntries(int slot)
{
  std::vector<unsigned int> entries = this->Views[slot].Selection.ReadEntries();
  for (unsigned int& entry : entries)
  {
    entry = static_cast<unsigned int>(this->Keys[entry >> 3]) << 3 | (entry & 7u);
  }
  return entries;
}

std::vector<unsigned char> RefinementComputeState::ReadHidden(int slot)
{
  const std::vector<unsigned int> ranks = this->Views[slot].Selection.ReadRanks();
  std::vector<unsigned char> hidden(ranks.size());
  std::transform(ranks.begin(), ranks.end(), hidden.begin(),
    [](unsigned int rank)
    { return static_cast<unsigned char>(rank == RefinementComputeView::NotDrawn ? 1 : 0); });
  return hidden;
}

std::vector<int> RefinementComputeState::ReadCounts(int slot)
{
  std::vector<int> counts(static_cast<size_t>(this->Family->GetNumberOfKeys()), 0);
  const std::vector<unsigned int> read = this->Views[slot].Selection.ReadCounts();
  for (size_t i = 0; i < read.size(); ++i)
  {
    counts[this->Keys[i]] = static_cast<int>(read[i]);
  }
  return counts;
}

vtkTypeInt64 RefinementComputeState::GetMemorySize() const
{
  vtkTypeInt64 size = this->Selector.GetMemorySize() + this->Tags.GetMemorySize() +
    this->Values.GetMemorySize() + this->FaceEdges.GetMemorySize();
  for (const auto& view : this->Views)
  {
    size += view.second.Selection.GetMemorySize();
  }
  return size;
}

void RefinementComputeState::ReleaseGraphicsResources()
{
  this->Selector.ReleaseGraphicsResources();
  this->Tags.ReleaseGraphicsResources();
  this->Values.ReleaseGraphicsResources();
  this->FaceEdges.ReleaseGraphicsResources();
  for (auto& view : this->Views)
  {
    view.second.Selection.ReleaseGraphicsResources();
  }
  this->Views.clear();
  this->MeshTime = 0;
  this->FaceEdgesTime = 0;
  this->CullingTime = 0;
  this->Family = nullptr;
  this->PatternDependencies.Clear();
}
}
