// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PickedRelief.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

#include <cmath>

namespace relevo
{
vtkSmartPointer<vtkStructuredGrid> MakePickedRelief(const Relief& relief, double maximumStretch)
{
  const int width = relief.GetWidth();
  const int height = relief.GetHeight();
  const double plane = relief.GetPlane();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(relief.GetNumberOfTexels());
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          const double texel = relief.GetTexelHeight(column, row);
          const dvec3 point =
            relief.GetWorldPoint(column, row, std::isfinite(texel) ? texel : plane);
          points->SetPoint(static_cast<vtkIdType>(row) * width + column, point.x, point.y, point.z);
        }
      }
    });
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(width, height, 1);
  grid->SetPoints(points);
  const std::vector<unsigned char> sides = FindReliefSides(relief, maximumStretch);
  for (int row = 0; row + 1 < height; ++row)
  {
    for (int column = 0; column + 1 < width; ++column)
    {
      if (!(sides[static_cast<size_t>(row) * width + column] & Quad))
      {
        grid->BlankCell(static_cast<vtkIdType>(row) * (width - 1) + column);
      }
    }
  }
  return grid;
}
}
