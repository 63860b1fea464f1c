// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementPatternTable.h"

#include "Checks/SettingChecks.h"
#include "Patterns/CanonicalOrder.h"
#include "Patterns/PatternBorder.h"
#include "Patterns/PatternLibrary.h"
#include "Patterns/PatternStore.h"
#include "Patterns/RefinementPattern.h"
#include "Patterns/RefinementPatternFile.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

static_assert(vtkRefinementPatternTable::HighestLevel == relevo::HighestLevel, "one limit");

vtkStandardNewMacro(vtkRefinementPatternTable);

vtkRefinementPatternTable::vtkRefinementPatternTable()
  : Library(std::make_shared<const relevo::PatternLibrary>())
{
}

vtkRefinementPatternTable::~vtkRefinementPatternTable() = default;

vtkSmartPointer<vtkRefinementPatternTable> vtkRefinementPatternTable::MakeDefault()
{
  auto table = vtkSmartPointer<vtkRefinementPatternTable>::New();
  table->Library =
    std::make_shared<const relevo::PatternLibrary>(relevo::PatternStore::GetShared());
  table->SetMaximumLevel(HighestLevel);
  return table;
}

void vtkRefinementPatternTable::SetMaximumLevel(int level)
{
  const int highest = this->Library->GetHighestLevel();
  if (relevo::CheckRange(this, "MaximumLevel", level, 0, highest,
        highest < HighestLevel ? " The file of the patterns has no higher level." : "") &&
    (this->MaximumLevel != level || this->HighestOfRecipes != level))
  {
    this->MaximumLevel = this->HighestOfRecipes = level;
    this->Modified();
  }
}

int vtkRefinementPatternTable::GetNumberOfPatterns()
{
  return vtkRefinementPatternTable::GetPatternIndex(this->MaximumLevel + 1, 0, 0);
}

int vtkRefinementPatternTable::Canonicalize(int ijk[3])
{
  return relevo::Canonicalize(ijk);
}

void vtkRefinementPatternTable::GetPermutation(int lambda, int permutation[3])
{
  relevo::GetPermutation(lambda, permutation);
}

bool vtkRefinementPatternTable::IsOdd(int lambda)
{
  return relevo::IsOdd(lambda);
}

int vtkRefinementPatternTable::GetPatternIndex(int i, int j, int k)
{
  return relevo::GetPatternIndex(i, j, k);
}

std::shared_ptr<const relevo::RefinementPattern> vtkRefinementPatternTable::GetPatternOfSegments(
  int n1, int n2, int n3)
{
  if (n1 < n2 || n2 < n3 || n3 < 1 || n1 > relevo::MaximumNumberOfSegments)
  {
    vtkErrorMacro("There is no pattern of "
      << n1 << ", " << n2 << ", " << n3
      << " segments: the numbers must be in descending order and in [1, "
      << relevo::MaximumNumberOfSegments << "].");
    n1 = n2 = n3 = 1;
  }
  return this->Library->GetPatternOfSegments(n1, n2, n3);
}

bool vtkRefinementPatternTable::GetPattern(int i, int j, int k, vtkPolyData* output)
{
  if (!output)
  {
    vtkErrorMacro("GetPattern() needs a vtkPolyData for its output, but it is null.");
    return false;
  }
  int levels[3] = { i, j, k };
  if (*std::min_element(levels, levels + 3) < 0 ||
    *std::max_element(levels, levels + 3) > this->MaximumLevel)
  {
    vtkErrorMacro("There is no pattern [" << i << ", " << j << ", " << k
                                          << "]: levels must be in [0, " << this->MaximumLevel
                                          << "], up to MaximumLevel.");
    return false;
  }
  const int lambda = vtkRefinementPatternTable::Canonicalize(levels);
  const auto made = this->GetPatternOfSegments(1 << levels[0], 1 << levels[1], 1 << levels[2]);
  const relevo::RefinementPattern& pattern = *made;
  int permutation[3];
  vtkRefinementPatternTable::GetPermutation(lambda, permutation);

  const vtkIdType numberOfPoints = pattern.GetNumberOfVertices();
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkFloatArray> barycentrics;
  barycentrics->SetName("Barycentrics");
  barycentrics->SetNumberOfComponents(3);
  barycentrics->SetComponentName(0, "u");
  barycentrics->SetComponentName(1, "v");
  barycentrics->SetComponentName(2, "w");
  barycentrics->SetNumberOfTuples(numberOfPoints);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    float weights[3];
    for (int c = 0; c < 3; ++c)
    {
      weights[c] = pattern.Vertices[3 * p + permutation[c]];
    }
    barycentrics->SetTypedTuple(p, weights);
    points->SetPoint(p, weights[1], weights[2], 0.0);
  }

  const bool odd = vtkRefinementPatternTable::IsOdd(lambda);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateEstimate(pattern.GetNumberOfTriangles(), 3);
  for (std::size_t t = 0; t < pattern.Triangles.size(); t += 3)
  {
    const unsigned int* triangle = &pattern.Triangles[t];
    const vtkIdType ids[3] = { triangle[0], triangle[odd ? 2 : 1], triangle[odd ? 1 : 2] };
    triangles->InsertNextCell(3, ids);
  }

  output->Initialize();
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(barycentrics);
  return true;
}

vtkTypeInt64 vtkRefinementPatternTable::GetMemorySize()
{
  return this->Library->GetMemorySize();
}

bool vtkRefinementPatternTable::Write(const char* fileName)
{
  relevo::RefinementPatterns patterns;
  for (int i = 0; i <= this->MaximumLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        patterns.push_back(this->GetPatternOfSegments(1 << i, 1 << j, 1 << k));
      }
    }
  }
  const std::string error = relevo::WritePatterns(fileName, this->MaximumLevel, patterns);
  if (!error.empty())
  {
    vtkErrorMacro("Cannot write the patterns: " << error);
    return false;
  }
  return true;
}

bool vtkRefinementPatternTable::Read(const char* fileName)
{
  int maximumLevel = 0;
  std::vector<relevo::RefinementPattern> patterns;
  const std::string error = relevo::ReadPatterns(fileName, maximumLevel, patterns);
  if (!error.empty())
  {
    vtkErrorMacro("Cannot read the patterns: " << error);
    return false;
  }
  this->Library = std::make_shared<const relevo::PatternLibrary>(
    std::string(fileName), maximumLevel, std::move(patterns));
  this->MaximumLevel = this->HighestOfRecipes = maximumLevel;
  this->Modified();
  return true;
}

void vtkRefinementPatternTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "NumberOfPatterns: " << this->GetNumberOfPatterns() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}
