// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternSelection.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkDataArray.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointPlaces.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementMesh.h"
#include "vtkRefinementPattern.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRefinementView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace relevo
{
#include "glsl/relevoLevels.glsl"

namespace
{
constexpr int Levels = vtkRefinementPatternTable::HighestLevel + 1;
constexpr int NumberOfKeys = 2 * Levels * (Levels + 1) * (Levels + 2) / 6;

// For an order of a face's corners and the levels of its sorted edges (0,1), (1,2), (0,2): the
// group (pattern * 2 + mirrored) << 3 | permutation code.
class SelectionTable
{
public:
  SelectionTable()
  {
    for (int code = 0; code < 6; ++code)
    {
      for (int l01 = 0; l01 < Levels; ++l01)
      {
        for (int l12 = 0; l12 < Levels; ++l12)
        {
          for (int l02 = 0; l02 < Levels; ++l02)
          {
            this->Entries[Index(code, l01, l12, l02)] = MakeEntry(code, l01, l12, l02);
          }
        }
      }
    }
  }

  unsigned short Get(int code, int l01, int l12, int l02) const
  {
    return this->Entries[Index(code, l01, l12, l02)];
  }

private:
  static int Index(int code, int l01, int l12, int l02)
  {
    return ((code * Levels + l01) * Levels + l12) * Levels + l02;
  }

  static unsigned short MakeEntry(int code, int l01, int l12, int l02)
  {
    // Sorted corner j is the cell's corner order[j]; the edge that lacks sorted corner j is known
    // by its level lacking[j], and the cell's edge i lacks its corner i + 2.
    const auto& order = GetCornerOrder(code);
    const int lacking[3] = { l12, l02, l01 };
    int levels[3];
    for (int j = 0; j < 3; ++j)
    {
      levels[(order[j] + 1) % 3] = lacking[j];
    }
    const int lambda = vtkRefinementPatternTable::Canonicalize(levels);
    int permutation[3];
    vtkRefinementPatternTable::GetPermutation(lambda, permutation);
    const int pattern = vtkRefinementPatternTable::GetPatternIndex(levels[0], levels[1], levels[2]);
    const int group = 2 * pattern + (vtkRefinementPatternTable::IsOdd(lambda) ? 1 : 0);
    return static_cast<unsigned short>(group << 3 |
      GetCornerOrderCode(permutation[order[0]], permutation[order[1]], permutation[order[2]]));
  }

  std::array<unsigned short, 6 * Levels * Levels * Levels> Entries;
};

const SelectionTable& GetSelectionTable()
{
  static const SelectionTable table;
  return table;
}

vtkAbstractArray* FindDepthTagArray(vtkAdaptiveRefinement* recipe, vtkPolyData* input)
{
  const char* name = recipe->GetDepthTagArrayName();
  return name[0] ? input->GetPointData()->GetAbstractArray(name) : nullptr;
}

// One finite value per point; false and an error when the array cannot give them.
bool ReadDepthTags(
  vtkAbstractArray* array, vtkIdType numberOfPoints, std::vector<float>& tags, std::string& error)
{
  std::ostringstream text;
  text << "point array \"" << array->GetName() << "\" of depth-tags ";
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
  {
    text << "holds no numbers";
    error = text.str();
    return false;
  }
  if (numbers->GetNumberOfComponents() != 1 || numbers->GetNumberOfTuples() != numberOfPoints)
  {
    text << "has " << numbers->GetNumberOfTuples() << " tuples of "
         << numbers->GetNumberOfComponents() << " components for " << numberOfPoints
         << " points; it needs one value per point";
    error = text.str();
    return false;
  }
  tags.resize(static_cast<size_t>(numberOfPoints));
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    const double tag = numbers->GetComponent(i, 0);
    if (std::isnan(tag))
    {
      text << "is NaN at point " << i;
      error = text.str();
      return false;
    }
    constexpr double most = 1e38; // means of two stay finite
    tags[static_cast<size_t>(i)] = static_cast<float>(std::min(std::max(tag, -most), most));
  }
  return true;
}
}

vtkDepthTagMetric* GetMetricInUse(vtkAdaptiveRefinement* recipe, vtkPolyData* input)
{
  return FindDepthTagArray(recipe, input) ? nullptr : recipe->GetMetric();
}

