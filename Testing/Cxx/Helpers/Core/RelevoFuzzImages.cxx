// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFuzzImages.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

namespace RelevoFuzz
{
vtkSmartPointer<vtkImageData> MakeImage(Dice& dice)
{
  static const std::vector<int> sides = { 0, 1, 2, 3, 5, 8, 16, 16 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  int size[3] = { dice.Choose(sides), dice.Choose(sides), dice.Once(10) ? 2 : 1 };
  std::swap(size[2], size[dice.Once(3) ? dice.Throw(3) : 2]);
  image->SetDimensions(size);
  if (dice.Once(4))
  {
    image->SetSpacing(dice.Number(), dice.Number(), dice.Number());
    image->SetOrigin(dice.Number(), dice.Number(), dice.Number());
  }
  AddArrays(dice, image->GetPointData(), image->GetNumberOfPoints());
  AddArrays(dice, image->GetCellData(), image->GetNumberOfCells());
  return image;
}
}
