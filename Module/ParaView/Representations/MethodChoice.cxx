// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MethodChoice.h"

#include "vtkAdaptiveRefinementMapper.h"

namespace relevo
{
namespace
{
enum VolumeMethod
{
  RayCasting = 100,
  CellProjection
};

bool IsRefinementMethod(int method)
{
  return method >= vtkAdaptiveRefinementMapper::METHOD_ARKFPI &&
    method <= vtkAdaptiveRefinementMapper::METHOD_UNIFORM;
}
}

void SetMethod(vtkObject* representation, int& member, int method)
{
  if (!IsRefinementMethod(method) && method != RayCasting && method != CellProjection)
  {
    vtkErrorWithObjectMacro(representation,
      "Method is " << method
                   << ", but it must be 0 to 5, 100 (Ray Casting) or 101 (Cell Projection).");
  }
  else if (member != method)
  {
    member = method;
    representation->Modified();
  }
}

int GetRefinementMethod(int method)
{
  return IsRefinementMethod(method) ? method : vtkAdaptiveRefinementMapper::METHOD_ARKFPI;
}

bool IsCellProjection(int method)
{
  return method == CellProjection;
}
}
