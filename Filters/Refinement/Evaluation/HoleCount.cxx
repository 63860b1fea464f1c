// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/HoleCount.h"

#include "Evaluation/HoleFinder.h"
#include "Evaluation/PatternSelection.h"
#include "Patterns/RefinementPattern.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <vector>

namespace relevo
{
vtkIdType CountHoles(const RefinementMesh& mesh, const PatternSelection& selection,
  const HeightValidity& validity, const unsigned char* hidden)
{
  if (!validity.Samples)
  {
    return 0;
  }
  const HoleFinder holeFinder(mesh, validity);
  std::atomic<vtkIdType> count(0);
  vtkSMPTools::For(0, selection.GetNumberOfFaces(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<unsigned char> out;
      vtkIdType holes = 0;
      for (int face = static_cast<int>(begin); face < end; ++face)
      {
        if (hidden && hidden[face])
        {
          continue;
        }
        const FacePattern pattern = selection.GetFacePattern(face);
        out.resize(static_cast<size_t>(pattern.Pattern->GetNumberOfTriangles()));
        holes += holeFinder.Find(face, pattern, out.data());
      }
      count += holes;
    });
  return count;
}
}
