// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/LICVectorField.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace relevo
{
void LICVectorField::Update(const Input& input)
{
  Dependencies sources = Dependencies::On(input.BuildTime, input.NoDataMagnitude);
  for (vtkPolyData* mesh : input.Meshes)
  {
    sources.AddObject(mesh);
  }
  if (!this->Sources.Update(sources))
  {
    return;
  }
  LICVectorFacts facts;
  std::string misplaced;
  for (vtkPolyData* mesh : input.Meshes)
  {
    if (mesh->GetNumberOfPolys() == 0 && mesh->GetNumberOfStrips() == 0)
    {
      continue;
    }
    facts.HasFaces = true;
    const LICArray vectors = input.FindArray(mesh);
    facts.Error = facts.Error.empty() ? vectors.Error : facts.Error;
    facts.HasArray = facts.HasArray || vectors.Array;
    if (!vectors.Array && misplaced.empty())
    {
      misplaced = input.DescribeMisplaced(mesh);
    }
    facts.Longest = std::max(facts.Longest, vectors.FindLongest(input.NoDataMagnitude));
  }
  this->Own = facts;
  this->Misplaced = misplaced;
}

std::string LICVectorField::FindError() const
{
  const LICVectorFacts& facts = this->All;
  if (facts.Error.empty() && facts.HasFaces && !facts.HasArray)
  {
    return this->Misplaced.empty()
      ? "The input does not have the array of vectors that SetInputArrayToProcess(0, ...), in "
        "ParaView SelectInputVectors, selects."
      : "The input has " + this->Misplaced + ".";
  }
  if (facts.Error.empty() && facts.HasFaces && facts.Longest < 0.0)
  {
    return "All vectors are missing values: not finite, or with a component of at least "
           "NoDataMagnitude.";
  }
  return facts.Error;
}
}
