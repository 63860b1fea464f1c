// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBounds.h"

#include "Parallel/ProcessReduction.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <vector>

namespace relevo
{
vtkStandardNewMacro(SceneBounds);

void SceneBounds::Set(vtkRenderer* renderer, vtkMultiProcessController* controller)
{
  this->Clear();
  double own[6];
  renderer->ComputeVisiblePropBounds(own);
  std::vector<double> sides(6, -VTK_DOUBLE_MAX); // -xmin, xmax, ...
  for (int side = 0; side < 6 && own[0] <= own[1]; ++side)
  {
    sides[static_cast<std::size_t>(side)] = side % 2 == 0 ? -own[side] : own[side];
  }
  ProcessReduction(controller).TakeLargest(sides);
  for (int side = 0; side < 6; ++side)
  {
    const double value = sides[static_cast<std::size_t>(side)];
    this->Bounds[side] = side % 2 == 0 ? -value : value;
  }
  this->HasBounds = this->Bounds[0] <= this->Bounds[1];
}
}
