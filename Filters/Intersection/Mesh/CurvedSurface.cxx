// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurvedSurface.h"

#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <vector>

namespace relevo
{
bool CurvedSurface::Take(
  vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning)
{
  const vtkMTimeType before = this->Surface.GetBuildTime();
  const bool isTaken = this->Surface.Take(mesh, recipe, error, warning);
  this->IsMoved = this->IsMoved && isTaken && this->Surface.GetBuildTime() == before;
  return isTaken;
}

void CurvedSurface::Move(const Motion& motion)
{
  if (this->IsMoved && motion == this->Current)
  {
    return;
  }
  std::vector<DoubleBox> boxes(static_cast<std::size_t>(this->Surface.GetNumberOfFaces()));
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        DoubleBox box;
        this->Surface.GetFaceBounds(static_cast<int>(face), box.Low.data(), box.High.data());
        boxes[face] = motion.MoveBox(box);
      }
    });
  if (this->IsMoved)
  {
    this->Tree.Fit(boxes);
  }
  else
  {
    this->Tree.Build(boxes);
  }
  this->Current = motion;
  this->IsMoved = true;
}
}
