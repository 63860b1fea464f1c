// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveRadii.h"

#include "Arrays/PointArray.h"
#include "vtkDataArray.h"
#include "vtkPointSet.h"

namespace relevo
{
vtkDataArray* FindCurveRadii(vtkPointSet* input, const std::string& name, std::string& error)
{
  std::string reason;
  vtkDataArray* radii = FindPointArray(input, name, 1, reason);
  for (vtkIdType i = 0; radii && i < input->GetNumberOfPoints(); ++i)
  {
    if (radii->GetComponent(i, 0) < 0.0)
    {
      reason = "point array \"" + name + "\" is negative at point " + std::to_string(i);
      radii = nullptr;
    }
  }
  if (!radii)
  {
    error = "Cannot read the radii: " + reason + ".";
  }
  return radii;
}
}