bool ComputeDepthTags(vtkAdaptiveRefinement* recipe, vtkPolyData* input, const RefinementMesh& mesh,
  const vtkRefinementView& view, std::vector<float>& tags, std::string& error)
{
  tags.clear();
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  if (vtkAbstractArray* array = FindDepthTagArray(recipe, input))
  {
    if (!ReadDepthTags(array, numberOfPoints, tags, error))
    {
      return false;
    }
  }
  else if (vtkDepthTagMetric* metric = recipe->GetMetric())
  {
    vtkNew<vtkFloatArray> values;
    if (!metric->ComputeTags(input, view, recipe->GetMaximumLevel(), values))
    {
      error = std::string(metric->GetClassName()) + " gave no depth-tags";
      return false;
    }
    values->SetName(metric->GetClassName());
    if (!ReadDepthTags(values, numberOfPoints, tags, error))
    {
      return false;
    }
  }
  if (!tags.empty() && !mesh.Places.empty())
  {
    UniteTags(mesh.Places, tags.data());
  }
  return true;
}

void PatternSelection::Select(
  const RefinementMesh& mesh, const std::vector<float>& tags, int maximumLevel)
{
  const SelectionTable& table = GetSelectionTable();
  const vtkIdType numberOfFaces = static_cast<vtkIdType>(mesh.Faces.size());
  this->Keys.resize(static_cast<size_t>(numberOfFaces));
  this->Instances.resize(static_cast<size_t>(numberOfFaces));
  this->Groups.clear();

  // A counting sort over chunks, so that counting and scattering run in parallel.
  const vtkIdType numberOfChunks =
    std::max<vtkIdType>(1, std::min<vtkIdType>(64, numberOfFaces / 4096));
  std::vector<std::array<int, NumberOfKeys>> counts(static_cast<size_t>(numberOfChunks));
  auto chunkBegin = [&](vtkIdType chunk) { return chunk * numberOfFaces / numberOfChunks; };
  vtkSMPTools::For(0, numberOfChunks, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        auto& count = counts[chunk];
        count.fill(0);
        for (vtkIdType f = chunkBegin(chunk); f < chunkBegin(chunk + 1); ++f)
        {
          const RefinementFace& face = mesh.Faces[f];
          int l01 = maximumLevel;
          int l12 = maximumLevel;
          int l02 = maximumLevel;
          if (!tags.empty())
          {
            const float t0 = tags[face.Corners[0]];
            const float t1 = tags[face.Corners[1]];
            const float t2 = tags[face.Corners[2]];
            l01 = edgeLevel(t0, t1, maximumLevel);
            l12 = edgeLevel(t1, t2, maximumLevel);
            l02 = edgeLevel(t0, t2, maximumLevel);
          }
          const unsigned short key = table.Get(face.Order, l01, l12, l02);
          this->Keys[f] = key;
          ++count[key >> 3];
        }
      }
    });

  int offset = 0;
  int key = 0;
  for (int i = 0; i < Levels; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        for (int mirrored = 0; mirrored < 2; ++mirrored, ++key)
        {
          const int begin = offset;
          for (auto& count : counts)
          {
            const int size = count[key];
            count[key] = offset;
            offset += size;
          }
          if (offset > begin)
          {
            this->Groups.push_back({ { i, j, k }, mirrored == 1, begin, offset - begin });
          }
        }
      }
    }
  }
  vtkSMPTools::For(0, numberOfChunks, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        auto& next = counts[chunk];
        for (vtkIdType f = chunkBegin(chunk); f < chunkBegin(chunk + 1); ++f)
        {
          this->Instances[next[this->Keys[f] >> 3]++] =
            static_cast<unsigned int>(f) << 3 | (this->Keys[f] & 7u);
        }
      }
    });
}

vtkIdType PatternSelection::GetNumberOfTriangles(vtkRefinementPatternTable* table) const
{
  vtkIdType count = 0;
  for (const PatternGroup& group : this->Groups)
  {
    count +=
      static_cast<vtkIdType>(group.Count) * GetGroupPattern(table, group).GetNumberOfTriangles();
  }
  return count;
}

const vtkRefinementPattern& GetGroupPattern(
  vtkRefinementPatternTable* table, const PatternGroup& group)
{
  return table->GetPatternOfSegments(
    1 << group.Levels[0], 1 << group.Levels[1], 1 << group.Levels[2]);
}
}
