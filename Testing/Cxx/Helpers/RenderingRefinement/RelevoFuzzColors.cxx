// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFuzzColors.h"

#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVariant.h"

namespace RelevoFuzz
{
vtkSmartPointer<vtkScalarsToColors> MakeLookupTable(Dice& dice)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(dice.Choose(std::vector<int>{ 0, 1, 2, 3, 7, 255, 256, 1000 }));
  table->SetAlphaRange(dice.Once(3) ? dice.Share() : 1.0, 1.0);
  table->SetTableRange(dice.Number(), dice.Number());
  table->SetUseBelowRangeColor(dice.Throw(2));
  table->SetUseAboveRangeColor(dice.Throw(2));
  dice.Once(4) ? table->SetScaleToLog10() : table->SetScaleToLinear();
  dice.Once(2) ? table->Build() : void();
  return table;
}

vtkSmartPointer<vtkScalarsToColors> MakeColorFunction(Dice& dice)
{
  auto function = vtkSmartPointer<vtkDiscretizableColorTransferFunction>::New();
  for (int i = dice.Throw(4); i > 0; --i)
  {
    function->AddRGBPoint(3.0 * dice.Share() - 1.0, dice.Share(), dice.Share(), dice.Share());
  }
  function->SetColorSpace(dice.Throw(5));
  function->SetDiscretize(dice.Throw(2));
  function->SetNumberOfValues(1 + dice.Throw(9));
  if (dice.Once(3))
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, dice.Share());
    opacity->AddPoint(1.0, dice.Share());
    function->SetScalarOpacityFunction(opacity);
    function->EnableOpacityMappingOn();
  }
  dice.Once(2) ? function->Build() : void();
  return function;
}

vtkSmartPointer<vtkScalarsToColors> MakeTable(Dice& dice)
{
  const int kind = dice.Throw(8);
  if (kind == 0)
  {
    return nullptr;
  }
  auto table = kind < 5 ? MakeLookupTable(dice)
    : kind < 7          ? MakeColorFunction(dice)
                        : vtkSmartPointer<vtkScalarsToColors>::New();
  table->SetVectorMode(dice.Throw(3));
  table->SetVectorComponent(dice.Throw(5) - 1);
  table->SetVectorSize(dice.Throw(5) - 1);
  if (dice.Once(4))
  {
    table->SetIndexedLookup(true);
    for (int i = dice.Throw(3); i > 0; --i)
    {
      table->SetAnnotation(dice.Once(2) ? vtkVariant(i) : vtkVariant("name"), "category");
    }
  }
  return table;
}

vtkSmartPointer<vtkTexture> MakeTexture(Dice& dice)
{
  if (dice.Once(3))
  {
    return nullptr;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInterpolate(dice.Throw(2));
  texture->SetMipmap(dice.Throw(2));
  texture->SetRepeat(dice.Throw(2));
  if (dice.Once(10))
  {
    return texture;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(1 + dice.Throw(7), 1 + dice.Throw(7), 1);
  image->AllocateScalars(dice.Once(4) ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 1 + dice.Throw(4));
  image->GetPointData()->GetScalars()->Fill(dice.Throw(2));
  texture->SetInputData(image);
  return texture;
}
}
