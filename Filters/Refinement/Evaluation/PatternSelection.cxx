// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/PatternSelection.h"

#include "Evaluation/FaceTags.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/RefinementPattern.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Faces are counted and scattered in parallel chunks, which must be large enough for their
// counters.
vtkIdType GetNumberOfChunks(vtkIdType numberOfFaces, int numberOfKeys)
{
  const vtkIdType least = std::max(4096, 2 * numberOfKeys);
  const vtkIdType most = 4 * vtkSMPTools::GetEstimatedNumberOfThreads();
  return std::max<vtkIdType>(1, std::min(most, numberOfFaces / least));
}

// Calls f(chunk, begin, end) for each chunk of faces, in parallel.
template <typename Function>
void ForEachChunk(vtkIdType numberOfChunks, vtkIdType numberOfFaces, const Function& f)
{
  vtkSMPTools::For(0, numberOfChunks, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        f(chunk, chunk * numberOfFaces / numberOfChunks,
          (chunk + 1) * numberOfFaces / numberOfChunks);
      }
    });
}
}

template <typename GetTags, typename GetStep>
void PatternSelection::SelectFaces(const RefinementMesh& mesh, const PatternFamily& family,
  float offset, int maximumLevel, const GetTags& getTags, const GetStep& getStep)
{
  const bool morphing = family.IsMorphing();
  const RefinementFace* faces = mesh.Faces.data();
  unsigned int* entries = this->Entries.data();
  float* allMorphTags = this->MorphTags.data();
  ForEachChunk(static_cast<vtkIdType>(this->Counts.size()), this->GetNumberOfFaces(),
    [&](vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      int* counts = this->Counts[chunk].data();
      for (vtkIdType f = begin; f < end; ++f)
      {
        const RefinementFace& face = faces[f];
        float tags[3];
        getTags(f, face, tags);
        int steps[3];
        for (int e = 0; e < 3; ++e)
        {
          tags[e] = clampTag(tags[e], offset, maximumLevel);
          steps[e] = getStep(tags[e]);
        }
        const unsigned int entry = family.GetEntry(face.Order, steps[0], steps[1], steps[2]);
        entries[f] = entry;
        ++counts[entry >> 3];
        if (morphing)
        {
          // Assigning all three at once would stall on the store of each.
          float* morphTags = allMorphTags + 3 * f;
          morphTags[0] = morphTag(tags[0], maximumLevel);
          morphTags[1] = morphTag(tags[1], maximumLevel);
          morphTags[2] = morphTag(tags[2], maximumLevel);
        }
      }
    });
}

void PatternSelection::Select(const RefinementMesh& mesh, const EdgeTags& tags,
  const PatternFamily& family, int maximumLevel, float offset)
{
  this->Entries.resize(mesh.Faces.size());
  this->MorphTags.resize(family.IsMorphing() ? 3 * mesh.Faces.size() : 0);
  this->ResizeCounts(family);

  WithFaceTags(tags, maximumLevel,
    [&](const auto& getTags)
    {
      if (family.AreWholeNumbers())
      {
        this->SelectFaces(
          mesh, family, offset, maximumLevel, getTags, &SegmentSteps::GetWholeNumberStep);
      }
      else
      {
        this->SelectFaces(
          mesh, family, offset, maximumLevel, getTags, [](float tag) { return levelOfTag(tag); });
      }
    });
  this->Counted = true;

  this->FindPatterns(family);
}

void PatternSelection::Assign(
  const PatternFamily& family, std::vector<unsigned int> entries, std::vector<float> morphTags)
{
  this->Entries.swap(entries);
  this->MorphTags.swap(morphTags);
  this->ResizeCounts(family);
  this->CountFaces(nullptr);
  this->Counted = true;
  this->FindPatterns(family);
}

void PatternSelection::ResizeCounts(const PatternFamily& family)
{
  this->Counts.resize(
    static_cast<size_t>(GetNumberOfChunks(this->GetNumberOfFaces(), family.GetNumberOfKeys())));
  for (auto& counts : this->Counts)
  {
    counts.assign(static_cast<size_t>(family.GetNumberOfKeys()), 0);
  }
}

void PatternSelection::FindPatterns(const PatternFamily& family)
{
  const int numberOfKeys = family.GetNumberOfKeys();
  this->Patterns.assign(static_cast<size_t>(numberOfKeys), nullptr);
  this->NumberOfTriangles = 0;
  for (int key = 0; key < numberOfKeys; ++key)
  {
    vtkIdType faces = 0;
    for (const auto& counts : this->Counts)
    {
      faces += counts[key];
    }
    if (faces > 0)
    {
      this->Patterns[key] = family.GetPattern(key);
      this->NumberOfTriangles += faces * this->Patterns[key]->GetNumberOfTriangles();
    }
  }
}

void PatternSelection::CountFaces(const unsigned char* hidden)
{
  ForEachChunk(static_cast<vtkIdType>(this->Counts.size()), this->GetNumberOfFaces(),
    [&](vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      std::vector<int>& counts = this->Counts[chunk];
      std::fill(counts.begin(), counts.end(), 0);
      for (vtkIdType f = begin; f < end; ++f)
      {
        counts[this->Entries[f] >> 3] += hidden && hidden[f] ? 0 : 1;
      }
    });
}

void PatternSelection::Group(const unsigned char* hidden)
{
  if (hidden || !this->Counted)
  {
    this->CountFaces(hidden);
  }
  this->Counted = false; // the counts become offsets
  this->Groups.clear();
  int offset = 0;
  for (size_t key = 0; key < this->Patterns.size(); ++key)
  {
    if (!this->Patterns[key])
    {
      continue;
    }
    const int begin = offset;
    for (auto& counts : this->Counts)
    {
      const int size = counts[key];
      counts[key] = offset;
      offset += size;
    }
    if (offset > begin)
    {
      this->Groups.push_back({ this->Patterns[key],
        PatternFamily::IsMirrored(static_cast<int>(key)), begin, offset - begin });
    }
  }
  this->Instances.resize(static_cast<size_t>(offset));
  ForEachChunk(static_cast<vtkIdType>(this->Counts.size()), this->GetNumberOfFaces(),
    [&](vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      int* next = this->Counts[chunk].data();
      for (vtkIdType f = begin; f < end; ++f)
      {
        if (!hidden || !hidden[f])
        {
          const unsigned int entry = this->Entries[f];
          this->Instances[next[entry >> 3]++] = static_cast<unsigned int>(f) << 3 | (entry & 7u);
        }
      }
    });
}

vtkIdType PatternSelection::GetNumberOfGroupedTriangles() const
{
  vtkIdType count = 0;
  for (const PatternGroup& group : this->Groups)
  {
    count += static_cast<vtkIdType>(group.Count) * group.Pattern->GetNumberOfTriangles();
  }
  return count;
}
}
